#include "editor/view/camera_motion.h"

#include <gtest/gtest.h>

#include "support/wall_chain.h"

namespace idap {
namespace {

TEST(CameraMotion, TheMiddleOfThePictureLooksAlongTheView) {
  Camera camera;
  camera.yaw = 0.4, camera.pitch = 0.2;
  EXPECT_LT(length(rayThrough(camera, 1.6, {0.5, 0.5}).direction - viewDirection(camera)), 1e-12);
  const ViewRay right = rayThrough(camera, 1.6, {1, 0.5});
  EXPECT_NEAR(std::acos(dot(right.direction, viewDirection(camera))), camera.fieldOfView / 2, 1e-9);
}

TEST(CameraMotion, OrbitingKeepsTheDistanceToThePoint) {
  Camera camera;
  camera.eye = {3, -2, 5};
  camera.pitch = 0.8;
  const Vec3 about{1, 1, 0.5};
  const Camera there = orbited(camera, about, 0.7, -0.3);
  EXPECT_NEAR(length(there.eye - about), length(camera.eye - about), 1e-9);
  EXPECT_GT(length(there.eye - camera.eye), 0.5);
}

TEST(CameraMotion, WallsStopAWalkerAndDoorsDoNot) {
  Home home;
  test::addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  const Vec3 from{2, 1, 1.6};
  EXPECT_GT(keptOutOfWalls(home, from, {2, -0.05, 1.6}).y, 0.2);
  EXPECT_EQ(keptOutOfWalls(home, from, {2, -3, 1.6}), from) << "no jump through a wall";
  Opening door;
  door.kind = OpeningKind::Door;
  door.wall = home.walls.begin()->first;
  door.position = {2, 0, 0};
  door.size = {0.9, 0.1, 2};
  home.openings.set(home.newId<OpeningId>(), door);
  EXPECT_NEAR(keptOutOfWalls(home, from, {2, -0.05, 1.6}).y, -0.05, 1e-9);
}

}  // namespace
}  // namespace idap
