#include "render/emitter/lights.h"

#include <gtest/gtest.h>

#include "render/chi_square.h"
#include "render/emitter/lamp.h"
#include "render/sampling/warp.h"
#include "render/scene_parts.h"
#include "render/session/illuminance.h"

namespace idap::render {
namespace {

using namespace test;

TEST(LightTree, ProbabilitiesAddUpAndAgreeWithChoices) {
  std::vector<LightBounds> lights;
  for (int i = 0; i < 100; ++i) {
    const Vec2f u = hammersley(i, 100);
    LightBounds b;
    b.box.add(Vec3f{10 * u.x, 10 * u.y, 2.5f});
    b.box.add(Vec3f{10 * u.x + 0.1f, 10 * u.y, 2.6f});
    b.axis = normalized(Vec3f{u.x - 0.5f, u.y - 0.5f, -0.3f});
    b.cosSpread = i % 3 == 0 ? -1.0f : 0.9f;
    b.bothSides = i % 5 == 0;
    b.intensity = 1.0f + static_cast<float>(i % 7);
    lights.push_back(b);
  }
  const LightTree tree(lights);
  for (const Vec3f p : {Vec3f{5, 5, 0}, Vec3f{0, 9, 2.55f}, Vec3f{40, -3, 1}}) {
    const Receiver at{p, {0, 0, 1}};
    double sum = 0;
    for (std::uint32_t i = 0; i < lights.size(); ++i) sum += static_cast<double>(tree.probability(at, i));
    EXPECT_LE(sum, 1.0001);
    for (int i = 0; i < 200; ++i) {
      const auto choice = tree.choose(at, (static_cast<float>(i) + 0.5f) / 200);
      if (choice.probability <= 0) continue;
      EXPECT_NEAR(choice.probability, tree.probability(at, choice.light), 1e-4f);
      EXPECT_TRUE(choice.u >= 0 && choice.u < 1);
    }
  }
}

TEST(LightTree, PrefersWhatIsNearAndFacesThePoint) {
  SceneMaker make;
  make.scene().lamps.push_back({.position = {0, 0, 2}, .intensity = grey(100)});
  make.scene().lamps.push_back({.position = {8, 0, 2}, .intensity = grey(100)});
  make.scene().lamps.push_back(
      {.position = {0, 0, 2}, .intensity = grey(100), .axis = {0, 0, 1}, .lambertian = true});
  const auto scene = make.compile();
  int near = 0;
  for (int i = 0; i < 1000; ++i) {
    LightSample s;
    if (scene->lights().local().sample({{0, 0, 0}, {0, 0, 1}}, (static_cast<float>(i) + 0.5f) / 1000,
                                       {0.5f, 0.5f}, s))
      near += s.distance < 3;
  }
  EXPECT_GT(near, 900);
}

TEST(Lamp, FluxIsTheIntegralOfIntensity) {
  for (const float beam : {0.3f, 1.0f, 2.0f})
    for (const bool lambertian : {false, true}) {
      const Lamp lamp{.position = {},
                      .intensity = grey(100),
                      .axis = normalized(Vec3f{1, 2, -2}),
                      .beamAngle = beam,
                      .lambertian = lambertian};
      double sum = 0;
      constexpr int n = 20000;
      for (int i = 0; i < n; ++i)
        sum += static_cast<double>(lampIntensity(lamp, uniformCone(hammersley(i, n), 2.0f)).y) * 4 * kPi / n;
      EXPECT_NEAR(sum, static_cast<double>(lampFlux(lamp).y), 0.01 * sum) << beam << lambertian;
    }
}

TEST(Lamp, SpotHasHalfItsIntensityAtTheEdgeOfItsBeam) {
  const Lamp spot{.position = {}, .intensity = grey(100), .axis = {0, 0, -1}, .beamAngle = 0.6f};
  EXPECT_NEAR(lampIntensity(spot, {std::sin(0.3f), 0, -std::cos(0.3f)}).x, 50, 0.01f);
  EXPECT_NEAR(lampIntensity(spot, {0, 0, -1}).x, 100, 0.01f);
  EXPECT_EQ(lampIntensity(spot, {0, 0, 1}).x, 0);
}

TEST(LocalLights, LampSphereIsSampledByTheSolidAngleItClaims) {
  SceneMaker make;
  make.scene().lamps.push_back({.position = {0, 0, 2}, .radius = 1.2f, .intensity = grey(10)});
  const auto scene = make.compile();
  const LocalLights& lights = scene->lights().local();
  const Receiver at{{}, {0, 0, 1}};
  expectMatchingDensity(
      [&](float a, float b, float c) {
        LightSample s;
        const bool ok = lights.sample(at, a, {b, c}, s);
        return std::pair(s.wi, ok);
      },
      [&](Vec3f d) {
        Hit hit;
        return scene->intersect({{}, d}, hit, kBounceRay) && hit.isLamp() ? lights.pdfLamp(at, hit.lamp)
                                                                          : 0.0f;
      },
      96, 48);
}

TEST(LocalLights, EmissiveMeshIsSampledWithTheDensityRaysFind) {
  SceneMaker make;
  make.add(parallelogram({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}), lambert({}, grey(10)),
           Transformf::rotationX(0.3f));
  make.add(boxMesh({1.5f, -0.5f, 0.5f}, {2.5f, 0.5f, 1.5f}), lambert({}, grey(20)));
  const auto scene = make.compile();
  const LocalLights& lights = scene->lights().local();
  const Receiver at{{}, {0, 0, 1}};
  expectMatchingDensity(
      [&](float a, float b, float c) {
        LightSample s;
        Hit hit;
        // What lies behind another light counts for rays only.
        const bool ok =
            lights.sample(at, a, {b, c}, s) && !scene->occluded({{}, s.wi, 0, s.distance * 0.999f});
        return std::pair(s.wi, ok);
      },
      [&](Vec3f d) {
        const Ray ray{{}, d};
        Hit hit;
        return scene->intersect(ray, hit, kBounceRay)
                   ? lights.pdfTriangle(at, ray, hit, scene->interaction(ray, hit).frontFace)
                   : 0.0f;
      },
      48, 96);
}

TEST(LocalLights, ShellsAreRecognized) {
  EXPECT_TRUE(outsideOfClosedShells(boxMesh({0, 0, 0}, {1, 1, 1}))[0]);
  EXPECT_FALSE(outsideOfClosedShells(boxMesh({0, 0, 0}, {1, 1, 1}, true))[0]) << "its front is inside";
  EXPECT_TRUE(outsideOfClosedShells(sphereMesh({5, 5, 5}, 0.1f, 6))[3]);
  EXPECT_FALSE(outsideOfClosedShells(parallelogram({}, {1, 0, 0}, {0, 1, 0}))[1]);
  Mesh open = boxMesh({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  open.slots.pop_back();
  EXPECT_FALSE(outsideOfClosedShells(open)[0]);
}

Sky patchySky() {
  Sky sky;
  sky.width = 32;
  sky.height = 16;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      sky.radiance.push_back(grey(y < 8 ? 100.0f + static_cast<float>((x * 7 + y * 3) % 11) * 60 : 5.0f));
  return sky;
}

TEST(Daylight, SkyIsSampledWithTheDensityItClaims) {
  for (const bool portals : {false, true}) {
    SCOPED_TRACE(portals);
    SceneMaker make;
    make.scene().sky = patchySky();
    if (portals) {
      make.scene().portals.push_back({{-1, 1, -0.5f}, {2, 0, 0}, {0, 0, 1.5f}});
      make.scene().portals.push_back({{2, -1, 0.5f}, {0, 1.5f, 0}, {0, 0, 1}});
    }
    const auto scene = make.compile();
    const Daylight& daylight = scene->lights().daylight();
    const Receiver at{{}, normalized(Vec3f{0.3f, 0.4f, 1})};
    expectMatchingDensity(
        [&](float a, float b, float c) {
          LightSample s;
          const bool ok = daylight.sampleSky(at, a, {b, c}, s);
          if (ok) {
            EXPECT_NEAR(s.pdf, daylight.pdfSky(at, s.wi), 1e-3f * s.pdf + 1e-5f);
          }
          return std::pair(s.wi, ok);
        },
        [&](Vec3f d) { return daylight.pdfSky(at, d); }, 64, 96, 400000);
  }
}

// A dark hall whose floor the sun reaches through a gap in the roof.
SceneMaker hallWithSun(bool portal) {
  SceneMaker make;
  make.add(parallelogram({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), lambert(grey(0.6f)));
  make.add(parallelogram({-3, -3, 3}, {0, 6, 0}, {2.5f, 0, 0}), lambert(grey(0.6f)));
  make.add(parallelogram({0.5f, -3, 3}, {0, 6, 0}, {2.5f, 0, 0}), lambert(grey(0.6f)));
  make.scene().sun = {normalized(Vec3f{0.3f, 0.2f, 1}), grey(50000)};
  if (portal) make.scene().portals.push_back({{-0.5f, -3, 3}, {1, 0, 0}, {0, 6, 0}});
  return make;
}

TEST(SunPatches, AreSampledWithTheDensityTheyClaim) {
  const auto scene = hallWithSun(true).compile();
  const SunPatches& patches = scene->lights().sunPatches();
  ASSERT_FALSE(patches.empty());
  const SunPatchView view(patches, {{-1.5f, 0.5f, 2.9f}, {0, 0, -1}});
  ASSERT_FALSE(view.empty());
  expectMatchingDensity(
      [&](float a, float b, float c) {
        const Vec3f d = view.sample(a, {b, c});
        EXPECT_GT(view.pdf(d), 0.0f);
        EXPECT_LT(d.z, 0.0f) << "the sun lies on the floor";
        return std::pair(d, true);
      },
      [&](Vec3f d) { return view.pdf(d); }, 96, 192);
}

TEST(SunPatches, SteeringFindsTheSameLight) {
  const auto steered = hallWithSun(true).compile(), plain = hallWithSun(false).compile();
  EXPECT_TRUE(plain->lights().sunPatches().empty());
  const IlluminanceSettings settings{.samples = 1 << 15};
  const float a = luminance(illuminance(*steered, {-1.5f, 0.5f, 2.99f}, {0, 0, -1}, settings));
  const float b = luminance(illuminance(*plain, {-1.5f, 0.5f, 2.99f}, {0, 0, -1}, settings));
  EXPECT_GT(b, 100.0f);
  EXPECT_NEAR(a, b, 0.02f * b);
}

}  // namespace
}  // namespace idap::render
