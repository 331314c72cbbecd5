#include "film/walk_map.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "film/film_test_support.h"

namespace idap {
namespace {

using test::twoRooms;

// Where the way crosses the line x = at.
std::vector<double> crossings(const std::vector<Vec2>& way, double at) {
  std::vector<double> ys;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    if ((way[i].x < at) != (way[i + 1].x < at))
      ys.push_back(way[i].y + (way[i + 1].y - way[i].y) * (at - way[i].x) / (way[i + 1].x - way[i].x));
  return ys;
}

TEST(WalkMap, GoesThroughTheDoor) {
  const Home home = twoRooms();
  const WalkMap map(home, 0);
  const auto way = map.way({1, 1}, {7, 1});
  ASSERT_TRUE(way);
  EXPECT_FALSE(way->overFurniture);
  const auto ys = crossings(way->points, 4);
  ASSERT_EQ(ys.size(), 1u);
  EXPECT_NEAR(ys[0], 3, 0.25) << "through its middle";
  EXPECT_EQ(map.doorsOn(way->points).size(), 1u);
  EXPECT_EQ(way->points.front(), (Vec2{1, 1}));
  EXPECT_EQ(way->points.back(), (Vec2{7, 1}));
}

TEST(WalkMap, NotThroughWallsNorThroughWindows) {
  Home home = twoRooms(false);
  EXPECT_FALSE(WalkMap(home, 0).way({1, 1}, {7, 1}));
  Opening window;
  window.kind = OpeningKind::Window;
  window.position = {4, 3, 0};
  window.angle = kPi / 2;
  window.size = {0.9, 0.15, 2.1};
  home.openings.set(home.newId<OpeningId>(), window);
  EXPECT_FALSE(WalkMap(home, 0).way({1, 1}, {7, 1}));
}

TEST(WalkMap, GoesRoundATable) {
  Home home = twoRooms();
  test::addTable(home, {2, 2}, {1.6, 1.2});
  const WalkMap map(home, 0);
  const auto way = map.way({0.6, 2}, {3.4, 2});
  ASSERT_TRUE(way);
  EXPECT_FALSE(way->overFurniture);
  for (std::size_t i = 0; i + 1 < way->points.size(); ++i)
    for (double t = 0; t <= 1; t += 0.02) {
      const Vec2 p = way->points[i] + (way->points[i + 1] - way->points[i]) * t;
      EXPECT_FALSE(std::abs(p.x - 2) < 0.8 && std::abs(p.y - 2) < 0.6) << p.x << ", " << p.y;
    }
  EXPECT_TRUE(map.doorsOn(way->points).empty());
}

TEST(WalkMap, WalksOverCarpetsAndUnderLamps) {
  Home home = twoRooms();
  test::addTable(home, {2, 2}, {2, 3}, 0.02);
  Furniture lamp;
  lamp.position = {2, 2, 2.0};
  lamp.size = {0.5, 0.5, 0.4};
  home.furniture.set(home.newId<FurnitureId>(), lamp);
  const WalkMap map(home, 0);
  EXPECT_TRUE(map.freeLine({0.6, 2}, {3.4, 2}));
  const auto way = map.way({0.6, 2}, {3.4, 2});
  ASSERT_TRUE(way);
  EXPECT_EQ(way->points.size(), 2u) << "straight on";
}

TEST(WalkMap, OverFurnitureOnlyWhereNothingLeadsRound) {
  Home home = twoRooms();
  test::addTable(home, {2, 2}, {1, 3.9});  // from wall to wall
  const auto way = WalkMap(home, 0).way({0.6, 2}, {3.4, 2});
  ASSERT_TRUE(way);
  EXPECT_TRUE(way->overFurniture);
  test::addTable(home, {2, 2}, {1, 3.9}, 2);  // a row of wardrobes
  EXPECT_FALSE(WalkMap(home, 0).way({0.6, 2}, {3.4, 2}));
}

TEST(WalkMap, StaysIndoorsWhereItCan) {
  Home home = twoRooms();
  Opening front;  // to the garden, from both rooms
  front.size = {0.9, 0.15, 2.1};
  for (const double x : {1.0, 7.0}) {
    front.position = {x, 0, 0};
    home.openings.set(home.newId<OpeningId>(), front);
  }
  const WalkMap map(home, 0);
  const auto way = map.way({1, 0.6}, {7, 0.6});
  ASSERT_TRUE(way);
  for (const Vec2& p : way->points) EXPECT_GT(p.y, 0);
  EXPECT_TRUE(map.indoors({1, 1}));
  EXPECT_FALSE(map.indoors({1, -1}));
  EXPECT_TRUE(map.way({1, -1}, {7, 1})) << "from the garden into the house";
}

TEST(WalkMap, StoreysAreApart) {
  Home home = twoRooms();
  Level ground, upper;
  upper.elevation = 2.7;
  home.levels.set(home.newId<LevelId>(), ground);
  home.levels.set(home.newId<LevelId>(), upper);
  EXPECT_DOUBLE_EQ(floorBelow(home, 1.6), 0);
  EXPECT_DOUBLE_EQ(floorBelow(home, 2.9), 0) << "near the ceiling";
  EXPECT_DOUBLE_EQ(floorBelow(home, 4.3), 2.7);
}

}  // namespace
}  // namespace idap
