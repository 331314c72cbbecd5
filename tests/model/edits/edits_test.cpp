#include <gtest/gtest.h>

#include <random>

#include "base/error.h"
#include "model/diff.h"
#include "model/document.h"
#include "model/edits/element_edits.h"
#include "model/edits/wall_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

// Of the small flat: walls 1..4 around (6 x 4, counter-clockwise from the origin), 5 across at x = 3.
constexpr WallId kBottom{1}, kRight{2}, kTop{3}, kLeft{4}, kMiddle{5};
constexpr OpeningId kDoor{6}, kWindow{7};
constexpr GroupId kDining{8};
constexpr FurnitureId kTable{9};

void expectNear(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}
Vec2 placeOf(const Home& home, OpeningId id) {
  const Vec3 p = home.openings.find(id)->position;
  return {p.x, p.y};
}

TEST(WallEdits, AnAddedWallJoinsTheFreeEndsItMeets) {
  Wall first, second;
  first.end = {4, 0};
  second.start = {4, 0.0005};
  second.end = {4, 3};
  const WallEdit one = addWall(Home{}, first);
  const WallEdit two = addWall(one.home, second);
  EXPECT_EQ(two.home.walls.find(one.wall)->neighbourAtEnd, two.wall);
  EXPECT_EQ(two.home.walls.find(two.wall)->neighbourAtStart, one.wall);
  EXPECT_FALSE(two.home.walls.find(two.wall)->neighbourAtEnd);
  EXPECT_NO_THROW(requireValid(two.home));
  Wall third;
  third.start = {4, 0};
  third.end = {8, 0};
  EXPECT_FALSE(addWall(two.home, third).home.walls.find(WallId{3})->neighbourAtStart)
      << "both ends are taken";
}

TEST(WallEdits, MovingACornerTakesTheNeighbourAlong) {
  const Home home = test::smallFlat();
  const Home moved = moveWallEnd(home, kBottom, WallEnd::End, {8, 0});
  expectNear(moved.walls.find(kBottom)->end, {8, 0});
  expectNear(moved.walls.find(kRight)->start, {8, 0});
  expectNear(moved.walls.find(kRight)->end, {6, 4});
  expectNear(placeOf(moved, kWindow), {4.5, 0});
  EXPECT_EQ(moved.openings.find(kWindow)->angle, 0);
  EXPECT_NO_THROW(requireValid(moved, home));
  EXPECT_THROW(moveWallEnd(home, WallId{99}, WallEnd::End, {}), InvalidHome);
}

TEST(WallEdits, AWindowTurnsWithItsWallAndStaysInIt) {
  const Home home = test::smallFlat();
  const Home turned = moveWallEnd(home, kBottom, WallEnd::End, {0, -6});
  expectNear(placeOf(turned, kWindow), {0, -4.5});
  EXPECT_NEAR(turned.openings.find(kWindow)->angle, -kPi / 2, 1e-12);
  const Home shorter = moveWallEnd(home, kBottom, WallEnd::End, {2, 0});
  expectNear(placeOf(shorter, kWindow), {1.4, 0});  // its half width from the end
}

TEST(WallEdits, SplittingKeepsShapeJointsAndDoors) {
  const Home home = test::smallFlat();
  const WallEdit split = splitWall(home, kBottom, 4);
  const Wall& first = *split.home.walls.find(kBottom);
  const Wall& second = *split.home.walls.find(split.wall);
  expectNear(first.end, {4, 0});
  expectNear(second.start, {4, 0});
  EXPECT_EQ(first.neighbourAtEnd, split.wall);
  EXPECT_EQ(second.neighbourAtStart, kBottom);
  EXPECT_EQ(second.neighbourAtEnd, kRight);
  EXPECT_EQ(split.home.walls.find(kRight)->neighbourAtStart, split.wall);
  EXPECT_EQ(split.home.walls.find(kLeft)->neighbourAtEnd, kBottom);
  EXPECT_EQ(split.home.openings.find(kWindow)->wall, split.wall);
  EXPECT_NO_THROW(requireValid(split.home, home));
  EXPECT_EQ(closedAreas(split.home, {}).size(), 2u);
  EXPECT_THROW(splitWall(home, kBottom, 0), InvalidHome);
  EXPECT_THROW(splitWall(home, kBottom, 6), InvalidHome);

  Home round = home;
  Wall arc = *home.walls.find(kBottom);
  arc.arcExtent = 1;
  arc.heightAtEnd = 1.5;
  round.walls.set(kBottom, arc);
  const WallEdit halves = splitWall(round, kBottom, 2);
  EXPECT_NEAR(halves.home.walls.find(kBottom)->arcExtent + halves.home.walls.find(halves.wall)->arcExtent, 1,
              1e-12);
  EXPECT_EQ(halves.home.walls.find(kBottom)->heightAtEnd, halves.home.walls.find(halves.wall)->heightAtStart);
}

