#include "model/room_geometry.h"

#include <gtest/gtest.h>

#include "support/sample_home.h"

namespace idap {
namespace {

Room roomOf(Polygon points) {
  Room room;
  room.points = std::move(points);
  return room;
}

// Closed walls around these corners, joined.
Home walled(const std::vector<Vec2>& corners, double thickness) {
  Home home;
  std::vector<WallId> ids;
  for (std::size_t i = 0; i < corners.size(); ++i) ids.push_back(home.newId<WallId>());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Wall wall;
    wall.start = corners[i];
    wall.end = corners[(i + 1) % corners.size()];
    wall.thickness = thickness;
    wall.neighbourAtStart = ids[(i + corners.size() - 1) % corners.size()];
    wall.neighbourAtEnd = ids[(i + 1) % corners.size()];
    home.walls.set(ids[i], wall);
  }
  return home;
}

TEST(RoomGeometry, AreaAndCentre) {
  const Room rectangle = roomOf({{1, 1}, {5, 1}, {5, 4}, {1, 4}});
  EXPECT_NEAR(floorArea(rectangle), 12, 1e-9);
  EXPECT_NEAR(roomCentre(rectangle).x, 3, 1e-12);
  EXPECT_NEAR(roomCentre(rectangle).y, 2.5, 1e-12);
  const Room bow = roomOf({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  EXPECT_NEAR(floorArea(bow), 0.5, 1e-9);
  // The centre of area of a thin L lies outside of it.
  const Room thinL = roomOf({{0, 0}, {10, 0}, {10, 0.5}, {0.5, 0.5}, {0.5, 10}, {0, 10}});
  EXPECT_TRUE(contains(thinL.points, roomCentre(thinL)));
}

TEST(RoomGeometry, FindsRoomsBetweenTheInnerFacesOfWalls) {
  const Home home = test::smallFlat();  // 6 x 4 with walls of 0.2, a wall of 0.1 across the middle
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 2u);
  for (const Polygon& area : areas) EXPECT_NEAR(signedArea(area), (3 - 0.1 - 0.05) * 3.8, 1e-6);
  const auto left = closedAreaAt(home, {}, {1, 1});
  ASSERT_TRUE(left);
  EXPECT_NEAR(bounds(*left).min.x, 0.1, 1e-9);
  EXPECT_NEAR(bounds(*left).max.x, 2.95, 1e-9);
  EXPECT_FALSE(closedAreaAt(home, {}, {-1, 1}));
  EXPECT_FALSE(closedAreaAt(home, {}, {3, 1})) << "inside a wall";
  EXPECT_TRUE(closedAreas(home, LevelId{9}).empty());
}

TEST(RoomGeometry, CornersThatPointIntoTheRoomAreWhole) {
  const Home home = walled({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 0.4);
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 1u);
  // The inner L: 3.6 x 1.6 and, above it, 1.6 x 2.
  EXPECT_NEAR(signedArea(areas[0]), 3.6 * 1.6 + 1.6 * 2, 1e-6);
}

TEST(RoomGeometry, SlantedCornersAreMitred) {
  const Home home = walled({{0, 0}, {6, 0}, {3, 5}}, 0.2);
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 1u);
  // A triangle moved inwards by d has area A - P d + P^2 d^2 / (4 A).
  const double side = std::hypot(3, 5), p = 6 + 2 * side, a = 15, d = 0.1;
  EXPECT_NEAR(signedArea(areas[0]), a - p * d + p * p * d * d / (4 * a), 1e-3);
}

TEST(RoomGeometry, SmallGapsCountAsClosedAndLargeOnesDoNot) {
  Home home = walled({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 0.1);
  const auto [id, wall] = *home.walls.begin();
  Wall shorter = *wall;
  shorter.neighbourAtEnd = {};
  shorter.end = {3.945, 0};  // 5 mm short of the next wall's face
  home.walls.set(id, shorter);
  EXPECT_EQ(closedAreas(home, {}).size(), 1u);
  EXPECT_EQ(closedAreas(home, {}, 0).size(), 0u);
  shorter.end = {3, 0};
  home.walls.set(id, shorter);
  EXPECT_EQ(closedAreas(home, {}).size(), 0u);
}

TEST(RoomGeometry, RoundWallsBoundRoomsToo) {
  Home home;
  const auto a = home.newId<WallId>(), b = home.newId<WallId>();
  Wall half;
  half.start = {-2, 0};
  half.end = {2, 0};
  half.arcExtent = kPi;
  half.thickness = 0.2;
  half.neighbourAtStart = half.neighbourAtEnd = b;
  home.walls.set(a, half);
  std::swap(half.start, half.end);
  half.neighbourAtStart = half.neighbourAtEnd = a;
  home.walls.set(b, half);
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(signedArea(areas[0]), kPi * 1.9 * 1.9, 0.03);
}

TEST(RoomGeometry, CornersThatWereNeverJoinedAreClosedToo) {
  Home home;
  const Vec2 corners[] = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  for (std::size_t i = 0; i < 6; ++i) {
    Wall wall;
    wall.start = corners[i];
    wall.end = corners[(i + 1) % 6];
    wall.thickness = 0.4;
    home.walls.set(home.newId<WallId>(), wall);
  }
  const auto areas = closedAreas(home, {});
  ASSERT_EQ(areas.size(), 1u);
  EXPECT_NEAR(signedArea(areas[0]), 3.6 * 1.6 + 1.6 * 2, 1e-6);
}

TEST(RoomGeometry, WhatWasFoundForOtherWallsIsNotMixedUp) {
  Home home = test::smallFlat();
  for (int i = 0; i < 20; ++i) {
    Wall wall = *home.walls.find(WallId{5});
    wall.start.x = wall.end.x = 2 + i * 0.1;
    home.walls.set(WallId{5}, wall);
    for (const double gap : {0.0, 0.005}) {
      const auto left = closedAreaAt(home, {}, {1, 1}, gap);
      ASSERT_TRUE(left);
      EXPECT_NEAR(signedArea(*left), (1.85 + i * 0.1) * 3.8, 1e-6);
    }
    EXPECT_TRUE(closedAreas(home, LevelId{3}).empty());
  }
}

}  // namespace
}  // namespace idap
