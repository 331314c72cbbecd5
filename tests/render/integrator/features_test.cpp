#include "render/integrator/features.h"

#include <gtest/gtest.h>

#include "render/scene_parts.h"

namespace idap::render {
namespace {

using namespace test;

// Two sheets 2 m before the eye: the left red, the right red too, but shining.
Features twoSheets() {
  SceneMaker make;
  Surface red = lambert({0.8f, 0.1f, 0.1f}), shining = red;
  shining.emission = grey(500);
  make.add(parallelogram({-1, 2, -1}, {1, 0, 0}, {0, 0, 2}), red);
  make.add(parallelogram({0, 2, -1}, {1, 0, 0}, {0, 0, 2}), shining);
  const auto scene = make.compile();
  Camera camera;
  camera.eye = {0, 0, 0};
  camera.forward = {0, 1, 0};
  camera.up = {0, 0, 1};
  camera.horizontalFov = 0.6f;
  return features(*scene, camera, 40, 20, 1);
}

TEST(Features, TellDistanceAndPaintOfWhatIsSeen) {
  const Features f = twoSheets();
  const std::size_t i = f.index(10, 10);
  EXPECT_NEAR(f.depth[i], 2, 0.1);
  EXPECT_NEAR(f.normal[i].y, -1, 1e-4);
  EXPECT_NEAR(f.albedo[i].x, 0.8f, 1e-5f);
  EXPECT_NEAR(f.albedo[i].y, 0.1f, 1e-5f);
}

// Its colour is that of its light; multiplied by its paint as well, enlarged lampshades were too red.
TEST(Features, WhatShinesIsWhite) {
  const Features f = twoSheets();
  EXPECT_EQ(f.albedo[f.index(30, 10)], (Rgb{1, 1, 1}));
}

}  // namespace
}  // namespace idap::render