TEST(ElementEdits, DeletingAWallTakesItsDoorAndFreesItsNeighbours) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.walls = {kBottom, WallId{99}};
  const Home left = deleteElements(home, chosen);
  EXPECT_FALSE(left.walls.contains(kBottom));
  EXPECT_FALSE(left.openings.contains(kWindow));
  EXPECT_TRUE(left.openings.contains(kDoor));
  EXPECT_FALSE(left.walls.find(kRight)->neighbourAtStart);
  EXPECT_EQ(left.walls.find(kRight)->neighbourAtEnd, kTop);
  EXPECT_NO_THROW(requireValid(left, home));
}

TEST(ElementEdits, DeletingTheLastMemberDeletesTheGroup) {
  const Home home = test::smallFlat();
  Elements table, group;
  table.furniture = {kTable};
  EXPECT_TRUE(deleteElements(home, table).groups.empty());
  group.groups = {kDining};
  EXPECT_TRUE(deleteElements(home, group).furniture.empty());
}

TEST(ElementEdits, MovingAWallTakesItsDoorsAndStretchesWhatIsJoined) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.walls = {kBottom};
  const Home moved = moveElements(home, chosen, {0, -1, 0});
  expectNear(moved.walls.find(kBottom)->start, {0, -1});
  expectNear(moved.walls.find(kRight)->start, {6, -1});
  expectNear(moved.walls.find(kRight)->end, {6, 4});
  expectNear(moved.walls.find(kLeft)->end, {0, -1});
  expectNear(placeOf(moved, kWindow), {4.5, -1});
  expectNear(moved.walls.find(kMiddle)->start, {3, -1});  // it ends on the one that moved
  EXPECT_NO_THROW(requireValid(moved, home));
}

TEST(ElementEdits, AWholeFlatMovesAndTurnsAsOne) {
  const Home home = test::smallFlat();
  Elements all;
  all.walls = {kBottom, kRight, kTop, kLeft, kMiddle};
  all.openings = {kDoor, kWindow};
  all.groups = {kDining};
  const Home turned = turnElements(home, all, {0, 0}, kPi / 2);
  expectNear(turned.walls.find(kBottom)->end, {0, 6});
  expectNear(placeOf(turned, kDoor), {-1, 3});
  expectNear(placeOf(turned, kWindow), {0, 4.5});
  const Furniture& table = *turned.furniture.find(kTable);
  EXPECT_NEAR(table.position.x, -2, 1e-9);
  EXPECT_NEAR(table.angle, kPi / 2, 1e-12);
  const auto before = closedAreas(home, {}), after = closedAreas(turned, {});
  ASSERT_EQ(before.size(), after.size());
  EXPECT_NEAR(signedArea(before[0]), signedArea(after[0]), 1e-6);
  const Home back = moveElements(moveElements(home, all, {1, 2, 0.5}), all, {-1, -2, -0.5});
  expectNear(placeOf(back, kDoor), placeOf(home, kDoor));
  EXPECT_EQ(back.furniture.find(kTable)->position, home.furniture.find(kTable)->position);
}

TEST(ElementEdits, MovingOnePieceChangesOnePiece) {
  const Home home = test::manyPieces(1000);
  Elements one;
  one.furniture = {FurnitureId{500}};
  const HomeDiff d = diff(home, moveElements(home, one, {0.1, 0, 0}));
  EXPECT_EQ(d.furniture.changed, one.furniture);
  EXPECT_TRUE(d.walls.empty() && d.furniture.added.empty() && d.furniture.removed.empty());
}

