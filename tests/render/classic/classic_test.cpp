#include "render/integrator/classic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace idap::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void expectColor(Rgb actual, Rgb wanted, float tolerance = 1e-4f) {
  EXPECT_NEAR(actual.x, wanted.x, tolerance);
  EXPECT_NEAR(actual.y, wanted.y, tolerance);
  EXPECT_NEAR(actual.z, wanted.z, tolerance);
}

// A square of side 2 * half around (0, 0, z) that faces up.
std::shared_ptr<const Mesh> square(float z, float half = 50) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

// Squares stacked by height, each with its own surface.
struct Stack {
  Scene scene;
  Stack& add(float z, Rgb color, ClassicSurface classic, float half = 50) {
    Surface surface;
    surface.baseColor = color;
    surface.classic = classic;
    const auto n = static_cast<std::uint32_t>(scene.meshes.size());
    scene.meshes.push_back(square(z, half));
    scene.surfaces.push_back(surface);
    Instance instance;
    instance.mesh = n;
    instance.surfaces = {n};
    scene.instances.push_back(instance);
    return *this;
  }
  Rgb trace(Vec3f from, Vec3f direction, std::vector<ClassicLight> lights) const {
    const CompiledScene compiled(std::make_shared<const Scene>(scene), 1);
    return ClassicTracer(compiled, std::move(lights)).trace({from, normalized(direction), 0, kInfinity});
  }
};

const Rgb kGreen{0.2f, 0.8f, 0.4f};
const Rgb kBackground{0.1f, 0.2f, 0.3f};
constexpr ClassicSurface kNothing{.ambient = 0, .diffuse = 0};

ClassicLight lampAt(Vec3f p, Rgb color = {1, 1, 1}) { return {.position = p, .color = color}; }

TEST(ClassicRay, PixelsMapOntoTheViewPlane) {
  // 8 x 4: sx = (px - 4) / 8, sy = (3 - py - 2) / 4.
  const ClassicCamera camera{{1, 2, 3}, {0, 2, 0}, {4, 0, 0}, {0, 0, 3}};
  const Ray corner = classicRay(0, 0, 8, 4, camera);
  EXPECT_EQ(corner.origin, (Vec3f{1, 2, 3}));
  const Vec3f wanted = normalized(Vec3f{-2, 2, 0.75f});
  EXPECT_NEAR(corner.direction.x, wanted.x, 1e-6);
  EXPECT_NEAR(corner.direction.y, wanted.y, 1e-6);
  EXPECT_NEAR(corner.direction.z, wanted.z, 1e-6);
  const Ray middle = classicRay(4, 1, 8, 4, camera);
  EXPECT_NEAR(middle.direction.y, 1, 1e-6);
}

TEST(ClassicRay, NegatingRightMirrorsThePicture) {
  ClassicCamera camera;
  const Vec3f d = classicRay(10, 3, 32, 20, camera).direction;
  camera.right = -camera.right;
  const Vec3f mirrored = classicRay(10, 3, 32, 20, camera).direction;
  EXPECT_FLOAT_EQ(d.x, -mirrored.x);
  EXPECT_FLOAT_EQ(d.z, mirrored.z);
}

TEST(ClassicRay, ACameraOfTodaySeesTheSame) {
  Camera camera;
  camera.horizontalFov = 1.2f;
  const ClassicCamera classic = classicCamera(camera, 1.5f);
  // The middle of the picture's left edge lies half the field of view to the left.
  const Vec3f left = classicRay(0, 99.5f - 0.5f, 300, 200, classic).direction;
  EXPECT_NEAR(std::atan2(-left.x, left.y), 0.6f, 1e-5);
  EXPECT_NEAR(length(classic.right) / length(classic.up), 1.5f, 1e-5);
}

TEST(ClassicShade, LambertAndBrilliance) {
  const Vec3f n{0, 0, 1}, toLight{0, 0.6f, 0.8f}, ray{0, 0, -1};
  expectColor(classicShade({.diffuse = 0.5f}, kGreen, {1, 0.5f, 1}, n, toLight, ray), {0.08f, 0.16f, 0.16f});
  // 0.8^3 = 0.512.
  expectColor(classicShade({.diffuse = 0.5f, .brilliance = 3}, kGreen, {1, 1, 1}, n, toLight, ray),
              kGreen * (0.5f * 0.512f));
}

