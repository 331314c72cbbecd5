// Duplicating, and what goes through the clipboard.
#include <gtest/gtest.h>

#include "model/edits/arrange_edits.h"
#include "model/edits/level_edits.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

Elements everythingOf(const Home& home) { return allElements(home); }

TEST(Duplicate, CopiesGroupsWithAllInThem) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.groups = {GroupId{8}};
  const CopyEdit edit = duplicateElements(home, chosen, {1, 0, 0});
  ASSERT_EQ(edit.copies.groups.size(), 1u);
  EXPECT_TRUE(edit.copies.furniture.empty()) << "the group stands for its pieces";
  EXPECT_EQ(edit.home.groups.size(), 2u);
  ASSERT_EQ(edit.home.furniture.size(), 2u);
  const Furniture& copy = *std::next(edit.home.furniture.begin())->second;
  EXPECT_EQ(copy.group, edit.copies.groups[0]);
  EXPECT_EQ(copy.position.x, 2.5);
  EXPECT_NO_THROW(requireValid(edit.home, home));
}

TEST(Duplicate, WallsTakeTheirDoorsAndStayJoinedAmongThemselves) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.walls = {WallId{1}, WallId{2}};
  const CopyEdit edit = duplicateElements(home, chosen, {0, -10, 0});
  ASSERT_EQ(edit.copies.walls.size(), 2u);
  ASSERT_EQ(edit.copies.openings.size(), 1u);
  const Wall &first = *edit.home.walls.find(edit.copies.walls[0]),
             &second = *edit.home.walls.find(edit.copies.walls[1]);
  EXPECT_EQ(first.neighbourAtEnd, edit.copies.walls[1]);
  EXPECT_EQ(second.neighbourAtStart, edit.copies.walls[0]);
  EXPECT_FALSE(first.neighbourAtStart);
  const Opening& window = *edit.home.openings.find(edit.copies.openings[0]);
  EXPECT_EQ(window.wall, edit.copies.walls[0]);
  EXPECT_EQ(window.position.y, -10);
  for (const auto& [id, wall] : home.walls) EXPECT_EQ(*edit.home.walls.find(id), *wall);
  EXPECT_NO_THROW(requireValid(edit.home, home));
}

TEST(Duplicate, AWindowKeepsToTheWallItComesToLieIn) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.openings = {OpeningId{7}};
  const auto wallOf = [&](Vec3 by) {
    const CopyEdit edit = duplicateElements(home, chosen, by);
    return edit.home.openings.find(edit.copies.openings[0])->wall;
  };
  EXPECT_EQ(wallOf({-1.5, 0, 0}), WallId{1});
  EXPECT_EQ(wallOf({-1.5, 4, 0}), WallId{3});
  EXPECT_FALSE(wallOf({-1.5, 2, 0}));
}

TEST(Duplicate, WallsOntoThemselvesMakeNoSecondOnes) {
  const Home home = test::smallFlat();
  const CopyEdit edit = duplicateElements(home, everythingOf(home), {});
  EXPECT_EQ(edit.home.walls.size(), 5u);
  EXPECT_NO_THROW(requireValid(edit.home));
}

TEST(Clipboard, APartIsAHomeOfItsOwn) {
  const Home home = test::fullHome();
  Elements chosen;
  chosen.furniture = {home.furniture.begin()->first};
  const Home part = extractElements(home, chosen);
  EXPECT_NO_THROW(requireValid(part));
  EXPECT_EQ(part.furniture.size(), 1u);
  EXPECT_TRUE(part.walls.empty() && part.openings.empty() && part.groups.empty() && part.labels.empty());
  EXPECT_FALSE(part.furniture.begin()->second->group);
  EXPECT_TRUE(part.assets->contains("models/chair/chair.obj"));
  EXPECT_TRUE(part.assets->contains("models/chair/chair.mtl"));
  EXPECT_FALSE(part.assets->contains("pictures/plan.png"));
}

TEST(Clipboard, PastedOnAnyLevelWithNewIds) {
  const Home from = test::fullHome();
  const Home part = extractElements(from, everythingOf(from));
  const LevelEdit target = withLevels(test::smallFlat(), "Ground");
  const CopyEdit edit = pasteElements(target.home, part, target.level, {10, 0, 0});
  EXPECT_NO_THROW(requireValid(edit.home, target.home));
  EXPECT_EQ(edit.home.levels.size(), 1u);
  EXPECT_EQ(edit.home.walls.size(), target.home.walls.size() + from.walls.size());
  for (const WallId id : edit.copies.walls) EXPECT_EQ(edit.home.walls.find(id)->level, target.level);
  EXPECT_EQ(edit.copies.groups.size(), 1u) << "the outer one";
  EXPECT_EQ(*edit.home.assets->at("textures/wood.jpg"), *from.assets->at("textures/wood.jpg"));
  const Furniture& lamp =
      *edit.home.furniture.find(FurnitureId{edit.home.furniture.chunks().back()->back().first});
  EXPECT_EQ(lamp.position.x, from.furniture.begin()->second->position.x + 10);
  EXPECT_EQ(lamp.lamp, from.furniture.begin()->second->lamp);
}

