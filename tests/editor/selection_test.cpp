#include "editor/selection.h"

#include <gtest/gtest.h>

#include "support/wall_chain.h"

namespace idap {
namespace {

struct Home3 : testing::Test {
  Home3() {
    for (FurnitureId& id : ids) {
      id = home.newId<FurnitureId>();
      Furniture piece;
      piece.position = {double(id.value), 0, 0};
      piece.size = {0.5, 0.5, 1};
      home.furniture.set(id, piece);
    }
  }
  GroupId group(const Elements& elements) {
    const GroupEdit edit = groupElements(home, elements, "group");
    home = edit.home;
    return edit.group;
  }
  Home home;
  FurnitureId ids[3];
};

TEST(Selection, KeepsIdsInOrderAndOnce) {
  Elements elements;
  for (const std::uint64_t id : {5u, 2u, 9u, 2u}) add(elements, FurnitureId{id});
  add(elements, WallId{1});
  EXPECT_EQ(elements.furniture, (std::vector<FurnitureId>{{2}, {5}, {9}}));
  EXPECT_EQ(count(elements), 4u);
  EXPECT_TRUE(contains(elements, FurnitureId{5}));
  EXPECT_FALSE(contains(elements, WallId{5}));
  remove(elements, FurnitureId{5});
  EXPECT_FALSE(contains(elements, FurnitureId{5}));
  EXPECT_EQ(list(elements).size(), 3u);
  EXPECT_FALSE(single(elements));
  EXPECT_EQ(single(only(LabelId{3})), AnyId(LabelId{3}));
  EXPECT_TRUE(empty(Elements{}));
}

TEST_F(Home3, PrunedDropsWhatIsGone) {
  Elements elements;
  elements.furniture = {ids[2], {999}, ids[0], ids[0]};
  elements.walls = {{998}};
  const Elements left = pruned(home, elements);
  EXPECT_EQ(left.furniture, (std::vector<FurnitureId>{ids[0], ids[2]}));
  EXPECT_TRUE(left.walls.empty());
}

TEST_F(Home3, GroupStandsForItsMembers) {
  Elements two;
  two.furniture = {ids[0], ids[1]};
  const GroupId inner = group(two);
  Elements more = only(inner);
  more.furniture = {ids[2]};
  const GroupId outer = group(more);
  EXPECT_EQ(byGroup(home, ids[0]), AnyId(outer));
  EXPECT_EQ(outermost(home, inner), outer);
  Elements both = only(outer);
  both.furniture = {ids[0]};
  both.groups.push_back(inner);
  const Elements left = pruned(home, both);
  EXPECT_TRUE(left.furniture.empty());
  EXPECT_EQ(left.groups, std::vector<GroupId>{outer});
  EXPECT_EQ(pruned(home, only(ids[0])).furniture.size(), 1u);  // gone into the group
  const Elements all = everything(home, {});
  EXPECT_EQ(list(all), (std::vector<AnyId>{outer}));
  const Box3 box = bounds(home, only(outer));
  EXPECT_NEAR(box.min.x, 1 - 0.25, 1e-9);
  EXPECT_NEAR(box.max.x, 3 + 0.25, 1e-9);
}

TEST_F(Home3, FollowsPiecesIntoTheirNewGroup) {
  Elements two;
  two.furniture = {ids[0], ids[1]};
  const Home before = home;
  const GroupId made = group(two);
  EXPECT_EQ(list(followed(before, home, two)), (std::vector<AnyId>{made}));
}

TEST_F(Home3, EverythingIsOfOneLevel) {
  Wall wall = test::wall({0, 0}, {3, 0});
  const auto upper = home.newId<LevelId>();
  home.levels.set(upper, Level{});
  wall.level = upper;
  const auto id = home.newId<WallId>();
  home.walls.set(id, wall);
  EXPECT_EQ(list(everything(home, upper)), (std::vector<AnyId>{id}));
  EXPECT_EQ(count(everything(home, {})), 4u);
}

}  // namespace
}  // namespace idap
