#include "model/wall_outline.h"

#include <gtest/gtest.h>

#include "support/wall_chain.h"

namespace idap {
namespace {

using test::addWalls;
using test::wall;

WallOutline outline(const Home& home, WallId id) { return wallOutline(home, id, *home.walls.find(id)); }

TEST(WallOutline, AFreeWallIsARectangle) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {3, 0}}, false);
  const Polygon p = outline(home, ids[0]).polygon();
  EXPECT_EQ(p, (Polygon{{0, -0.1}, {3, -0.1}, {3, 0.1}, {0, 0.1}}));
}

// Two walls that meet at an angle between 30 and 150 degrees: neither gap nor overlap, and the outside corner
// lies where both outer faces meet.
class Corner : public testing::TestWithParam<double> {};

TEST_P(Corner, MitresShareTheirLineAndLeaveNoGap) {
  const double angle = GetParam() * kPi / 180;
  for (const double turn : {1.0, -1.0}) {
    Home home;
    const Vec2 away = rotated(Vec2{-1, 0}, turn * angle);
    const auto ids = addWalls(home, {{-3, 0}, {0, 0}, Vec2{0, 0} + away * 3}, false);
    const Polygon a = outline(home, ids[0]).polygon(), b = outline(home, ids[1]).polygon();
    EXPECT_NEAR(area(intersect({{a, {}}}, {{b, {}}})), 0, 1e-9);
    // Mitring moves material from inside to outside: together they are as large as two plain walls.
    EXPECT_NEAR(area(unite({a, b})), 2 * 3 * 0.2, 1e-6);
    int shared = 0;
    for (const Vec2& p : a) {
      for (const Vec2& q : b) shared += length(p - q) < 1e-9;
    }
    EXPECT_EQ(shared, 2);
  }
}
INSTANTIATE_TEST_SUITE_P(Angles, Corner, testing::Values(30.0, 45.0, 90.0, 120.0, 150.0, 179.0));

TEST(WallOutline, AVerySharpCornerIsCutOff) {
  Home home;
  const Vec2 away = rotated(Vec2{-1, 0}, 15 * kPi / 180);
  const auto ids = addWalls(home, {{-3, 0}, {0, 0}, away * 3}, false);
  const Polygon a = outline(home, ids[0]).polygon(), b = outline(home, ids[1]).polygon();
  EXPECT_LT(bounds(a).max.x, 0.45);  // a full tip would reach 0.77 m
  EXPECT_EQ(unite({a, b}).size(), 1u);
  EXPECT_NEAR(area(intersect({{a, {}}}, {{b, {}}})), 0, 1e-9);
}

TEST(WallOutline, WallsMayMeetStartToStart) {
  Home home;
  const WallId a = home.newId<WallId>(), b = home.newId<WallId>();
  Wall first = wall({0, 0}, {3, 0}), second = wall({0, 0}, {0, 3});
  first.neighbourAtStart = b;
  second.neighbourAtStart = a;
  home.walls.set(a, first);
  home.walls.set(b, second);
  const Regions all = unite({outline(home, a).polygon(), outline(home, b).polygon()});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(area(all), 3.1 * 0.2 + 2.9 * 0.2, 1e-9);
  EXPECT_NEAR(bounds(all[0].outer).min.x, -0.1, 1e-9);
  EXPECT_NEAR(bounds(all[0].outer).min.y, -0.1, 1e-9);
}

TEST(WallOutline, DifferentThicknessesMeetInTheirCorners) {
  Home home;
  auto ids = addWalls(home, {{0, 0}, {4, 0}, {4, 3}}, false);
  Wall thick = *home.walls.find(ids[1]);
  thick.thickness = 0.4;
  home.walls.set(ids[1], thick);
  const Regions all = unite({outline(home, ids[0]).polygon(), outline(home, ids[1]).polygon()});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(bounds(all[0].outer).max.x, 4.2, 1e-9);
  EXPECT_NEAR(bounds(all[0].outer).min.y, -0.1, 1e-9);
  EXPECT_NEAR(area(all), 4.2 * 0.2 + 0.4 * 2.9, 1e-9);
}

TEST(WallOutline, WallsInOneLineTouch) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {2, 0}, {5, 0.0001}}, false);
  const Polygon a = outline(home, ids[0]).polygon(), b = outline(home, ids[1]).polygon();
  EXPECT_EQ(unite({a, b}).size(), 1u);
  EXPECT_NEAR(a[1].x, b[0].x, 1e-12);
}

TEST(WallOutline, AWallThatEndsInTheMiddleOfAnotherStaysSquare) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {6, 0}}, false);
  const WallId t = home.newId<WallId>();
  Wall stem = wall({3, 2}, {3, 0});
  stem.neighbourAtEnd = ids[0];
  home.walls.set(t, stem);
  const Regions all = unite({outline(home, ids[0]).polygon(), outline(home, t).polygon()});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NEAR(area(all), 6 * 0.2 + 1.9 * 0.2, 1e-9);
}

TEST(WallOutline, RoundWallsKeepWithinAMillimetreOfTheArc) {
  Home home;
  const auto ids = addWalls(home, {{-2, 0}, {2, 0}}, false);
  Wall round = *home.walls.find(ids[0]);
  round.arcExtent = -kPi;  // half a circle that turns right: over the top
  home.walls.set(ids[0], round);
  const WallOutline o = outline(home, ids[0]);
  const auto check = [](const std::vector<Vec2>& line, double radius) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      EXPECT_NEAR(length(line[i]), radius, 1e-9);
      EXPECT_GT(length((line[i] + line[i + 1]) / 2), radius - 0.002);
    }
  };
  check(o.left, 2.1);
  check(o.right, 1.9);
  EXPECT_GT(o.left[o.left.size() / 2].y, 0);
  EXPECT_NEAR(signedArea(o.polygon()), kPi / 2 * (2.1 * 2.1 - 1.9 * 1.9), 0.01);
  EXPECT_NEAR(alongWall(round, {0, 2}), 0.5, 1e-9);
  EXPECT_NEAR(alongWall(round, {-2, 0}), 0, 1e-9);
}

TEST(WallOutline, RoundWallsAreJoinedToStraightOnes) {
  Home home;
  const auto ids = addWalls(home, {{-3, 0}, {0, 0}, {3, 0}}, false);
  Wall round = *home.walls.find(ids[1]);
  round.arcExtent = -kPi / 2;
  home.walls.set(ids[1], round);
  const Polygon a = outline(home, ids[0]).polygon(), b = outline(home, ids[1]).polygon();
  EXPECT_EQ(unite({a, b}).size(), 1u);
  EXPECT_LT(area(intersect({{a, {}}}, {{b, {}}})), 2e-4);
}

TEST(WallOutline, DegenerateWallsDoNoHarm) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {0, 0}, {0, 0}});
  for (const WallId id : ids) EXPECT_NO_THROW(outline(home, id).polygon());
  Wall self = wall({0, 0}, {1, 0});
  self.neighbourAtStart = self.neighbourAtEnd = ids[0];
  self.arcExtent = 100;
  home.walls.set(ids[0], self);
  EXPECT_NO_THROW(outline(home, ids[0]).polygon());
}

}  // namespace
}  // namespace idap