TEST(Clipboard, PastedIntoAGroup) {
  const Home home = test::smallFlat();
  const Home piece = extractElements(test::manyPieces(1), everythingOf(test::manyPieces(1)));
  const CopyEdit edit = pasteElements(home, piece, {}, {}, GroupId{8});
  EXPECT_EQ(edit.copies.groups, std::vector<GroupId>{GroupId{8}});
  EXPECT_TRUE(edit.copies.furniture.empty());
  EXPECT_EQ(std::next(edit.home.furniture.begin())->second->group, GroupId{8});
}

TEST(Clipboard, FilesOfTheSameNameDoNotReplaceEachOther) {
  const Home home = test::fullHome();
  Home other = test::fullHome();
  Assets assets = *other.assets;
  assets["models/chair/chair.obj"] = test::bytesOf("v 1 1 1\n");
  assets["textures/wood.jpg"] = test::bytesOf("other wood");
  other.assets = std::make_shared<const Assets>(assets);
  const Home part = extractElements(other, everythingOf(other));
  const CopyEdit edit = pasteElements(home, part, home.levels.begin()->first, {10, 0, 0});
  EXPECT_NO_THROW(requireValid(edit.home, home));
  EXPECT_EQ(*edit.home.assets->at("models/chair/chair.obj"), *home.assets->at("models/chair/chair.obj"));
  ASSERT_EQ(edit.home.furniture.size(), 2u);
  const Furniture &mine = *edit.home.furniture.begin()->second,
                  &pasted = *std::next(edit.home.furniture.begin())->second;
  EXPECT_EQ(mine.model.asset, "models/chair/chair.obj");
  EXPECT_NE(pasted.model.asset, mine.model.asset);
  EXPECT_EQ(*edit.home.assets->at(pasted.model.asset), *assets["models/chair/chair.obj"]);
  const std::string folder = pasted.model.asset.substr(0, pasted.model.asset.rfind('/'));
  EXPECT_TRUE(edit.home.assets->contains(folder + "/chair.mtl")) << "its materials stay beside it";
  EXPECT_EQ(*edit.home.assets->at(pasted.finish.texture->asset), *assets["textures/wood.jpg"]);
  // The same once more needs no more files.
  const CopyEdit again = pasteElements(edit.home, extractElements(edit.home, edit.copies),
                                       home.levels.begin()->first, {20, 0, 0});
  EXPECT_EQ(again.home.assets->size(), edit.home.assets->size());
}

TEST(Clipboard, StylesGoToOthersOfTheirKind) {
  const Home from = test::fullHome();
  const Home style = extractElements(from, everythingOf(from));
  Home home = test::smallFlat();
  home = addRoomAt(home, {}, {1, 1}, "Mine").home;
  Furniture lamp;
  lamp.lamp = Lamp{};
  const auto lampId = home.newId<FurnitureId>();
  home.furniture.set(lampId, lamp);
  const Home styled = pasteStyle(home, style, everythingOf(home));
  EXPECT_NO_THROW(requireValid(styled, home));
  const Wall &wall = *styled.walls.begin()->second, &likeWall = *from.walls.begin()->second;
  EXPECT_EQ(wall.left, likeWall.left);
  EXPECT_EQ(wall.start, home.walls.begin()->second->start);
  const Room& room = *styled.rooms.begin()->second;
  EXPECT_EQ(room.name, "Mine");
  EXPECT_EQ(room.floor, from.rooms.begin()->second->floor);
  const Furniture& like = *from.furniture.begin()->second;
  EXPECT_EQ(styled.furniture.find(FurnitureId{9})->finish, like.finish);
  EXPECT_FALSE(styled.furniture.find(FurnitureId{9})->lamp) << "a table does not become a lamp";
  EXPECT_EQ(styled.furniture.find(lampId)->lamp->lumens, like.lamp->lumens);
  EXPECT_TRUE(styled.furniture.find(lampId)->lamp->sources.empty());
  EXPECT_TRUE(styled.assets->contains("textures/wood.jpg"));
  EXPECT_FALSE(styled.assets->contains("models/chair/chair.obj")) << "a style brings no models";
  EXPECT_EQ(pasteStyle(home, style, {}), home);
}

TEST(Assets, UnusedFilesAreLeftOut) {
  Home home = test::fullHome();
  EXPECT_EQ(withoutUnusedAssets(home).assets, home.assets) << "all are used";
  home.backgrounds.clear();
  EXPECT_FALSE(withoutUnusedAssets(home).assets->contains("pictures/plan.png"));
  EXPECT_NO_THROW(requireValid(withoutUnusedAssets(home)));
}

}  // namespace
}  // namespace idap