TEST(ClassicShade, PhongHighlightHasTheColourOfTheLight) {
  const Vec3f n{0, 0, 1}, ray = normalized(Vec3f{0, 1, -1});
  const ClassicSurface shiny{.diffuse = 0, .specular = 0.6f, .roughness = 10};
  expectColor(classicShade(shiny, kGreen, {1, 0.5f, 0.25f}, n, normalized(Vec3f{0, 1, 1}), ray),
              Rgb{1, 0.5f, 0.25f} * 0.6f);
  // Straight above, 45 degrees off the mirrored ray: cos^10 = 1/32.
  expectColor(classicShade(shiny, kGreen, {1, 1, 1}, n, n, ray), Rgb{1, 1, 1} * (0.6f / 32));
}

TEST(ClassicShade, ALightBehindTheSurfaceGivesNothing) {
  expectColor(classicShade({.diffuse = 1, .specular = 1, .roughness = 1}, kGreen, {1, 1, 1}, {0, 0, 1},
                           {0, 0, -1}, {0, 0, -1}),
              {});
}

TEST(ClassicRefract, BendsBySnellsLaw) {
  const Vec3f n{0, 0, 1};
  const float in = 0.7f;
  Vec3f out;
  ASSERT_TRUE(classicRefract({std::sin(in), 0, -std::cos(in)}, n, 1 / 1.5f, out));
  EXPECT_NEAR(out.x, std::sin(in) / 1.5f, 1e-6);
  EXPECT_LT(out.z, 0);
  // Beyond the critical angle of glass, 41.8 degrees, nothing leaves.
  EXPECT_FALSE(classicRefract({std::sin(in + 0.1f), 0, -std::cos(in + 0.1f)}, n, 1.5f, out));
  ASSERT_TRUE(classicRefract({0.6f, 0, -0.8f}, n, 1, out));
  EXPECT_NEAR(out.x, 0.6f, 1e-6);
}

TEST(ClassicTracer, AmbientIsTheOwnColour) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0.25f, .diffuse = 0});
  expectColor(stack.trace({0, 0, 2}, {0, 0, -1}, {lampAt({0, 0, 5})}), kGreen * 0.25f);
}

TEST(ClassicTracer, LightsAddUpAndDoNotFade) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0, .diffuse = 0.5f});
  const ClassicLight near = lampAt({0, 0, 3}, {0.5f, 0.5f, 0.5f}),
                     far = lampAt({0, 0, 30}, {0.5f, 0.5f, 0.5f});
  expectColor(stack.trace({0, 1, 2}, {0, -0.5f, -1}, {near}), kGreen * 0.25f);
  expectColor(stack.trace({0, 1, 2}, {0, -0.5f, -1}, {near, far}), kGreen * 0.5f);
}

TEST(ClassicTracer, ABlockedLightCastsAHardShadow) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0.1f, .diffuse = 0.5f}).add(1, {1, 1, 1}, kNothing, 0.5f);
  const std::vector<ClassicLight> lights{lampAt({0, 0, 2})};
  expectColor(stack.trace({0.9f, 0, 0.5f}, {0, 0, -1}, lights), kGreen * 0.1f);
  EXPECT_GT(stack.trace({1.1f, 0, 0.5f}, {0, 0, -1}, lights).y, 0.2f);
}

TEST(ClassicTracer, TheSunShinesFromFarAway) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0, .diffuse = 1});
  const ClassicLight sun{.position = {0, 0.6f, 0.8f}, .color = {1, 1, 1}, .far = true};
  expectColor(stack.trace({7, 3, 2}, {0, 0, -1}, {sun}), kGreen * 0.8f);
}

TEST(ClassicTracer, NothingHitShowsTheBackground) {
  Stack stack;
  stack.add(0, kGreen, kNothing);
  stack.scene.classicBackground = kBackground;
  expectColor(stack.trace({0, 0, 2}, {0, 0, 1}, {}), kBackground);
}

TEST(ClassicTracer, AMirrorShowsWhatItReflects) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0, .diffuse = 0, .reflection = 0.5f});
  stack.scene.classicBackground = kBackground;
  expectColor(stack.trace({0, 0, 2}, {0, 1, -1}, {lampAt({0, 0, 5})}), kBackground * 0.5f);
}

