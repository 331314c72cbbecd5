#include <gtest/gtest.h>

#include <algorithm>

#include "render/film/noise_estimate.h"
#include "render/integrator/camera_ray.h"
#include "render/integrator/path.h"
#include "render/scene_parts.h"
#include "render/session/fill_cache.h"
#include "render/session/illuminance.h"
#include "render/session/render_job.h"

namespace idap::render {
namespace {

using namespace test;

// A little of everything: plastic, metal, glass, a shade, lamps, a glowing panel, sun and sky through a hole.
SceneMaker variedRoom() {
  SceneMaker make;
  Mesh shell = boxMesh({-2, -2, 0}, {2, 2, 2.5f}, true);
  std::erase_if(shell.triangles, [](const auto& t) { return t[0] == 4; });  // half of the +x wall is open
  shell.slots.clear();
  make.add(shell, lambert({0.7f, 0.6f, 0.5f}));
  Surface plastic;
  plastic.baseColor = {0.2f, 0.4f, 0.8f};
  plastic.roughness = 0.4f;
  make.add(boxMesh({-0.3f, -0.3f, 0}, {0.3f, 0.3f, 0.8f}), plastic, Transformf::rotationZ(0.5f));
  Surface metal = plastic;
  metal.metalness = 1;
  make.add(sphereMesh({1, 1, 0.5f}, 0.4f, 12), metal);
  Surface glass;
  glass.baseColor = {0.9f, 1, 0.95f};
  glass.roughness = 0;
  glass.transmission = 1;
  make.add(parallelogram({-1.5f, 0.5f, 0}, {1, 0, 0}, {0, 0, 1.5f}), glass);
  Surface shade;
  shade.translucency = 0.5f;
  make.add(boxMesh({-1.2f, -1.2f, 1}, {-0.8f, -0.8f, 1.4f}), shade);
  make.add(parallelogram({0.5f, -1, 2.4f}, {0, 0.6f, 0}, {0.6f, 0, 0}), lambert(grey(0.5f), grey(800)))
      .lightGroup = 1;
  make.scene().lamps.push_back(
      {.position = {-1, 1, 2}, .radius = 0.3f, .intensity = {30, 25, 20}, .lightGroup = 2});
  make.scene().sun = {normalized(Vec3f{1, 0.1f, 0.8f}), grey(2000), 0.2f};
  make.scene().sky = {8, 4, std::vector<Rgb>(32, Rgb{200, 250, 300})};
  make.scene().portals.push_back({{2, -2, 0}, {0, 4, 0}, {0, 0, 2.5f}});
  make.scene().lightGroups = {{"daylight"}, {"panel"}, {"bulb"}};
  return make;
}

PathStarts starts(int n, int first = 0) {
  PathStarts paths;
  for (int i = first; i < first + n; ++i) {
    Sampler sampler(5, 9, static_cast<std::uint32_t>(i), 16, 3);
    const Vec2f u = sampler.get2D();
    const Vec3f d = normalized(Vec3f{1.5f * u.x - 0.75f, 1, 1.2f * u.y - 0.8f});
    add(paths, {{0, -1.9f, 1.2f}, d}, sampler);
  }
  return paths;
}

std::vector<PathSample> traced(const PathTracer& tracer, int n) {
  const PathStarts paths = starts(n);
  std::vector<PathSample> samples(paths.size());
  tracer.trace(paths, samples);
  return samples;
}

TEST(Path, WhatAPathBringsDoesNotDependOnItsNeighbours) {
  const auto scene = variedRoom().compile();
  Camera camera;
  camera.eye = {0, -1.9f, 1.2f};
  const auto guide = fillGuide(*scene, camera, {.width = 64, .height = 48});
  for (const LightCache* told : {static_cast<const LightCache*>(nullptr), guide.get()}) {
    const PathTracer tracer(*scene, {.guide = told});
    const std::vector<PathSample> together = traced(tracer, 200);
    std::vector<PathSample> apart(together.size());
    for (int i = 0; i < 200; i += 7)
      tracer.trace(starts(std::min(7, 200 - i), i), std::span(apart).subspan(static_cast<std::size_t>(i)));
    for (std::size_t i = 0; i < together.size(); ++i) {
      EXPECT_EQ(together[i].radiance, apart[i].radiance) << i;
      EXPECT_EQ(together[i].albedo, apart[i].albedo) << i;
      EXPECT_EQ(together[i].depth, apart[i].depth) << i;
    }
  }
}

TEST(Path, StrategiesOfFindingLightAgree) {
  const auto scene = variedRoom().compile();
  // Lamp and sun are large here, so that surface sampling alone comes to about 1 % as well.
  const auto mean = [&](LightSampling how, int n) {
    const PathTracer tracer(*scene, {.lightSampling = how});
    double sum = 0, squares = 0;
    for (const PathSample& sample : traced(tracer, n)) {
      const double l = static_cast<double>(luminance(sample.radiance));
      sum += l;
      squares += l * l;
    }
    return std::pair(sum / n, std::sqrt((squares / n - sum / n * sum / n) / n));
  };
  const auto [both, bothError] = mean(LightSampling::Both, 40000);
  const auto [surfaces, surfacesError] = mean(LightSampling::SurfacesOnly, 400000);
  const auto [lights, lightsError] = mean(LightSampling::LightsOnly, 100000);
  EXPECT_NEAR(both, surfaces, 4 * (bothError + surfacesError));
  EXPECT_NEAR(both, lights, 4 * (bothError + lightsError));
  EXPECT_LT(surfacesError, 0.02 * both);
  EXPECT_LT(bothError, 0.01 * both);
}

Camera camera() {
  Camera c;
  c.eye = {0, -1.9f, 1.2f};
  return c;
}

TEST(Render, SameSeedSameFilmOnAnyNumberOfThreads) {
  const auto scene = variedRoom().compile();
  RenderSettings settings{.width = 40, .height = 30, .spp = 5, .seed = 11, .perLightGroupLayers = true};
  Film one(40, 30, 3), two(40, 30, 3), resumed(40, 30, 3);
  settings.threads = 1;
  const RenderStats stats = render(*scene, camera(), settings, one);
  EXPECT_EQ(stats.spp, 5);
  EXPECT_EQ(stats.paths, 40u * 30 * 5);
  EXPECT_GT(stats.rays, stats.paths);
  settings.threads = 2;
  render(*scene, camera(), settings, two);
  EXPECT_TRUE(one.color == two.color);
  EXPECT_TRUE(one.groups == two.groups);
  EXPECT_TRUE(one.normal == two.normal && one.albedo == two.albedo && one.depth == two.depth);
  settings.seed = 12;
  Film other(40, 30);
  render(*scene, camera(), settings, other);
  EXPECT_FALSE(one.color == other.color);
}

TEST(Render, ARegionFirstAndTheRestLaterMakeTheSameFilm) {
  const auto scene = variedRoom().compile();
  RenderSettings settings{.width = 40, .height = 30, .spp = 4, .threads = 2};
  Film whole(40, 30), parts(40, 30);
  render(*scene, camera(), settings, whole);
  settings.region = {10, 5, 12, 20};
  render(*scene, camera(), settings, parts);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      EXPECT_EQ(parts.weight[parts.index(x, y)], settings.region.has(x, y) ? 4 : 0) << x << ", " << y;
  settings.region = {};
  render(*scene, camera(), settings, parts);
  EXPECT_EQ(parts.color, whole.color);
  EXPECT_EQ(parts.weight, whole.weight);
}

TEST(Render, LightGroupsAddUpToThePicture) {
  const auto scene = variedRoom().compile();
  Film film(32, 24, 3);
  render(*scene, camera(), {.width = 32, .height = 24, .spp = 16, .perLightGroupLayers = true}, film);
  Rgb totals[3];
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const Rgb sum = film.groups[0][i] + film.groups[1][i] + film.groups[2][i];
    EXPECT_NEAR(luminance(sum), luminance(film.color[i]), 1e-3f * luminance(sum) + 1e-3f);
    for (std::size_t g = 0; g < 3; ++g) totals[g] += film.groups[g][i];
  }
  for (const Rgb& t : totals) EXPECT_GT(luminance(t), 0);
}

TEST(Render, FeaturesDescribeTheFirstSurface) {
  SceneMaker make;
  make.add(parallelogram({-5, 2, -5}, {10, 0, 0}, {0, 0, 10}), lambert({0.5f, 0.25f, 0.125f})).objectId = 42;
  Surface glass;
  glass.baseColor = grey(1);
  glass.roughness = 0;
  glass.transmission = 1;
  const auto plain = make.compile();
  Film film(8, 8);
  Camera c;
  c.eye = {0, 0, 0};
  render(*plain, c, {.width = 8, .height = 8, .spp = 4}, film);
  const std::size_t middle = film.index(4, 4);
  EXPECT_NEAR(film.meanDepth(middle), 2.0f, 0.1f);
  EXPECT_EQ(film.objectId[middle], 42u);
  EXPECT_NEAR(film.meanNormal(middle).y, -1.0f, 1e-4f);
  EXPECT_NEAR(film.meanAlbedo(middle).x, 0.5f, 1e-3f);
  EXPECT_NEAR(film.meanAlbedo(middle).z, 0.125f, 1e-3f);

  make.add(parallelogram({-5, 1, -5}, {10, 0, 0}, {0, 0, 10}), glass).objectId = 43;
  const auto glazed = make.compile();
  Film behind(8, 8);
  render(*glazed, c, {.width = 8, .height = 8, .spp = 256}, behind);
  EXPECT_EQ(behind.objectId[middle], 43u);
  EXPECT_GT(behind.meanAlbedo(middle).x, 0.4f) << "seen through the glass";
}

TEST(Render, StopsWhenCancelledAndKeepsWhatItHas) {
  const auto scene = variedRoom().compile();
  Film film(64, 48);
  Progress* handle = nullptr;
  Progress progress([&](double fraction, std::string_view) {
    if (fraction > 0.0 && handle) handle->cancel();
  });
  handle = &progress;
  const RenderStats stats =
      render(*scene, camera(), {.width = 64, .height = 48, .spp = 100000}, film, progress);
  EXPECT_LT(stats.spp, 100000);
  EXPECT_LT(stats.seconds, 20);
  EXPECT_GT(*std::ranges::max_element(film.weight), 0);
}

TEST(Render, EndsWhenTheTimeIsUp) {
  const auto scene = variedRoom().compile();
  Film film(64, 48);
  const RenderStats stats =
      render(*scene, camera(), {.width = 64, .height = 48, .timeLimitSeconds = 0.3}, film);
  EXPECT_GE(stats.spp, 1);
  EXPECT_LT(stats.seconds, 3);
}

TEST(Render, RefusesAFilmOfAnotherSize) {
  Film film(4, 4);
  EXPECT_THROW(render(*SceneMaker().compile(), {}, {.width = 8, .height = 4, .spp = 1}, film), RenderError);
}

TEST(Render, HiddenInstancesStillCastLight) {
  SceneMaker make;
  make.add(parallelogram({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), lambert(grey(0.5f)));
  make.add(parallelogram({-5, -5, 1}, {0, 10, 0}, {10, 0, 0}), lambert({}, grey(100))).visibleToCamera =
      false;
  const auto scene = make.compile();
  Camera c;
  c.eye = {0, 0, 5};
  c.forward = {0, 0, -1};
  c.up = {0, 1, 0};
  c.horizontalFov = 0.3f;
  Film film(8, 8);
  render(*scene, c, {.width = 8, .height = 8, .spp = 64}, film);
  const Rgb seen = film.meanColor(film.index(4, 4));
  EXPECT_GT(seen.x, 30) << "the lit floor, not the panel before it";
  EXPECT_LT(seen.x, 60);
  EXPECT_NEAR(film.meanDepth(film.index(4, 4)), 5.0f, 0.05f);
}

TEST(CameraRays, Projections) {
  Camera c;
  c.forward = {0, 1, 0};
  const auto at = [&](float x, float y) { return CameraRays(c, 200, 100).at({x, y}); };
  c.horizontalFov = static_cast<float>(kPi) / 2;
  EXPECT_NEAR(dot(at(200, 50)->direction, normalized(Vec3f{1, 1, 0})), 1.0f, 1e-5f) << "x runs to the right";
  EXPECT_GT(at(100, 0)->direction.z, 0.1f) << "y runs down";
  c.projection = Projection::Equirectangular;
  c.horizontalFov = 2 * static_cast<float>(kPi);
  EXPECT_NEAR(at(150, 50)->direction.x, 1.0f, 1e-5f);
  EXPECT_NEAR(at(100, 0)->direction.z, 1.0f, 1e-5f);
  c.projection = Projection::Fisheye;
  c.horizontalFov = static_cast<float>(kPi);
  EXPECT_NEAR(at(200, 50)->direction.x, 1.0f, 1e-5f);
  EXPECT_FALSE(CameraRays(c, 100, 100).at({1, 1}).has_value());
  c.projection = Projection::Orthographic;
  c.orthographicWidth = 4;
  EXPECT_NEAR(at(200, 50)->origin.x, 2.0f, 1e-5f);
}

TEST(CameraRays, UprightKeepsTheMiddleAndMakesVerticalsParallel) {
  Camera c;
  c.eye = {0, 0, 1.7f};
  const float tilt = -0.3f;
  c.forward = {0, std::cos(tilt), std::sin(tilt)};
  c.up = {0, -std::sin(tilt), std::cos(tilt)};
  const CameraRays tilted(c, 300, 200), level(upright(c), 300, 200);
  EXPECT_NEAR(length(tilted.at({150, 100})->direction - level.at({150, 100})->direction), 0, 1e-5f);
  // Points above each other lie in one column: the ray's way to the right over its way forward is the same.
  const auto column = [](Vec3f d) { return d.x / d.y; };
  EXPECT_NEAR(column(level.at({260, 20})->direction), column(level.at({260, 180})->direction), 1e-5f);
  EXPECT_GT(std::fabs(column(tilted.at({260, 20})->direction) - column(tilted.at({260, 180})->direction)),
            0.05f);
}

TEST(CameraRays, ALensIsSharpAtItsFocus) {
  Camera c;
  c.lensRadius = 0.05f;
  c.focusDistance = 3;
  const CameraRays rays(c, 300, 200);
  const auto at = [&](Vec2f lens, float depth) {
    const Ray ray = *rays.at({220, 60}, lens);
    return ray.origin + ray.direction * (depth / ray.direction.y);
  };
  EXPECT_NEAR(length(at({0.1f, 0.2f}, 3) - at({0.9f, 0.8f}, 3)), 0, 1e-5f);
  EXPECT_GT(length(at({0.1f, 0.2f}, 6) - at({0.9f, 0.8f}, 6)), 0.02f);
  // A 35 mm lens at f/1.4 has a radius of 12.5 mm.
  EXPECT_NEAR(lensRadius(2 * std::atan(18.0f / 35), 1.4f), 0.0125f, 1e-4f);
}

TEST(CameraRays, FiltersAreCentredAndAsWideAsTheySay) {
  for (const auto& [filter, reach] : {std::pair(PixelFilter::BlackmanHarris, 1.5f),
                                      {PixelFilter::Triangle, 1.0f},
                                      {PixelFilter::Box, 0.5f}}) {
    float mean = 0, widest = 0;
    for (int i = 0; i < 1000; ++i) {
      const float o = filterOffset(Vec2f{(static_cast<float>(i) + 0.5f) / 1000, 0.5f}, filter).x;
      mean += o / 1000;
      widest = std::max(widest, std::fabs(o));
    }
    EXPECT_NEAR(mean, 0, 1e-3f);
    EXPECT_LE(widest, reach);
    EXPECT_GT(widest, 0.8f * reach);
  }
}

TEST(Render, NoiseStopsEachPixelWhereItIsQuietEnough) {
  const auto scene = variedRoom().compile();
  RenderSettings settings{.width = 48, .height = 32, .noise = 0.05f};
  Film film(48, 32), again(48, 32);
  render(*scene, camera(), settings, film);
  EXPECT_LT(noiseLevel(film), 0.05f);
  EXPECT_GE(film.samples, 16);
  EXPECT_GT(*std::ranges::max_element(film.weight), 2 * static_cast<float>(film.samples));
  settings.threads = 1;
  render(*scene, camera(), settings, again);
  EXPECT_EQ(film.color, again.color);
  EXPECT_EQ(film.weight, again.weight);

  // The estimate is honest: the distance to a far better picture is what it says.
  Film better(48, 32);
  settings.threads = 0;
  settings.noise = 0;
  settings.spp = 4096;
  settings.seed = 7;
  render(*scene, camera(), settings, better);
  double sum = 0;
  int counted = 0;
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const float truth = luminance(better.meanColor(i));
    if (truth <= 0) continue;
    const double e = static_cast<double>(luminance(film.meanColor(i)) / truth - 1);
    if (std::fabs(e) < 1) sum += e * e, ++counted;
  }
  EXPECT_LT(std::sqrt(sum / counted), 0.1);
}

TEST(Render, AHiddenSkyStillLights) {
  SceneMaker make;
  make.add(parallelogram({-50, 0, -1}, {100, 0, 0}, {0, 100, 0}), lambert(grey(0.5f)));
  make.scene().sky = {8, 4, std::vector<Rgb>(32, grey(100))};
  const auto scene = make.compile();
  RenderSettings settings{.width = 16, .height = 16, .spp = 32, .transparentBackground = true};
  Film film(16, 16);
  render(*scene, Camera{}, settings, film);
  EXPECT_EQ(luminance(film.meanColor(film.index(8, 0))), 0);
  EXPECT_EQ(film.meanCoverage(film.index(8, 0)), 0);
  EXPECT_EQ(film.meanCoverage(film.index(8, 15)), 1);
  EXPECT_NEAR(luminance(film.meanColor(film.index(8, 15))), 50, 5);
}

}  // namespace
}  // namespace idap::render
