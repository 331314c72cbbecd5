#include "model/wall_path.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

void expectNear(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}

Wall wallOf(Vec2 start, Vec2 end, double arc = 0) {
  Wall wall;
  wall.start = start;
  wall.end = end;
  wall.arcExtent = arc;
  return wall;
}

TEST(WallPath, FollowsAStraightWall) {
  const WallPath path(wallOf({1, 1}, {4, 5}));
  EXPECT_DOUBLE_EQ(path.length(), 5);
  expectNear(path.point(2.5), {2.5, 3});
  expectNear(path.direction(1), {0.6, 0.8});
  EXPECT_NEAR(path.nearest({2.5 - 0.8, 3 + 0.6}), 2.5, 1e-12);
  EXPECT_EQ(path.nearest({-9, -9}), 0);
  expectNear(path.face(0.5).front(), {1 - 0.4, 1 + 0.3});
}

TEST(WallPath, AHalfCircleTurnsLeftForAPositiveSweep) {
  const WallPath path(wallOf({0, 0}, {2, 0}, kPi));
  EXPECT_NEAR(path.length(), kPi, 1e-12);
  expectNear(path.direction(0), {0, -1});  // going left all the way, it bulges to the right
  expectNear(path.point(kPi / 2), {1, -1});
  expectNear(path.point(path.length()), {2, 0});
  expectNear(path.direction(path.length()), {0, 1});
  EXPECT_NEAR(path.nearest({1, -3}), kPi / 2, 1e-12);
  for (const Vec2 p : path.face(0.25)) EXPECT_NEAR(length(p - Vec2{1, 0}), 0.75, 1e-12);
  for (const Vec2 p : path.face(5)) EXPECT_NEAR(length(p - Vec2{1, 0}), 0, 1e-9) << "not past the centre";
}

TEST(WallPath, AQuarterCircleToTheRightMirrorsOneToTheLeft) {
  const WallPath left(wallOf({0, 0}, {2, 0}, kPi / 2)), right(wallOf({0, 0}, {2, 0}, -kPi / 2));
  for (const double share : {0.0, 0.2, 0.5, 1.0}) {
    const Vec2 a = left.point(left.length() * share), b = right.point(right.length() * share);
    expectNear({a.x, -a.y}, b);
    EXPECT_NEAR(right.nearest(b), right.length() * share, 1e-9);
  }
}

}  // namespace
}  // namespace idap