TEST(ClassicTracer, TwoMirrorsStopAfterFiveReflections) {
  Stack stack;
  const ClassicSurface mirror{.ambient = 0.1f, .diffuse = 0, .reflection = 1};
  stack.add(0, {1, 1, 1}, mirror).add(1, {1, 1, 1}, mirror);
  // Six surfaces are seen: the first and five in mirrors.
  expectColor(stack.trace({0, 0, 0.5f}, {0, 0, -1}, {lampAt({20, 0, 0.5f})}), Rgb{1, 1, 1} * 0.6f);
}

TEST(ClassicTracer, ClearGlassShowsWhatLiesBehind) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0.5f, .diffuse = 0})
      .add(1, {1, 1, 1}, {.ambient = 0, .diffuse = 0, .transmission = 0.9f, .ior = 1});
  expectColor(stack.trace({0, 0, 2}, {0, 0.3f, -1}, {}), kGreen * 0.45f);
}

TEST(ClassicTracer, GlassBendsTheRay) {
  // Under a glass face at z = 1 the ray at 45 degrees runs at asin(sin 45 / 1.5) = 28.13 degrees and lands
  // 0.535 m on; straight on it would have landed 1 m on.
  Stack stack;
  const ClassicSurface glow{.ambient = 1, .diffuse = 0};
  stack.add(0, kGreen, glow, 0.6f)
      .add(1, {1, 1, 1}, {.ambient = 0, .diffuse = 0, .transmission = 1, .ior = 1.5f});
  stack.scene.classicBackground = kBackground;
  expectColor(stack.trace({0, -1, 2}, {0, 1, -1}, {}), kGreen);
  stack.scene.surfaces[1].classic.ior = 1;
  expectColor(stack.trace({0, -1, 2}, {0, 1, -1}, {}), kBackground);
}

TEST(ClassicTracer, WithoutLightsTheEyeCarriesOne) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 0, .diffuse = 1});
  expectColor(stack.trace({0, 0, 2}, {0, 0, -1}, {}), kGreen);
}

TEST(ClassicTracer, CutOutsAreSeenThroughAndShiningThingsShine) {
  Stack stack;
  stack.add(0, kGreen, {.ambient = 1, .diffuse = 0}).add(1, {1, 1, 1}, {.ambient = 1});
  stack.scene.surfaces[1].opacity = 0;
  expectColor(stack.trace({0, 0, 2}, {0, 0, -1}, {}), kGreen);
  stack.scene.surfaces[1].opacity = 1;
  stack.scene.surfaces[1].emission = {5000, 5000, 5000};
  expectColor(stack.trace({0, 0, 2}, {0, 0, -1}, {}), {1, 1, 1});
}

TEST(ClassicLights, OneLampOfAnyPowerIsAsBrightAsColoursGo) {
  for (float candela : {5.0f, 5000.0f}) {
    Scene scene;
    scene.lamps.push_back({.position = {0, 0, 2}, .intensity = {candela, candela, candela}});
    const auto lights = classicLights(scene);
    ASSERT_EQ(lights.size(), 1u);
    expectColor(lights[0].color, {1, 1, 1});
  }
}

TEST(ClassicLights, LampsOfOneRoomShareAndThoseFarAwayDoNot) {
  Scene scene;
  scene.lamps.assign(4, {.position = {0, 0, 2}, .intensity = {80, 80, 80}});
  EXPECT_NEAR(classicLights(scene)[0].color.x, 0.45f, 1e-4);
  for (std::size_t i = 0; i < 4; ++i) scene.lamps[i].position.x = 30.0f * static_cast<float>(i);
  EXPECT_GT(classicLights(scene)[0].color.x, 0.99f);
}

TEST(ClassicLights, WarmLampsTintALittleAndTheSunIsFarAway) {
  Scene scene;
  scene.lamps.push_back({.position = {0, 0, 2}, .intensity = {100, 60, 20}});
  scene.sun = {.direction = {0, 0, 1}, .illuminance = {90'000, 90'000, 90'000}};
  const auto lights = classicLights(scene);
  ASSERT_EQ(lights.size(), 2u);
  expectColor(lights[0].color, {1, 0.86f, 0.72f});
  EXPECT_TRUE(lights[1].far);
  expectColor(lights[1].color, {1, 1, 1});
}

TEST(ClassicLights, DarkScenesHaveNone) { EXPECT_TRUE(classicLights(Scene()).empty()); }

}  // namespace
}  // namespace idap::render