TEST(ElementEdits, GroupsNestAndDissolve) {
  Home home = test::manyPieces(4);
  Elements pair;
  pair.furniture = {FurnitureId{1}, FurnitureId{2}};
  const GroupEdit inner = groupElements(home, pair, "Pair");
  Elements more;
  more.groups = {inner.group};
  more.furniture = {FurnitureId{3}};
  const GroupEdit outer = groupElements(inner.home, more, "Set");
  EXPECT_EQ(outer.home.groups.find(inner.group)->parent, outer.group);
  EXPECT_NO_THROW(requireValid(outer.home));
  Elements whole;
  whole.groups = {outer.group};
  EXPECT_EQ(withGroups(outer.home, whole).furniture.size(), 3u);
  EXPECT_EQ(moveElements(outer.home, whole, {0, 0, 1}).furniture.find(FurnitureId{1})->position.z, 1);
  const Home flat = ungroup(outer.home, outer.group);
  EXPECT_FALSE(flat.groups.find(inner.group)->parent);
  EXPECT_FALSE(flat.furniture.find(FurnitureId{3})->group);
  EXPECT_EQ(flat.furniture.find(FurnitureId{1})->group, inner.group);
  EXPECT_THROW(groupElements(home, {}, "Nothing"), InvalidHome);
  EXPECT_THROW(ungroup(home, GroupId{99}), InvalidHome);
}

TEST(ElementEdits, ARoomFillsTheAreaAroundAPoint) {
  const RoomEdit edit = addRoomAt(test::smallFlat(), {}, {1, 1}, "Bedroom");
  EXPECT_NEAR(floorArea(*edit.home.rooms.find(edit.room)), 2.85 * 3.8, 1e-6);
  EXPECT_NO_THROW(requireValid(edit.home));
  EXPECT_THROW(addRoomAt(test::smallFlat(), {}, {-5, 1}), InvalidHome);
}

TEST(Edits, AnySequenceKeepsTheHomeValidAndCanBeUndone) {
  std::mt19937 random(9);
  const Home start = test::smallFlat();
  Document document(start);
  const auto real = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  int done = 0;
  for (int i = 0; i < 600; ++i) {
    const Home& home = document.home();
    const WallId wall{1 + random() % home.nextId};
    Elements some;
    some.walls = {wall};
    some.furniture = {FurnitureId{1 + random() % home.nextId}};
    some.groups = {GroupId{1 + random() % home.nextId}};
    const Edit edit{"Edit", [&, kind = random() % 9](const Home& h) {
                      switch (kind) {
                        case 0:
                          return moveWallEnd(h, wall, WallEnd::Start, {real(-5, 9), real(-5, 9)});
                        case 1:
                          return splitWall(h, wall, real(0, 4)).home;
                        case 2:
                          return moveElements(h, some, {real(-1, 1), real(-1, 1), 0.1});
                        case 3:
                          return turnElements(h, some, {1, 1}, real(-3, 3));
                        case 4:
                          return random() % 4 ? h : deleteElements(h, some);
                        case 5: {
                          Wall added;
                          added.start = {real(-5, 9), real(-5, 9)};
                          added.end = {real(-5, 9), real(-5, 9)};
                          return addWall(h, added).home;
                        }
                        case 6:
                          return groupElements(h, some, "Group").home;
                        case 7:
                          return addRoomAt(h, {}, {real(0, 6), real(0, 4)}).home;
                        default: {
                          Home next = h;
                          next.furniture.set(next.newId<FurnitureId>(), Furniture{});
                          return next;
                        }
                      }
                    }};
    try {
      document.apply(edit);
      ++done;
    } catch (const InvalidHome&) {  // refused: nothing may have changed
    }
    ASSERT_NO_THROW(requireValid(document.home())) << "the quick check of a change let something through";
  }
  EXPECT_GT(done, 200);
  while (document.canUndo()) document.undo();
  EXPECT_EQ(document.home(), start);
}

}  // namespace
}  // namespace idap
