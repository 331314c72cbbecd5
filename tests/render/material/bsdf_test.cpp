// Every material must scatter no more light than it receives, the same both ways, and sample what it claims.
#include "render/material/bsdf.h"

#include <gtest/gtest.h>

#include <string>

#include "render/chi_square.h"
#include "render/material/fresnel.h"
#include "render/sampling/warp.h"

namespace idap::render {
namespace {

using namespace test;

struct Case {
  std::string name;
  Surface surface;
  double whiteAlbedo = -1;  // what a furnace must give with white colour; -1: only at most 1
  bool reciprocal = true;
};

Surface material(float roughness) {
  Surface s;
  s.baseColor = {1, 1, 1};
  s.roughness = roughness;
  return s;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](std::string name, auto change, double albedo, bool reciprocal = true) {
    for (const float roughness : {0.15f, 0.5f, 1.0f}) {
      Case c{name + " roughness " + std::to_string(roughness), material(roughness), albedo, reciprocal};
      change(c.surface);
      all.push_back(c);
    }
  };
  add(
      "lambert", [](Surface& s) { s.ior = 1; }, 1);
  add(
      "plastic", [](Surface&) {}, 1);
  add(
      "lacquer", [](Surface& s) { s.ior = 1.9f; }, 1);
  add(
      "metal", [](Surface& s) { s.metalness = 1; }, 1);
  add(
      "half metal", [](Surface& s) { s.metalness = 0.5f; }, 1);
  add(
      "curtain", [](Surface& s) { s.translucency = 0.6f, s.ior = 1; }, 1);
  add(
      "lampshade", [](Surface& s) { s.translucency = 0.4f; }, 1);
  add(
      "frosted sheet", [](Surface& s) { s.transmission = 0.7f; }, 1);
  // Light lost between the facets of rough glass is not given back.
  add(
      "rough glass", [](Surface& s) { s.transmission = 1, s.thin = false; }, -1, false);
  add(
      "cloudy solid", [](Surface& s) { s.transmission = 0.5f, s.thin = false; }, -1, false);
  return all;
}

Interaction flat(const SurfaceData& surface, bool front = true) {
  Interaction at;
  at.ng = at.ns = {0, 0, 1};
  at.surface = &surface;
  at.frontFace = front;
  return at;
}

Vec3f direction(float cosine, float phi = 0.4f) {
  const float s = std::sqrt(1 - cosine * cosine);
  return {s * std::cos(phi), s * std::sin(phi), cosine};
}

double sampledAlbedo(const Bsdf& bsdf, int n = 16384) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const Vec2f u = hammersley(i, n);
    // A third number, uneven against both.
    const float lobe = static_cast<float>(std::fmod(0.5 + i * 0.6180339887498949, 1.0));
    const BsdfSample s = bsdf.sample(std::min(lobe, kOneMinusEpsilon), u);
    if (s.pdf > 0) sum += static_cast<double>(s.weight.y / s.etaScale);
  }
  return sum / n;
}

TEST(Bsdf, WhiteFurnace) {
  for (const Case& c : cases()) {
    const SurfaceData surface = compileSurface(c.surface);
    for (const float cosine : {1.0f, 0.8f, 0.5f, 0.25f, 0.1f}) {
      const Bsdf bsdf(flat(surface), valuesAt(surface, {}), direction(cosine));
      const double albedo = sampledAlbedo(bsdf);
      // The albedo table's steps and 16384 samples each cost up to about 1 %.
      if (c.whiteAlbedo >= 0) {
        EXPECT_NEAR(albedo, c.whiteAlbedo, 0.015) << c.name << " cosine " << cosine;
      }
      EXPECT_LT(albedo, 1.015) << c.name << " cosine " << cosine;
      EXPECT_GT(albedo, 0.5) << c.name << " cosine " << cosine;
    }
  }
}

TEST(Bsdf, SmoothSurfacesLoseNothing) {
  for (const bool thin : {true, false})
    for (const float metal : {0.0f, 1.0f})
      for (const float transmission : {0.0f, 1.0f})
        for (const bool front : {true, false}) {
          Surface s = material(0);
          s.metalness = metal;
          s.transmission = transmission;
          s.thin = thin;
          const SurfaceData surface = compileSurface(s);
          for (const float cosine : {1.0f, 0.6f, 0.2f}) {
            const Bsdf bsdf(flat(surface, front), valuesAt(surface, {}), direction(cosine));
            EXPECT_NEAR(sampledAlbedo(bsdf), 1.0, 0.015)
                << thin << metal << transmission << front << " " << cosine;
          }
        }
}

