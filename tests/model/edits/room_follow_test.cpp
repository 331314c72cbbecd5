// Rooms are found when walls close, and follow them.
#include <gtest/gtest.h>

#include "model/edits/element_edits.h"
#include "model/edits/wall_shape_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

Home withWall(const Home& home, Vec2 start, Vec2 end) { return addWall(home, test::wall(start, end)).home; }

Elements walls(std::vector<WallId> ids) {
  Elements chosen;
  chosen.walls = std::move(ids);
  return chosen;
}

struct Flat {
  Home home;
  RoomId left, right;
};
// The small flat with both rooms named and finished.
Flat flat() {
  RoomEdit left = addRoomAt(test::smallFlat(), {}, {1, 1}, "Left");
  RoomEdit right = addRoomAt(left.home, {}, {5, 1}, "Right");
  Room room = *right.home.rooms.find(left.room);
  room.floor.material = "oak";
  right.home.rooms.set(left.room, room);
  return {right.home, left.room, right.room};
}
double areaOf(const Home& home, RoomId id) { return floorArea(*home.rooms.find(id)); }

TEST(FollowWalls, TheLastWallOfARingMakesARoom) {
  Home home = withWall(withWall(withWall({}, {0, 0}, {4, 0}), {4, 0}, {4, 3}), {4, 3}, {0, 3});
  const Home closed = withWall(home, {0, 3}, {0, 0});
  EXPECT_TRUE(followWalls(home, closed, {}, false).rooms.empty());
  const Home made = followWalls(home, closed, {}, true, "New");
  ASSERT_EQ(made.rooms.size(), 1u);
  const Room& room = *made.rooms.begin()->second;
  EXPECT_EQ(room.name, "New");
  EXPECT_NEAR(floorArea(room), 3.8 * 2.8, 1e-9);
  EXPECT_NO_THROW(requireValid(made, home));
}

TEST(FollowWalls, RoomsKeepFillingTheirAreaWhenAWallMoves) {
  const Flat before = flat();
  Home after = moveElements(before.home, walls({WallId{5}}), {1, 0, 0});
  after = followWalls(before.home, after, {}, true);
  EXPECT_EQ(after.rooms.size(), 2u);
  EXPECT_NEAR(areaOf(after, before.left), (4 - 0.1 - 0.05) * 3.8, 1e-9);
  EXPECT_NEAR(areaOf(after, before.right), (2 - 0.1 - 0.05) * 3.8, 1e-9);
  const Room& room = *after.rooms.find(before.left);
  EXPECT_EQ(room.name, "Left");
  EXPECT_EQ(room.floor.material, "oak");
}

TEST(FollowWalls, RoomsGoAlongHoweverFarTheirWallsGo) {
  const Flat before = flat();
  for (const double by : {2.95, 3.0, 50.0}) {
    Home after =
        moveElements(before.home, walls({WallId{1}, WallId{2}, WallId{3}, WallId{4}, WallId{5}}), {by, 0, 0});
    after = followWalls(before.home, after, {}, true);
    EXPECT_EQ(after.rooms.size(), 2u);
    for (const RoomId id : {before.left, before.right})
      EXPECT_NEAR(roomCentre(*after.rooms.find(id)).x, roomCentre(*before.home.rooms.find(id)).x + by, 1e-9);
  }
}

TEST(FollowWalls, ARoomCutInTwoKeepsTheLargerPart) {
  const Flat before = flat();
  const Home after = followWalls(before.home, withWall(before.home, {0, 3}, {3, 3}), {}, true);
  ASSERT_EQ(after.rooms.size(), 3u);
  EXPECT_NEAR(areaOf(after, before.left), 2.85 * 2.8, 1e-9);
  EXPECT_NEAR(areaOf(after, before.right), areaOf(before.home, before.right), 1e-9);
  const Room& cut = *std::next(after.rooms.begin(), 2)->second;
  EXPECT_NEAR(floorArea(cut), 2.85 * 0.8, 1e-9);
  EXPECT_EQ(cut.name, "");
  EXPECT_EQ(cut.floor.material, "oak") << "the floor goes on";
  EXPECT_EQ(followWalls(before.home, withWall(before.home, {0, 3}, {3, 3}), {}, false).rooms.size(), 2u);
}

TEST(FollowWalls, OfEqualPartsTheRoomKeepsTheOneItsNameStandsIn) {
  for (const double offset : {-1.0, 1.0}) {
    Flat before = flat();
    Room room = *before.home.rooms.find(before.left);
    room.nameOffset = {0, offset};
    before.home.rooms.set(before.left, room);
    const Home after = followWalls(before.home, withWall(before.home, {0, 2}, {3, 2}), {}, true);
    ASSERT_EQ(after.rooms.size(), 3u);
    const double y = roomCentre(*after.rooms.find(before.left)).y;
    EXPECT_EQ(y > 2, offset > 0);
  }
}

