#include "editor/plane.h"

#include <gtest/gtest.h>

namespace idap {

TEST(Plane, LooksAlongTheAxesThatItSays) {
  const Vec3 p{1, 2, 3};
  EXPECT_EQ(project(Plane::XY, p), (Vec2{1, 2}));
  EXPECT_EQ(project(Plane::XZ, p), (Vec2{1, 3}));
  EXPECT_EQ(project(Plane::YZ, p), (Vec2{2, 3}));
  EXPECT_GT(nearness(Plane::XZ, {0, -1, 0}), nearness(Plane::XZ, {0, 1, 0}));  // seen from the front
  EXPECT_GT(nearness(Plane::YZ, {1, 0, 0}), nearness(Plane::YZ, {-1, 0, 0}));  // from the right
  for (const Plane plane : kPlanes) EXPECT_EQ(project(plane, inWorld(plane, {4, 5})), (Vec2{4, 5}));
}

TEST(Plane, OutlinesAPieceOnEveryPlane) {
  Piece piece;
  piece.position = {1, 2, 0.5};
  piece.size = {2, 1, 0.4};
  const Box2 plan = bounds(outline(Plane::XY, piece, 3));
  EXPECT_NEAR(plan.min.x, 0, 1e-9);
  EXPECT_NEAR(plan.max.y, 2.5, 1e-9);
  const Box2 side = bounds(outline(Plane::YZ, piece, 3));
  EXPECT_NEAR(side.min.x, 1.5, 1e-9);
  EXPECT_NEAR(side.min.y, 3.5, 1e-9);
  EXPECT_NEAR(side.max.y, 3.9, 1e-9);
  piece.angle = kPi / 4;
  EXPECT_EQ(outline(Plane::XY, piece, 0).size(), 4u);
  EXPECT_NEAR(signedArea(outline(Plane::XY, piece, 0)), 2, 1e-9);
}

TEST(Plane, TiltedPieceShowsMoreThanItsTop) {
  Piece piece;
  piece.size = {1, 1, 1};
  piece.pitch = kPi / 4;
  const Box2 plan = bounds(outline(Plane::XY, piece, 0));
  EXPECT_NEAR(plan.max.y - plan.min.y, std::sqrt(2), 1e-9);
  EXPECT_NEAR(plan.max.x - plan.min.x, 1, 1e-9);
}

TEST(Plane, DistancesToLines) {
  EXPECT_NEAR(distanceToSegment({1, 1}, {0, 0}, {2, 0}), 1, 1e-12);
  EXPECT_NEAR(distanceToSegment({3, 0}, {0, 0}, {2, 0}), 1, 1e-12);
  EXPECT_NEAR(distanceToSegment({3, 0}, {0, 0}, {0, 0}), 3, 1e-12);
  const std::vector<Vec2> corner{{0, 0}, {2, 0}, {2, 2}};
  EXPECT_NEAR(distanceToPath(corner, false, {0.5, 1}), 1, 1e-12);
  EXPECT_NEAR(distanceToPath(corner, true, {1, 1}), 0, 1e-12);
}

}  // namespace idap
