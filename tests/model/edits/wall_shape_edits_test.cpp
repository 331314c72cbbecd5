#include "model/edits/wall_shape_edits.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "model/edits/element_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "model/wall_path.h"
#include "support/sample_home.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

void expectNear(Vec2 a, Vec2 b, double tolerance = 1e-9) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}
const Wall& get(const Home& home, WallId id) { return *home.walls.find(id); }

struct Pair {
  Home home;
  WallId first, second;
};
Pair pair(Wall first, Wall second) {
  Pair made;
  made.first = made.home.newId<WallId>();
  made.second = made.home.newId<WallId>();
  made.home.walls.set(made.first, first);
  made.home.walls.set(made.second, second);
  return made;
}

TEST(JoinWalls, ProlongsAndShortensToTheCorner) {
  const Pair p = pair(test::wall({0, 0}, {3, 0}), test::wall({4, 3}, {4, -0.2}));
  const Home joined = joinWalls(p.home, p.first, p.second);
  expectNear(get(joined, p.first).end, {4, 0});
  expectNear(get(joined, p.second).end, {4, 0});
  EXPECT_EQ(get(joined, p.first).neighbourAtEnd, p.second);
  EXPECT_EQ(get(joined, p.second).neighbourAtEnd, p.first);
  EXPECT_NO_THROW(requireValid(joined, p.home));
  EXPECT_EQ(joinWalls(joined, p.first, p.second), joined) << "once joined there is nothing to do";
}

TEST(JoinWalls, InLineTheyMeetInTheMiddleOfTheGap) {
  const Pair p = pair(test::wall({0, 0}, {3, 0}), test::wall({8, 0}, {4, 0}));
  const Home joined = joinWalls(p.home, p.first, p.second);
  expectNear(get(joined, p.first).end, {3.5, 0});
  expectNear(get(joined, p.second).end, {3.5, 0});
}

TEST(JoinWalls, AWallThatReachesFarBeyondIsMetInItsMidst) {
  const Pair p = pair(test::wall({0, 2}, {0, 1}), test::wall({-3, 0}, {3, 0}));
  const Home joined = joinWalls(p.home, p.first, p.second);
  expectNear(get(joined, p.first).end, {0, 0});
  EXPECT_EQ(get(joined, p.second), get(p.home, p.second));
}

TEST(JoinWalls, RefusesWhatCannotMeet) {
  const Pair beside = pair(test::wall({0, 0}, {3, 0}), test::wall({0, 1}, {3, 1}));
  EXPECT_THROW(joinWalls(beside.home, beside.first, beside.second), InvalidHome);
  const Pair crossing = pair(test::wall({-3, 0}, {3, 0}), test::wall({0, -3}, {0, 3}));
  EXPECT_THROW(joinWalls(crossing.home, crossing.first, crossing.second), InvalidHome);
  EXPECT_THROW(joinWalls(beside.home, beside.first, beside.first), InvalidHome);
  EXPECT_THROW(joinWalls(beside.home, beside.first, WallId{99}), InvalidHome);
  Wall above = test::wall({4, 1}, {4, 3});
  above.level = LevelId{7};
  const Pair levels = pair(test::wall({0, 0}, {3, 0}), above);
  EXPECT_THROW(joinWalls(levels.home, levels.first, levels.second), InvalidHome);
}

TEST(JoinWalls, ARoundWallGoesOnAlongItsCircle) {
  Wall arc = test::wall({-2, 0}, {0, 2});
  arc.arcExtent = -kPi / 2;  // about the origin, clockwise from the left to the top
  const Pair p = pair(arc, test::wall({2, -3}, {2, -0.5}));
  const Home joined = joinWalls(p.home, p.first, p.second);
  expectNear(get(joined, p.first).end, {2, 0}, 1e-6);
  EXPECT_NEAR(get(joined, p.first).arcExtent, -kPi, 1e-6);
  expectNear(get(joined, p.second).end, {2, 0}, 1e-6);
}

TEST(ReverseWall, LooksTheSameFromBothSides) {
  Home home = test::fullHome();
  const WallId id = home.walls.begin()->first;
  const Wall before = get(home, id);
  const Home reversed = reverseWall(home, id);
  const Wall& wall = get(reversed, id);
  EXPECT_EQ(wall.start, before.end);
  EXPECT_EQ(wall.left, before.right);
  EXPECT_EQ(wall.heightAtStart, before.heightAtEnd);
  EXPECT_EQ(wall.neighbourAtStart, before.neighbourAtEnd);
  const WallPath a(before), b(wall);
  expectNear(a.point(a.length() / 2), b.point(b.length() / 2));
  EXPECT_EQ(reversed.openings, home.openings);
  EXPECT_EQ(reverseWall(reversed, id), home);
  EXPECT_THROW(reverseWall(home, WallId{99}), InvalidHome);
}

