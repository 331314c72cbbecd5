#include "render/integrator/outlook.h"

#include <gtest/gtest.h>

#include "render/sampling/sampler.h"
#include "render/sampling/warp.h"
#include "render/scene_parts.h"
#include "render/session/render_job.h"

namespace idap::render {
namespace {

using namespace test;

// A room whose wall at +x has a window; the sun falls through it onto the floor.
std::unique_ptr<CompiledScene> sunnyRoom(bool glazed) {
  SceneMaker make;
  Mesh shell = boxMesh({0, 0, 0}, {4, 4, 2.5f}, true);
  std::vector<std::uint32_t> surfaces(6, make.surface(lambert(grey(0.6f))));
  surfaces[1] = make.surface([] {
    Surface open;
    open.opacity = 0;
    return open;
  }());
  make.add(std::move(shell), surfaces);
  make.add(parallelogram({4, 0, 0}, {0, 4, 0}, {0, 0, 1}), lambert(grey(0.6f)));
  make.add(parallelogram({4, 0, 2}, {0, 4, 0}, {0, 0, 0.5f}), lambert(grey(0.6f)));
  if (glazed) {
    Surface pane;
    pane.baseColor = grey(1);
    pane.transmission = 1;
    pane.roughness = 0;
    make.add(parallelogram({4.02f, 0, 1}, {0, 4, 0}, {0, 0, 1}), pane);
  }
  make.scene().sun = {normalized(Vec3f{1, 0, 1}), grey(50'000)};
  make.scene().sky = {8, 4, std::vector<Rgb>(32, grey(3000))};
  make.scene().portals.push_back({{4, 0, 1}, {0, 4, 0}, {0, 0, 1}});
  return make.compile();
}

TEST(Outlook, DensitiesAreThoseOfTheDirectionsSampled) {
  const auto scene = sunnyRoom(false);
  const Outlook outlook(*scene, {{1, 2, 2.5f}, {0, 0, -1}});
  // The mean of 1 / pdf over samples is the solid angle that they cover; pdf() must agree with sample().
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2f u = hammersley(i, 500);
    Vec3f d;
    float pdf = 0;
    if (!outlook.sample((static_cast<float>(i * 37 % 500) + 0.5f) / 500, u, d, pdf)) continue;
    ++found;
    EXPECT_NEAR(length(d), 1, 1e-4f);
    EXPECT_NEAR(outlook.pdf(d) / pdf, 1, 1e-3f);
  }
  EXPECT_GT(found, 400);
  double integral = 0;
  for (int i = 0; i < 200'000; ++i) {
    const Vec2f u = hammersley(i, 200'000);
    const float z = 2 * u.x - 1, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * kPiF * u.y;
    integral += static_cast<double>(outlook.pdf({r * std::cos(phi), r * std::sin(phi), z}));
  }
  EXPECT_NEAR(integral / 200'000 * 4 * kPi, 1, 0.02);
}

// A look from one point.
struct SeenOnce {
  Rgb sky, sun;
};
SeenOnce lookOnce(const CompiledScene& scene, Vec3f origin, Vec3f direction, Vec2f u, std::uint64_t& rays) {
  LaneMask one(false);
  one[0] = true;
  const LookDraws draws{{u.x, u.y}, {u.x, u.y}, 0.5f};
  const Seen seen = look(scene, one, toLanes(origin), toLanes(direction), draws, rays);
  return {lane(seen.sky, 0), lane(seen.sun, 0)};
}

TEST(Outlook, ALookSeesTheSunOnTheFloorAndTheSkyThroughGlass) {
  for (const bool glazed : {false, true}) {
    const auto scene = sunnyRoom(glazed);
    Sampler sampler(0, 0, 0, 0, 0);
    std::uint64_t rays = 0;
    // The sun at 45 degrees reaches from x = 2 to x = 3 on the floor.
    const auto onFloor = lookOnce(*scene, {2.5f, 2, 2}, {0, 0, -1}, sampler.get2D(), rays);
    const float through = glazed ? 0.9f : 1.0f;
    EXPECT_NEAR(luminance(onFloor.sun), 50'000 * std::sqrt(0.5f) * 0.6f / kPiF * through, glazed ? 300 : 50);
    EXPECT_EQ(luminance(onFloor.sky), 0);
    EXPECT_EQ(luminance(lookOnce(*scene, {1, 2, 2}, {0, 0, -1}, sampler.get2D(), rays).sun), 0);
    const auto out = lookOnce(*scene, {1, 2, 1.5f}, {1, 0, 0}, sampler.get2D(), rays);
    EXPECT_NEAR(luminance(out.sky), 3000 * (glazed ? 0.92f : 1.0f), 60);
    EXPECT_GE(rays, 4);
  }
}

// A wall lamp: a box open at the top, 30 cm wide, with a bulb at its bottom, in a closed room.
SceneMaker uplight() {
  SceneMaker make;
  make.add(boxMesh({0, 0, 0}, {4, 3, 2.5f}, true), lambert(grey(0.6f)));
  const auto side = [&](Vec3f corner, Vec3f u, Vec3f v) {
    make.add(parallelogram(corner, u, v), lambert(grey(0.7f)));
  };
  const Vec3f x{0.3f, 0, 0}, y{0, 0.3f, 0}, z{0, 0, 0.14f};
  const Vec3f a{1.85f, 0.2f, 1.5f};
  side(a, x, y);
  side(a, x, z);
  side(a + y, x, z);
  side(a, y, z);
  side(a + x, y, z);
  make.scene().lamps.push_back({.position = {2, 0.35f, 1.56f}, .radius = 0.03f, .intensity = grey(80)});
  return make;
}

TEST(Outlook, LooksIntoLampsFindTheSameLightWithLessNoise) {
  const auto scene = uplight().compile();
  ASSERT_TRUE(scene->lights().sunPatches().hasLamps());
  Camera camera;
  camera.eye = {0.4f, 2.7f, 1.2f};
  camera.forward = normalized(Vec3f{1, -0.9f, 0});
  RenderSettings settings{.width = 24, .height = 16, .spp = 16384, .looks = false};
  Film truth(24, 16), plain(24, 16), looking(24, 16);
  render(*scene, camera, settings, truth);
  settings.spp = 2048;
  settings.seed = 7;
  render(*scene, camera, settings, plain);
  settings.looks = true;
  render(*scene, camera, settings, looking);
  double mean = 0, meanLooking = 0, noise = 0, noiseLooking = 0;
  for (std::size_t i = 0; i < truth.pixels(); ++i) {
    const auto at = [&](const Film& f) { return static_cast<double>(luminance(f.meanColor(i))); };
    mean += at(truth), meanLooking += at(looking);
    noise += std::pow(at(plain) / at(truth) - 1, 2), noiseLooking += std::pow(at(looking) / at(truth) - 1, 2);
  }
  EXPECT_NEAR(meanLooking / mean, 1, 0.015);
  EXPECT_LT(noiseLooking, 0.6 * noise);
}

TEST(Outlook, LampsAreLookedAtAfterDarkOnly) {
  SceneMaker make = uplight();
  make.scene().sky = {8, 4, std::vector<Rgb>(32, grey(3000))};
  make.scene().portals.push_back({{4, 0, 1}, {0, 3, 0}, {0, 0, 1}});
  EXPECT_FALSE(make.compile()->lights().sunPatches().hasLamps());
}

}  // namespace
}  // namespace idap::render