TEST(FollowWalls, WhereTwoRoomsBecomeOneAreaBothStay) {
  const Flat before = flat();
  const Home after = followWalls(before.home, deleteElements(before.home, walls({WallId{5}})), {}, true);
  EXPECT_EQ(after.rooms, before.home.rooms);
}

TEST(FollowWalls, ARoomThatIsOpenedStaysAndOneDrawnByHandToo) {
  Flat before = flat();
  Room rug;
  rug.points = {{0.5, 0.5}, {2, 0.5}, {2, 2}, {0.5, 2}};
  const RoomEdit edit = addRoom(before.home, rug);
  const Home opened = followWalls(edit.home, deleteElements(edit.home, walls({WallId{1}})), {}, true);
  EXPECT_EQ(opened.rooms, edit.home.rooms);
  const Home moved =
      followWalls(edit.home, moveElements(edit.home, walls({WallId{5}}), {0.5, 0, 0}), {}, true);
  EXPECT_EQ(*moved.rooms.find(edit.room), rug);
  EXPECT_EQ(moved.rooms.size(), 3u);
}

TEST(FollowWalls, ARoomDrawnToTheCornersOfWallsKeepsToThem) {
  // Both rooms of the flat as one: no area between walls.
  Room whole;
  whole.points = {{0.1, 0.1}, {5.9, 0.1}, {5.9, 3.9}, {0.1, 3.9}};
  const RoomEdit edit = addRoom(test::smallFlat(), whole);
  const Home moved =
      followWalls(edit.home, moveElements(edit.home, walls({WallId{2}}), {1, 0, 0}), {}, false);
  const Box2 box = bounds(moved.rooms.find(edit.room)->points);
  EXPECT_NEAR(box.min.x, 0.1, 1e-9);
  EXPECT_NEAR(box.max.x, 6.9, 1e-9);
  EXPECT_NEAR(box.max.y, 3.9, 1e-9);
}

TEST(FollowWalls, AnAreaWhoseRoomWasDeletedStaysWithout) {
  const Flat before = flat();
  Elements gone;
  gone.rooms = {before.left};
  const Home without = deleteElements(before.home, gone);
  const Home moved = followWalls(without, moveElements(without, walls({WallId{5}}), {0.5, 0, 0}), {}, true);
  EXPECT_EQ(moved.rooms.size(), 1u);
  // Unless it is cut in two, which closes both parts anew.
  EXPECT_EQ(followWalls(without, withWall(without, {0, 3}, {3, 3}), {}, true).rooms.size(), 3u);
}

TEST(FollowWalls, ARoomInsideARoomIsFoundToo) {
  Home home;
  test::addWalls(home, {{0, 0}, {8, 0}, {8, 6}, {0, 6}});
  home = addRoomAt(home, {}, {1, 1}, "Hall").home;
  Home inner = home;
  test::addWalls(inner, {{3, 2}, {5, 2}, {5, 4}, {3, 4}});
  const Home made = followWalls(home, inner, {}, true);
  ASSERT_EQ(made.rooms.size(), 2u);
  EXPECT_NEAR(floorArea(*std::next(made.rooms.begin())->second), 1.8 * 1.8, 1e-9);
}

TEST(FollowWalls, SplittingReversingAndBendingWallsKeepsTheRooms) {
  const Flat before = flat();
  const Home split = followWalls(before.home, splitWall(before.home, WallId{1}, 2).home, {}, true);
  EXPECT_EQ(split.rooms.size(), 2u);
  EXPECT_NEAR(areaOf(split, before.left), areaOf(before.home, before.left), 1e-9);
  const Home reversed = followWalls(before.home, reverseWall(before.home, WallId{5}), {}, true);
  EXPECT_EQ(reversed.rooms.size(), 2u);
  const Home bent = followWalls(before.home, bendWall(before.home, WallId{2}, {8, 2}), {}, true);
  ASSERT_EQ(bent.rooms.size(), 2u);
  EXPECT_GT(areaOf(bent, before.right), areaOf(before.home, before.right) + 4);
  EXPECT_EQ(*bent.rooms.find(before.left), *before.home.rooms.find(before.left));
}

TEST(FollowWalls, ThickerWallsMakeSmallerRooms) {
  const Flat before = flat();
  Wall thick = *before.home.walls.find(WallId{5});
  thick.thickness = 0.5;
  const Home after = followWalls(before.home, replaceWall(before.home, WallId{5}, thick), {}, true);
  EXPECT_NEAR(areaOf(after, before.left), (3 - 0.1 - 0.25) * 3.8, 1e-9);
}

TEST(RoomsOfClosedAreas, GivesARoomToEachAreaWithoutOne) {
  const Home home = test::smallFlat();
  const RoomsEdit all = roomsOfClosedAreas(home, {}, "Room");
  EXPECT_EQ(all.rooms.size(), 2u);
  EXPECT_TRUE(roomsOfClosedAreas(all.home, {}).rooms.empty());
  const RoomEdit one = addRoomAt(home, {}, {1, 1});
  EXPECT_EQ(roomsOfClosedAreas(one.home, {}).rooms.size(), 1u);
}

}  // namespace
}  // namespace idap