TEST(BendWall, PassesThroughThePointAndBackAgain) {
  const Home home = test::smallFlat();
  for (const double sagitta : {0.5, -0.5, 3.0, -4.0}) {
    const Home bent = bendWall(home, WallId{1}, {3, sagitta});
    const WallPath path(get(bent, WallId{1}));
    expectNear(path.point(path.length() / 2), {3, sagitta});
    EXPECT_NO_THROW(requireValid(bent, home));
    const Opening& window = *bent.openings.find(OpeningId{7});
    const Vec2 at{window.position.x, window.position.y};
    EXPECT_NEAR(length(path.point(path.nearest(at)) - at), 0, 1e-9) << "the window stays in the wall";
    EXPECT_NEAR(path.nearest(at) / path.length(), 0.75, 1e-9);
    const Home straight = bendWall(bent, WallId{1}, {3, 0.0005});
    EXPECT_EQ(get(straight, WallId{1}), get(home, WallId{1}));
    EXPECT_NEAR(straight.openings.find(OpeningId{7})->position.x, 4.5, 1e-9);
    EXPECT_NEAR(straight.openings.find(OpeningId{7})->angle, 0, 1e-9);
  }
}

TEST(MoveCorner, TakesWallsAndRoomsAlong) {
  Home home;
  const auto ids = test::addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  home = addRoomAt(home, {}, {1, 1}, "Found").home;
  // Drawn by hand to two of the corners only.
  Room half;
  half.points = {{0.1, 0.1}, {3.9, 0.1}, {2, 1}};
  const RoomEdit drawn = addRoom(home, half);
  const Home moved = moveCorner(drawn.home, {}, {4, 0}, {6, 0});
  expectNear(get(moved, ids[0]).end, {6, 0});
  expectNear(get(moved, ids[1]).start, {6, 0});
  const Room& found = *moved.rooms.begin()->second;
  EXPECT_EQ(found.name, "Found");
  EXPECT_GT(floorArea(found), 3.8 * 2.8 + 2);
  EXPECT_TRUE(closedAreaAt(moved, {}, {1, 1}));
  EXPECT_NEAR(floorArea(found), std::abs(signedArea(*closedAreaAt(moved, {}, {1, 1}))), 1e-9);
  const Room& triangle = *moved.rooms.find(drawn.room);
  expectNear(triangle.points[0], {0.1, 0.1});
  EXPECT_GT(triangle.points[1].x, 5);
  expectNear(triangle.points[2], {2, 1});
}

TEST(MoveWall, BothCornersGoAtOnce) {
  Home home;
  const auto ids = test::addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  const RoomEdit room = addRoomAt(home, {}, {1, 1}, "Found");
  const Home moved = moveWall(room.home, ids[1], {5, 0}, {5, 3});
  expectNear(get(moved, ids[0]).end, {5, 0});
  expectNear(get(moved, ids[2]).start, {5, 3});
  EXPECT_NEAR(floorArea(*moved.rooms.find(room.room)), 4.8 * 2.8, 1e-9);
  EXPECT_THROW(moveWall(home, WallId{99}, {}, {1, 1}), InvalidHome);
}

TEST(WallsAroundRoom, StandOutsideOfItAndCloseIt) {
  for (const Polygon& outline :
       {Polygon{{0, 0}, {4, 0}, {4, 3}, {0, 3}},
        Polygon{{0, 3}, {4, 3}, {4, 0}, {2, 0}, {0, 0}},  // clockwise, an idle point
        Polygon{{0, 0}, {5, 0}, {5, 2}, {2, 2}, {2, 5}, {0, 5}}, Polygon{{0, 0}, {5, 0}, {1, 4}}}) {
    Room room;
    room.points = outline;
    const RoomEdit drawn = addRoom(Home{}, room);
    const Home walled = wallsAroundRoom(drawn.home, drawn.room, 0.3, 2.4);
    EXPECT_NO_THROW(requireValid(walled));
    const auto areas = closedAreas(walled, {});
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_NEAR(signedArea(areas[0]), std::abs(signedArea(outline)), 1e-6);
    for (const auto& [id, wall] : walled.walls) {
      EXPECT_EQ(wall->heightAtEnd, 2.4);
      EXPECT_TRUE(wall->neighbourAtStart && wall->neighbourAtEnd);
    }
  }
}

TEST(WallsAroundRoom, NoWallIsPutWhereOneStands) {
  Home home;
  test::addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  RoomEdit edit = addRoomAt(home, {}, {1, 1});
  EXPECT_EQ(wallsAroundRoom(edit.home, edit.room, 0.2, 2.5).walls.size(), 4u);
  // The room next door shares one of the walls.
  Room next;
  next.points = {{4.1, 0.1}, {7, 0.1}, {7, 2.9}, {4.1, 2.9}};
  edit = addRoom(edit.home, next);
  const Home walled = wallsAroundRoom(edit.home, edit.room, 0.2, 2.5);
  EXPECT_EQ(walled.walls.size(), 7u);
  EXPECT_EQ(closedAreas(walled, {}).size(), 2u);
  EXPECT_NO_THROW(requireValid(walled));
}

}  // namespace
}  // namespace idap
