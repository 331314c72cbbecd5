#include "scene/ground_builder.h"

#include <gtest/gtest.h>

#include "scene/scene_test_support.h"

namespace idap {
namespace {

const Box2 kHome{{-5, -4}, {5, 4}};
const Rgb kHaze{0.3f, 0.35f, 0.4f};

TEST(GroundBuilder, FadesFromItsColourIntoTheHazeOfTheHorizon) {
  render::Surface soil;
  soil.baseColor = {0.1f, 0.3f, 0.05f};
  const Ground ground = buildGround(soil, {}, kHome, 0, kHaze, {});
  const auto look = [&](const render::Surface& s) { return s.baseColor * meanReflectance(*s.baseColorMap); };
  const Rgb close = look(ground.surfaces.front()), far = look(ground.surfaces.back());
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(close[k], soil.baseColor[k], 0.05f * soil.baseColor[k] + 0.003f);
    EXPECT_NEAR(far[k], kHaze[k], 0.03f);
  }
  for (std::size_t i = 1; i < ground.surfaces.size(); ++i) {
    EXPECT_LT(std::abs(luminance(look(ground.surfaces[i])) - luminance(look(ground.surfaces[i - 1]))), 0.02f);
  }
}

TEST(GroundBuilder, CoversTheLandOnceUpToTheHorizonAndStaysOpenOverACellar) {
  const Regions cellar{{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}}};
  const Ground ground = buildGround({}, cellar, kHome, -0.1, kHaze, {});
  int over[3] = {0, 0, 0};
  const Vec2 points[3] = {{0, 0}, {3, 3}, {800, -300}};
  for (const auto& t : ground.mesh->triangles) {
    Polygon p;
    for (const auto v : t)
      p.push_back({double(ground.mesh->positions[v].x), double(ground.mesh->positions[v].y)});
    EXPECT_GT(signedArea(p), 0) << "seen from above";
    for (int i = 0; i < 3; ++i) over[i] += contains(p, points[i]);
  }
  EXPECT_EQ(over[0], 0);
  EXPECT_EQ(over[1], 1);
  EXPECT_EQ(over[2], 1);
}

TEST(GroundBuilder, ATextureOfTheHomesOwnStaysInItsScale) {
  render::Surface soil;
  auto picture = std::make_shared<render::Texture>();
  picture->width = picture->height = 1;
  picture->rgba = {200, 180, 160, 255};
  soil.baseColorMap = picture;
  soil.uvScale = {0.5f, 0.5f};
  const Ground ground = buildGround(soil, {}, kHome, 0, kHaze, {});
  EXPECT_EQ(ground.surfaces.front().baseColorMap, picture);
  EXPECT_FLOAT_EQ(ground.surfaces.front().uvScale.x, 0.5f);
  EXPECT_EQ(ground.surfaces.front().baseColor, soil.baseColor);
}

TEST(GroundBuilder, SnowReflectsNoMoreThanItGets) {
  render::Surface soil;
  soil.baseColor = {0.82f, 0.82f, 0.82f};
  for (const render::Surface& s : buildGround(soil, {}, kHome, 0, {0.9f, 0.9f, 0.9f}, {}).surfaces)
    EXPECT_LE(maxComponent(s.baseColor), 1.0f);
}

}  // namespace
}  // namespace idap
