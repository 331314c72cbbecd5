// Closed forms and published values of lighting that the renderer must reproduce. Tolerances are four or more
// standard errors of the sample counts used, or 1 % where that is larger.
#include <gtest/gtest.h>

#include <bit>

#include "render/emitter/lamp.h"
#include "render/integrator/path.h"
#include "render/scene_parts.h"
#include "render/session/illuminance.h"

namespace idap::render {
namespace {

using namespace test;

// Every place draws its own random numbers, so that errors of neighbours do not add up.
float lux(const CompiledScene& scene, Vec3f p, Vec3f n, int samples = 4096) {
  const auto bits = [](float v) { return std::uint64_t{std::bit_cast<std::uint32_t>(v)}; };
  const std::uint64_t seed = bits(p.x) * 0x9e3779b97f4a7c15u + bits(p.y) * 0xc2b2ae3d27d4eb4fu + bits(p.z);
  return luminance(illuminance(scene, p, n, {.samples = samples, .seed = seed}));
}

constexpr Vec3f kUp{0, 0, 1};

// A black room 4 x 4 x 3 m, its floor's middle at the origin.
Mesh room() { return boxMesh({-2, -2, 0}, {2, 2, 3}, true); }

Mesh ceilingSquare() { return parallelogram({-0.5f, -0.5f, 2.999f}, {0, 1, 0}, {1, 0, 0}); }

class Furnace : public testing::TestWithParam<float> {};

TEST_P(Furnace, EveryPointOfAGlowingClosedBoxIsEquallyBright) {
  const float rho = GetParam();
  SceneMaker make;
  make.add(boxMesh({-1, -2, 0}, {3, 1, 2.5f}, true), lambert(grey(rho), grey(100)));
  // Flat triangles: smooth normals on coarse meshes are a look, not physics, and lose some light.
  Mesh ball = sphereMesh({0.5f, -0.5f, 1}, 0.4f, 8);
  ball.normals.clear();
  make.add(ball, lambert(grey(rho), grey(100)));
  const auto scene = make.compile();
  const double expected = kPi * 100 / (1 - static_cast<double>(rho));
  // The length of a path is geometrically distributed, so one sample's deviation is about the mean itself.
  const int samples = rho > 0.9f ? 40000 : 16384;
  const double tolerance = std::max(0.01, 4 / std::sqrt(samples)) * expected;
  for (const Vec3f p : {Vec3f{0, 0, 0.0f}, Vec3f{-0.99f, -1.98f, 0.01f}})
    EXPECT_NEAR(lux(*scene, p, kUp, samples), expected, tolerance) << "reflectance " << rho;
}
INSTANTIATE_TEST_SUITE_P(Reflectance, Furnace, testing::Values(0.0f, 0.3f, 0.5f, 0.8f, 0.95f));

TEST(FormFactor, ParallelRectangles) {
  // The factor from one square to the other: mean illuminance over the receiver over the source's exitance.
  const auto factor = [](float side, float distance) {
    SceneMaker make;
    const float h = 0.5f * side;
    make.add(parallelogram({-h, -h, distance}, {0, side, 0}, {side, 0, 0}), lambert({}, grey(1000)));
    const auto scene = make.compile();
    double sum = 0;
    constexpr int n = 12;
    for (int i = 0; i < n * n; ++i) {
      const float x = (static_cast<float>(i % n) + 0.5f) / n - 0.5f,
                  y = (static_cast<float>(i / n) + 0.5f) / n - 0.5f;
      sum += static_cast<double>(lux(*scene, {x * side, y * side, 0}, kUp, 256));
    }
    return sum / (n * n) / (1000 * kPi);
  };
  // The table's "configuration factor, centred" is that of a point under the square's middle.
  SceneMaker make;
  make.add(parallelogram({-0.5f, -0.5f, 1}, {0, 1, 0}, {1, 0, 0}), lambert({}, grey(1000)));
  EXPECT_NEAR(lux(*make.compile(), {}, kUp, 16384) / (1000 * kPi), 0.23946, 0.0012);
  SceneMaker large;
  large.add(parallelogram({-2, -2, 3}, {0, 4, 0}, {4, 0, 0}), lambert({}, grey(1000)));
  EXPECT_NEAR(lux(*large.compile(), {}, kUp, 16384) / (1000 * kPi), 0.35768, 0.0018);
  // Opposite faces of a cube.
  EXPECT_NEAR(factor(1, 1), 0.199825, 0.0015);
}

TEST(FormFactor, AdjacentFacesOfACube) {
  SceneMaker make;
  make.add(parallelogram({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), lambert({}, grey(1000)));
  const auto scene = make.compile();
  double sum = 0;
  constexpr int n = 16;
  for (int i = 0; i < n * n; ++i)
    sum += static_cast<double>(
        lux(*scene, {(static_cast<float>(i % n) + 0.5f) / n, (static_cast<float>(i / n) + 0.5f) / n, 0}, kUp,
            512));
  // The illuminance is steepest at the shared edge: the midpoint rule on 16 steps costs up to 0.5 %.
  EXPECT_NEAR(sum / (n * n) / (1000 * kPi), 0.200044, 0.002);
}

TEST(FormFactor, Disc) {
  SceneMaker make;
  Mesh disc;
  disc.positions.push_back({0, 0, 2});
  constexpr int n = 256;
  for (int i = 0; i < n; ++i) {
    const float a = 2 * static_cast<float>(kPi) * static_cast<float>(i) / n;
    disc.positions.push_back({0.5f * std::cos(a), 0.5f * std::sin(a), 2});
  }
  for (std::uint32_t i = 0; i < n; ++i) disc.triangles.push_back({0, 1 + (i + 1) % n, 1 + i});
  make.add(disc, lambert({}, grey(1000)));
  EXPECT_NEAR(lux(*make.compile(), {}, kUp), 184.80, 1.0);
}

// The closed form gives 105.19 for the second point, so the printed values are good to 0.03.
TEST(Cie171, Case52PointSource) {
  SceneMaker make;
  make.scene().lamps.push_back({.position = {0, 0, 3}, .intensity = grey(1000), .lambertian = true});
  const auto scene = make.compile();
  const auto at = [&](float x, float y) { return lux(*scene, {x, y, 0}, kUp, 16); };
  EXPECT_NEAR(at(0, 0), 111.11, 0.03);
  EXPECT_NEAR(at(0.5f, 0), 105.21, 0.03);
  EXPECT_NEAR(at(1, 0), 90.02, 0.03);
  EXPECT_NEAR(at(1.5f, 0), 71.11, 0.03);
  EXPECT_NEAR(at(1.5f, 1.5f), 49.39, 0.03);
}

TEST(Cie171, Case53AreaSource) {
  SceneMaker make;
  make.add(room(), lambert({}));
  make.add(ceilingSquare(), lambert({}, grey(1000)));  // 1 m2 of 1000 cd/m2
  const auto scene = make.compile();
  const float wall[] = {32.68f, 75.09f, 81.38f, 69.12f, 53.41f, 39.90f};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(lux(*scene, {-1.9999f, 0, 2.75f - 0.5f * static_cast<float>(i)}, {1, 0, 0}), wall[i],
                0.015f * wall[i])
        << i;
  const float floor[] = {105.89f, 95.52f, 79.18f, 61.27f};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(lux(*scene, {0, 0.25f + 0.5f * static_cast<float>(i), 0.0001f}, kUp), floor[i],
                0.015f * floor[i])
        << i;
}

// Mean over the six faces of a box of the light they receive.
template <class Illuminance>
double fluxInto(Vec3f a, Vec3f b, int n, const Illuminance& e) {
  double flux = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      for (int i = 0; i < n * n; ++i) {
        Vec3f p, normal{};
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        p[axis] = side ? b[axis] - 1e-4f : a[axis] + 1e-4f;
        p[u] = a[u] + (b[u] - a[u]) * (static_cast<float>(i % n) + 0.5f) / static_cast<float>(n);
        p[v] = a[v] + (b[v] - a[v]) * (static_cast<float>(i / n) + 0.5f) / static_cast<float>(n);
        normal[axis] = side ? -1.0f : 1.0f;
        flux +=
            static_cast<double>(e(p, normal)) * static_cast<double>((b[u] - a[u]) * (b[v] - a[v])) / (n * n);
      }
  return flux;
}

TEST(Cie171, Case54FluxIsConserved) {
  SceneMaker make;
  make.add(room(), lambert({}));
  make.scene().lamps.push_back({.position = {0, 0, 1.5f}, .intensity = grey(100)});
  make.scene().lamps.push_back({.position = {0.7f, -0.5f, 2}, .intensity = grey(300), .beamAngle = 1.0f});
  const auto scene = make.compile();
  const double sent =
      static_cast<double>(luminance(lampFlux(make.scene().lamps[0]) + lampFlux(make.scene().lamps[1])));
  const double received =
      fluxInto({-2, -2, 0}, {2, 2, 3}, 24, [&](Vec3f p, Vec3f n) { return lux(*scene, p, n, 8); });
  EXPECT_NEAR(received / sent, 1.0, 0.005);
}

TEST(Cie171, Case58InterReflectionsInACube) {
  const float rho[] = {0.05f, 0.3f, 0.5f, 0.7f, 0.9f, 0.95f};
  const double expected[] = {5.48, 44.6, 104.2, 243, 937, 1979};
  for (std::size_t k = 0; k < 6; ++k) {
    SceneMaker make;
    make.add(boxMesh({-2, -2, -2}, {2, 2, 2}, true), lambert(grey(rho[k])));
    make.scene().lamps.push_back(
        {.position = {0, 0, 0}, .intensity = grey(10000 / (4 * static_cast<float>(kPi)))});
    const auto scene = make.compile();
    // Whole light minus the direct light, whose mean over the area is flux / area.
    const int n = 8, samples = rho[k] > 0.8f ? 192 : 64;
    std::uint64_t seed = 0;
    const double total = fluxInto({-2, -2, -2}, {2, 2, 2}, n, [&](Vec3f p, Vec3f normal) {
      const float cosine = 2 / length(p), distance2 = dot(p, p);
      const float direct = 10000 / (4 * static_cast<float>(kPi)) * cosine / distance2;
      return luminance(illuminance(*scene, p, normal, {.samples = samples, .seed = ++seed})) - direct;
    });
    EXPECT_NEAR(total / 96, expected[k], 0.015 * expected[k]) << "reflectance " << rho[k];
  }
}

// The CIE overcast sky over a black ground, zenith luminance 1000 cd/m2.
Sky overcast() {
  Sky sky;
  sky.width = 64;
  sky.height = 256;
  for (int y = 0; y < sky.height; ++y) {
    const double theta = kPi * (y + 0.5) / sky.height;
    const float l = theta < kPi / 2 ? static_cast<float>(1000 * (1 + 2 * std::cos(theta)) / 3) : 0.0f;
    for (int x = 0; x < sky.width; ++x) sky.radiance.push_back(grey(l));
  }
  return sky;
}
const double kOvercast = 7 * kPi / 9 * 1000;

TEST(Daylight, OvercastSkyOnOpenGround) {
  SceneMaker make;
  make.scene().sky = overcast();
  EXPECT_NEAR(lux(*make.compile(), {}, kUp), kOvercast, 0.003 * kOvercast);
}

TEST(Daylight, SunOnASlope) {
  SceneMaker make;
  make.scene().sun = {{0.6f, 0, 0.8f}, grey(90000)};
  EXPECT_NEAR(lux(*make.compile(), {}, kUp, 64), 0.8 * 90000, 20);
}

TEST(Daylight, FactorBehindASideWindow) {
  for (const bool portal : {false, true}) {
    SceneMaker make;
    make.scene().sky = overcast();
    // Everything black; the wall at y = 0 with a hole 2 m wide, 1 m high, sill 1 m.
    const Surface black = lambert({});
    make.add(parallelogram({-3, 0, -1}, {6, 0, 0}, {0, 0, 2}), black);
    make.add(parallelogram({-3, 0, 2}, {6, 0, 0}, {0, 0, 2}), black);
    make.add(parallelogram({-3, 0, 1}, {2, 0, 0}, {0, 0, 1}), black);
    make.add(parallelogram({1, 0, 1}, {2, 0, 0}, {0, 0, 1}), black);
    Mesh shell = boxMesh({-3, 0, -1}, {3, 6, 4}, true);
    std::erase_if(shell.triangles, [&](const auto& t) { return t[0] / 4 == 2; });
    shell.slots.clear();
    make.add(shell, black);
    if (portal) make.scene().portals.push_back({{-1, 0, 1}, {2, 0, 0}, {0, 0, 1}});
    const auto scene = make.compile();
    const double factor[] = {8.58, 3.98, 1.68};
    for (int i = 0; i < 3; ++i) {
      const double e =
          static_cast<double>(lux(*scene, {0, static_cast<float>(i + 1), 0}, kUp, portal ? 4096 : 65536));
      EXPECT_NEAR(100 * e / kOvercast, factor[i], 0.012 * factor[i]) << i + 1 << " m in, portal " << portal;
    }
  }
}

TEST(Glass, SinglePaneTransmits) {
  Surface glass;
  glass.baseColor = grey(1);
  glass.roughness = 0;
  glass.ior = 1.52f;
  glass.transmission = 1;
  SceneMaker make;
  make.add(parallelogram({-50, -50, 1}, {100, 0, 0}, {0, 100, 0}), glass);
  const auto scene = make.compile();
  const double expected[][2] = {{0, 0.9183}, {60, 0.8435}, {75, 0.6148}};
  for (const auto& [degrees, transmitted] : expected) {
    const auto a = static_cast<float>(degrees / 180 * kPi);
    const Ray ray{{0, 0, 0}, {std::sin(a), 0, std::cos(a)}};
    EXPECT_NEAR(luminance(scene->transmittance(ray)), transmitted, 0.0002) << degrees << " degrees";
  }
}

}  // namespace
}  // namespace idap::render