TEST(Bsdf, ColourOfMetalAndBaseIsKept) {
  Surface s = material(0.3f);
  s.baseColor = {0.9f, 0.5f, 0.1f};
  s.metalness = 1;
  const SurfaceData gold = compileSurface(s);
  const Bsdf bsdf(flat(gold), valuesAt(gold, {}), direction(0.95f));
  Rgb sum{};
  constexpr int n = 4096;
  for (int i = 0; i < n; ++i)
    sum += bsdf.sample(static_cast<float>(std::fmod(i * 0.618034, 1.0)), hammersley(i, n)).weight;
  EXPECT_NEAR(sum.x / n, 0.9f, 0.02f);
  EXPECT_NEAR(sum.y / n, 0.5f, 0.02f);
  EXPECT_NEAR(sum.z / n, 0.1f, 0.02f);
}

TEST(Bsdf, Reciprocal) {
  for (const Case& c : cases()) {
    if (!c.reciprocal) continue;
    const SurfaceData surface = compileSurface(c.surface);
    for (int i = 0; i < 64; ++i) {
      const Vec2f u = hammersley(i, 64);
      const Vec3f a = direction(0.05f + 0.94f * u.x, 0.3f), b = direction(0.05f + 0.94f * u.y, 6 * u.x);
      const float ab = Bsdf(flat(surface), valuesAt(surface, {}), a).eval(b).value.y / b.z;
      const float ba = Bsdf(flat(surface), valuesAt(surface, {}), b).eval(a).value.y / a.z;
      EXPECT_NEAR(ab, ba, 1e-3f * (ab + ba) + 1e-5f) << c.name;
    }
  }
}

TEST(Bsdf, SamplesMatchTheirDensity) {
  for (const Case& c : cases()) {
    if (c.surface.roughness < 0.3f) continue;  // too narrow for the cells
    const SurfaceData surface = compileSurface(c.surface);
    for (const bool front : {true, false}) {
      SCOPED_TRACE(c.name + (front ? " from the front" : " from behind"));
      const Bsdf bsdf(flat(surface, front), valuesAt(surface, {}), direction(0.6f));
      expectMatchingDensity(
          [&](float a, float b, float d) {
            const BsdfSample s = bsdf.sample(a, {b, d});
            return std::pair(s.wi, s.pdf > 0 && !s.delta);
          },
          [&](Vec3f d) { return bsdf.eval(d).pdf; }, 16, 32, 60000);
    }
  }
}

TEST(Bsdf, ShadingNormalsNeverMakeItNegativeOrInfinite) {
  for (const Case& c : cases()) {
    const SurfaceData surface = compileSurface(c.surface);
    for (int i = 0; i < 256; ++i) {
      const Vec2f u = hammersley(i, 256);
      Interaction at = flat(surface);
      at.ns = direction(0.3f + 0.7f * u.x, 6 * u.y);
      at.smooth = true;
      const Bsdf bsdf(at, valuesAt(surface, {}), direction(0.001f + 0.999f * u.y, 5 * u.x));
      const BsdfSample s = bsdf.sample(u.y, {u.y, u.x});
      if (s.pdf <= 0) continue;
      EXPECT_TRUE(std::isfinite(s.weight.x) && s.weight.x >= 0) << c.name;
      EXPECT_NEAR(length(s.wi), 1.0f, 1e-3f) << c.name;
    }
  }
}

TEST(Fresnel, GlassPane) {
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.5f), 0.04f, 1e-5f);
  EXPECT_NEAR(fresnelDielectric(0.0f, 1.5f), 1.0f, 1e-5f);
  EXPECT_EQ(fresnelDielectric(0.5f, 1 / 1.5f), 1.0f) << "total reflection inside";
  EXPECT_NEAR(1 - fresnelSheet(std::cos(static_cast<float>(kPi) / 3), 1.52f), 0.8435f, 2e-4f);
}

}  // namespace
}  // namespace idap::render
