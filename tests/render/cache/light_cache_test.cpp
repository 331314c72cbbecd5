#include "render/cache/light_cache.h"

#include <gtest/gtest.h>

#include "render/scene_parts.h"
#include "render/session/fill_cache.h"

namespace idap::render {
namespace {

using namespace test;

std::vector<CacheRecord> records(std::size_t n, Vec3f position, Vec3f normal, Rgb irradiance) {
  return {n, {position, LightCache::facing(normal), irradiance}};
}

TEST(LightCache, KnowsTheMeanOfANeighbourhood) {
  std::vector<CacheRecord> all = records(100, {1, 1, 0}, {0, 0, 1}, grey(10));
  for (const CacheRecord& r : records(100, {1, 1, 0}, {0, 0, 1}, grey(30))) all.push_back(r);
  const LightCache cache(all);
  ASSERT_NE(cache.at({1, 1, 0}, {0, 0, 1}), nullptr);
  EXPECT_NEAR(cache.at({1, 1, 0}, {0.1f, 0, 0.99f})->irradiance.x, 20, 1e-4f);
}

TEST(LightCache, KnowsWhatAskingEachLightBringsAndFindsItLaneByLane) {
  std::vector<CacheRecord> records;
  for (int i = 0; i < 400; ++i) {
    const float x = static_cast<float>(i % 20), y = static_cast<float>(i / 20);
    records.push_back({{x, y, 0}, 4, grey(10), {0, i % 4 == 0 ? 1600.0f : 0.0f, 9}});
  }
  const LightCache cache(records);
  LaneVec places = spread<Floats>({3, 4, 0}), normals = spread<Floats>({0, 0, 1});
  normals.z[1] = -1;  // nothing is known of the other side
  int found = 0;
  cache.visit(LaneMask(true), places, normals, [&](int k, const LightCache::Neighbourhood& known) {
    EXPECT_NE(k, 1);
    EXPECT_EQ(&known, cache.at({3, 4, 0}, {0, 0, 1}));
    EXPECT_EQ(known.asked[0], 0.0f);
    EXPECT_NEAR(known.asked[1], 20, 3);
    EXPECT_NEAR(known.asked[2], 3, 1e-4f);
    ++found;
  });
  EXPECT_EQ(found, kLanes - 1);
}

TEST(LightCache, SidesOfAWallAreKeptApart) {
  std::vector<CacheRecord> all = records(100, {0, 1, 1}, {1, 0, 0}, grey(5));
  for (const CacheRecord& r : records(100, {-0.1f, 1, 1}, {-1, 0, 0}, grey(500))) all.push_back(r);
  const LightCache cache(all);
  EXPECT_EQ(cache.at({0, 1, 1}, {1, 0, 0})->irradiance, grey(5));
  EXPECT_EQ(cache.at({-0.1f, 1, 1}, {-1, 0, 0})->irradiance, grey(500));
  EXPECT_EQ(cache.at({0, 1, 1}, {0, 0, 1}), nullptr);
}

TEST(LightCache, DividesWhereMuchIsKnown) {
  std::vector<CacheRecord> all;
  for (int i = 0; i < 8000; ++i) {
    const float x = static_cast<float>(i % 100) / 25;
    all.push_back({{x, 0, 0}, LightCache::facing({0, 0, 1}), grey(x < 2 ? 1.0f : 3.0f)});
  }
  const LightCache cache(all);
  EXPECT_NEAR(cache.at({0.3f, 0, 0}, {0, 0, 1})->irradiance.x, 1, 1e-3f);
  EXPECT_NEAR(cache.at({3.7f, 0, 0}, {0, 0, 1})->irradiance.x, 3, 1e-3f);
  EXPECT_LT(cache.at({3.7f, 0, 0}, {0, 0, 1})->size, 1.1f);
}

TEST(LightCache, AFewPathsAreNotBelieved) {
  std::vector<CacheRecord> all = records(5, {0, 0, 0}, {0, 0, 1}, grey(1e6f));
  EXPECT_EQ(LightCache(all).at({0, 0, 0}, {0, 0, 1}), nullptr);
  EXPECT_EQ(LightCache().at({0, 0, 0}, {0, 0, 1}), nullptr);
}

// A closed white room with a lamp: most light has bounced.
std::unique_ptr<CompiledScene> whiteRoom() {
  SceneMaker make;
  make.add(boxMesh({0, 0, 0}, {4, 5, 2.5f}, true), lambert(grey(0.7f)));
  make.add(boxMesh({1, 2, 0}, {2, 3, 1}), lambert(grey(0.4f)));
  make.scene().lamps.push_back({.position = {2.5f, 1.5f, 2.3f}, .radius = 0.05f, .intensity = grey(100)});
  return make.compile();
}

TEST(FillCache, ThePictureIsNearlyTheSameAndQuieter) {
  const auto scene = whiteRoom();
  Camera camera;
  camera.eye = {2, 0.2f, 1.5f};
  RenderSettings settings{.width = 48, .height = 32, .spp = 1024};
  Film truth(48, 32), without(48, 32);
  render(*scene, camera, settings, truth);
  settings.spp = 64;
  settings.seed = 5;
  render(*scene, camera, settings, without);
  // One cache's light is a percent or so off as a whole.
  constexpr int kCaches = 3;
  double mean = 0, meanWith = 0, noise = 0, noiseWith = 0;
  for (int k = 0; k < kCaches; ++k, ++settings.seed) {
    Film with(48, 32);
    settings.cache = nullptr;
    settings.cache = fillCache(*scene, camera, settings, 400'000);
    ASSERT_NE(settings.cache, nullptr);
    EXPECT_GT(render(*scene, camera, settings, with).paths, 0u);
    for (std::size_t i = 0; i < truth.pixels(); ++i) {
      const auto at = [&](const Film& f) { return static_cast<double>(luminance(f.meanColor(i))); };
      mean += at(truth), meanWith += at(with);
      noise += std::pow(at(without) - at(truth), 2), noiseWith += std::pow(at(with) - at(truth), 2);
    }
  }
  EXPECT_NEAR(meanWith / mean, 1, 0.02);
  EXPECT_LT(noiseWith, 0.7 * noise);
}

// A guide that takes the dark side of the room for bright and the other way round.
std::shared_ptr<const LightCache> wrongGuide() {
  std::vector<CacheRecord> all;
  for (int facing = 0; facing < 6; ++facing)
    for (int i = 0; i < 20'000; ++i) {
      const Vec3f p{4 * static_cast<float>(i % 25) / 25, 5 * static_cast<float>(i / 25 % 25) / 25,
                    2.5f * static_cast<float>(i / 625) / 32};
      all.push_back({p, static_cast<std::uint32_t>(facing), grey(p.y < 2.5f ? 1.0f : 300.0f)});
    }
  return std::make_shared<const LightCache>(all);
}

TEST(Guide, ThePictureIsRightWhateverItSays) {
  const auto scene = whiteRoom();
  Camera camera;
  camera.eye = {2, 0.2f, 1.5f};
  RenderSettings settings{.width = 24, .height = 16, .spp = 2048};
  const auto brightness = [&](std::shared_ptr<const LightCache> guide) {
    Film film(settings.width, settings.height);
    settings.guide = std::move(guide);
    render(*scene, camera, settings, film);
    double sum = 0;
    for (std::size_t i = 0; i < film.pixels(); ++i) sum += static_cast<double>(luminance(film.meanColor(i)));
    return sum;
  };
  const double truth = brightness(nullptr);
  EXPECT_NEAR(brightness(fillGuide(*scene, camera, settings)) / truth, 1, 0.005);
  EXPECT_NEAR(brightness(wrongGuide()) / truth, 1, 0.01);
}

// A dark hall that is lit from the next room through a door.
TEST(Guide, LessNoiseWithFewerRays) {
  SceneMaker make;
  make.add(boxMesh({0, 0, 0}, {4, 5, 2.5f}, true), lambert(grey(0.7f)));
  make.add(boxMesh({0, 2.5f, 0}, {3.1f, 2.6f, 2.5f}), lambert(grey(0.7f)));
  make.scene().lamps.push_back({.position = {1, 4, 2.2f}, .radius = 0.05f, .intensity = grey(100)});
  const auto scene = make.compile();
  Camera camera;
  camera.eye = {0.3f, 0.3f, 1.5f};
  camera.forward = normalized(Vec3f{0.8f, 0.6f, 0});
  RenderSettings settings{.width = 48, .height = 32, .spp = 4096};
  Film truth(48, 32), with(48, 32), without(48, 32);
  render(*scene, camera, settings, truth);
  settings.spp = 256;
  settings.seed = 5;
  const RenderStats plain = render(*scene, camera, settings, without);
  settings.guide = fillGuide(*scene, camera, settings);
  ASSERT_NE(settings.guide, nullptr);
  const RenderStats guided = render(*scene, camera, settings, with);
  double noise = 0, noiseWith = 0;
  for (std::size_t i = 0; i < truth.pixels(); ++i) {
    const auto at = [&](const Film& f) { return static_cast<double>(luminance(f.meanColor(i))); };
    noise += std::pow(at(without) / at(truth) - 1, 2), noiseWith += std::pow(at(with) / at(truth) - 1, 2);
  }
  EXPECT_LT(noiseWith * static_cast<double>(guided.rays), 0.9 * noise * static_cast<double>(plain.rays));
}

// A closed room with a lamp; the sun shines on it from outside.
TEST(Guide, LightsThatBringNothingAreSeldomAsked) {
  const auto raysAPath = [](bool sun, bool guided) {
    SceneMaker make;
    make.add(boxMesh({0, 0, 0}, {4, 5, 2.5f}, true), lambert(grey(0.5f)));
    make.scene().lamps.push_back({.position = {2, 2, 2.2f}, .radius = 0.05f, .intensity = grey(100)});
    if (sun) make.scene().sun = {{0, 0, 1}, grey(50'000)};
    const auto scene = make.compile();
    Camera camera;
    camera.eye = {0.3f, 0.3f, 1.5f};
    camera.forward = normalized(Vec3f{0.6f, 0.8f, 0});
    RenderSettings settings{.width = 32, .height = 32, .spp = 16};
    if (guided) settings.guide = fillGuide(*scene, camera, settings);
    Film film(32, 32);
    const RenderStats stats = render(*scene, camera, settings, film);
    return static_cast<double>(stats.rays) / static_cast<double>(stats.paths);
  };
  const double always = raysAPath(true, false) - raysAPath(false, false);
  const double guided = raysAPath(true, true) - raysAPath(false, true);
  EXPECT_GT(always, 1);
  EXPECT_LT(guided, 0.2 * always);
}

TEST(FillCache, IsTheSameForAnyNumberOfThreads) {
  const auto scene = whiteRoom();
  Camera camera;
  camera.eye = {2, 0.2f, 1.5f};
  RenderSettings settings{.width = 16, .height = 16, .spp = 4, .threads = 1};
  Film one(16, 16), two(16, 16);
  settings.cache = fillCache(*scene, camera, settings, 20'000);
  render(*scene, camera, settings, one);
  settings.threads = 2;
  settings.cache = fillCache(*scene, camera, settings, 20'000);
  render(*scene, camera, settings, two);
  EXPECT_EQ(one.color, two.color);
}

TEST(FillCache, CanBeBrokenOff) {
  const auto scene = whiteRoom();
  Progress progress;
  progress.cancel();
  EXPECT_THROW(fillCache(*scene, Camera{}, {.width = 16, .height = 16}, 10'000, progress), Cancelled);
}

}  // namespace
}  // namespace idap::render
