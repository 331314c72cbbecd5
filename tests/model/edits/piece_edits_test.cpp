#include "model/edits/piece_edits.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "model/edits/wall_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

void expectNear(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

TEST(PieceEdits, AddedPiecesGetAnIdOfTheirOwn) {
  const FurnitureEdit chair = addFurniture(test::smallFlat(), Furniture{});
  EXPECT_TRUE(chair.home.furniture.contains(chair.furniture));
  Opening door;
  door.wall = WallId{1};
  const OpeningEdit opening = addOpening(chair.home, door);
  EXPECT_EQ(*opening.home.openings.find(opening.opening), door);
  EXPECT_NO_THROW(requireValid(opening.home));
}

TEST(PieceEdits, ChangesReachTheMembersOfGroups) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.groups = {GroupId{8}};
  chosen.openings = {OpeningId{6}, OpeningId{99}};
  const Home named = changePieces(home, chosen, [](Piece& piece) { piece.name = "New"; });
  EXPECT_EQ(named.furniture.find(FurnitureId{9})->name, "New");
  EXPECT_EQ(named.openings.find(OpeningId{6})->name, "New");
  EXPECT_EQ(named.openings.find(OpeningId{7})->name, "Window");
  const Home lit = changeFurniture(home, chosen, [](Furniture& piece) { piece.lamp = Lamp{}; });
  EXPECT_TRUE(lit.furniture.find(FurnitureId{9})->lamp);
  EXPECT_EQ(lit.openings, home.openings);
}

TEST(PieceEdits, RoomsGetAndLoseCorners) {
  Room room;
  room.points = {{0, 0}, {4, 0}, {4, 3}};
  const RoomEdit edit = addRoom(Home{}, room);
  const Home four = addRoomPoint(edit.home, edit.room, 3, {0, 3});
  EXPECT_NEAR(floorArea(*four.rooms.find(edit.room)), 12, 1e-9);
  const Home moved = moveRoomPoint(four, edit.room, 3, {-4, 3});
  EXPECT_EQ(moved.rooms.find(edit.room)->points[3], (Vec2{-4, 3}));
  EXPECT_EQ(removeRoomPoint(four, edit.room, 3), edit.home);
  EXPECT_THROW(removeRoomPoint(edit.home, edit.room, 0), InvalidHome);
  EXPECT_THROW(moveRoomPoint(edit.home, edit.room, 3, {}), InvalidHome);
  EXPECT_THROW(addRoomPoint(edit.home, edit.room, 5, {}), InvalidHome);
  EXPECT_THROW(addRoomPoint(edit.home, RoomId{77}, 0, {}), InvalidHome);
}

class DimensionsFollow : public testing::Test {
 protected:
  // Adds a dimension to the small flat, applies an edit, and gives the dimension as it is then.
  template <class F>
  Dimension after(Vec2 start, Vec2 end, F edit) {
    Home home = test::smallFlat();
    const DimensionId id = home.newId<DimensionId>();
    Dimension dimension;
    dimension.start = start;
    dimension.end = end;
    home.dimensions.set(id, dimension);
    return *dimensionsFollow(home, edit(home)).dimensions.find(id);
  }
};

TEST_F(DimensionsFollow, TheCornersOfPieces) {
  Elements table;
  table.furniture = {FurnitureId{9}};
  const auto move = [&](const Home& home) { return moveElements(home, table, {0.5, 0.25, 0}); };
  const Dimension width = after({0.8, 1.6}, {2.2, 1.6}, move);
  expectNear(width.start, {1.3, 1.85});
  expectNear(width.end, {2.7, 1.85});
  const Dimension toWall = after({0.1, 1.6}, {0.8, 1.6}, move);
  expectNear(toWall.start, {0.1, 1.6});
  expectNear(toWall.end, {1.3, 1.85});
  const Dimension elsewhere = after({5, 5}, {6, 6}, move);
  EXPECT_EQ(elsewhere.start, (Vec2{5, 5}));
}

TEST_F(DimensionsFollow, EndsCornersAndFacesOfWalls) {
  Elements middle;
  middle.walls = {WallId{5}};
  const auto move = [&](const Home& home) { return moveElements(home, middle, {0.5, 0, 0}); };
  const Dimension clear = after({0.1, 2}, {2.95, 2}, move);
  expectNear(clear.start, {0.1, 2});
  expectNear(clear.end, {3.45, 2});
  expectNear(after({0, 0}, {3, 0}, move).end, {3.5, 0});
  const auto corner = [](const Home& home) { return moveWallEnd(home, WallId{1}, WallEnd::End, {7, 0}); };
  const Dimension along = after({0.1, 0.1}, {5.9, 0.1}, corner);
  expectNear(along.start, {0.1, 0.1});
  EXPECT_GT(along.end.x, 6.7);
  const auto thicker = [](const Home& home) {
    Wall wall = *home.walls.find(WallId{5});
    wall.thickness = 0.3;
    return replaceWall(home, WallId{5}, wall);
  };
  expectNear(after({0.1, 2}, {2.95, 2}, thicker).end, {2.85, 2});
}

TEST_F(DimensionsFollow, RoomsButNotTheirOwnMoves) {
  Home home = test::smallFlat();
  RoomEdit room = addRoomAt(home, {}, {1, 1});
  const DimensionId id = room.home.newId<DimensionId>();
  Dimension dimension;
  dimension.start = {0.1, 0.1};
  dimension.end = {2.95, 0.1};
  room.home.dimensions.set(id, dimension);
  Elements both;
  both.rooms = {room.room};
  Home moved = dimensionsFollow(room.home, moveElements(room.home, both, {1, 0, 0}));
  expectNear(moved.dimensions.find(id)->start, {1.1, 0.1});
  both.dimensions = {id};
  moved = dimensionsFollow(room.home, moveElements(room.home, both, {1, 0, 0}));
  expectNear(moved.dimensions.find(id)->start, {1.1, 0.1});
}

TEST(MakeRoomHome, HasTheClearSizesAskedFor) {
  const Home home = makeRoomHome(4, 5, 2.7, 0.12, "Bedroom");
  EXPECT_NO_THROW(requireValid(home));
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(signedArea(areas[0]), 20, 1e-9);
  expectNear(bounds(areas[0]).min, {0, 0});
  ASSERT_EQ(home.rooms.size(), 1u);
  const Room& room = *home.rooms.begin()->second;
  EXPECT_EQ(room.name, "Bedroom");
  EXPECT_NEAR(floorArea(room), 20, 1e-9);
  EXPECT_EQ(home.wallHeight, 2.7);
  for (const auto& [id, wall] : home.walls) EXPECT_EQ(wall->heightAtStart, 2.7);
}

}  // namespace
}  // namespace idap
