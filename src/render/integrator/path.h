// Backward path tracing: light sampling and surface sampling joined by multiple importance sampling (power
// heuristic, Veach 1997), paths ended by Russian roulette only, so that the mean is right at any reflectance.
// Paths are followed side by side, one a lane; what one brings does not depend on its neighbours.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/accel/compiled_scene.h"
#include "render/cache/light_cache.h"
#include "render/lanes/lane_queue.h"
#include "render/sampling/sampler.h"

namespace idap::render {

// Which strategies find light; all but Both are for checking that they agree.
enum class LightSampling { Both, SurfacesOnly, LightsOnly };

struct PathOptions {
  float clampIndirect = 0.0f;  // cd/m2; > 0 cuts off brighter indirect samples: fewer specks, some light lost
  LightSampling lightSampling = LightSampling::Both;
  bool looks = true;     // see Outlook; off only to measure what it brings
  bool hideSky = false;  // black where the camera sees nothing but sky
  // Where light that has bounced before is taken from; null: paths are followed to their end. Its light
  // counts to group 0.
  const LightCache* cache = nullptr;
  // What light is to be expected where: roulette ends the paths that would bring little, and lights that
  // would bring little are seldom asked. The mean is right whatever it says. Null: the cache, where there is
  // one; else roulette goes by what a path carries alone.
  const LightCache* guide = nullptr;
};

// Paths' beginnings, one a lane: the rays from the camera and the random numbers that are left.
struct PathStart {
  LaneVec origin, direction;
  LaneSampler sampler;
};
using PathStarts = LaneQueue<PathStart>;
// Adds one more.
void add(PathStarts& starts, const Ray& ray, const SamplerT<float>& sampler);

// What one path brings. Features are those of the first surface that is not clear glass or a mirror.
struct PathSample {
  Rgb radiance{};
  Rgb albedo{};
  Vec3f normal{};
  float depth = 0.0f;          // to the first surface of any kind, m
  std::uint32_t objectId = 0;  // of that surface
};

class PathTracer {
 public:
  explicit PathTracer(const CompiledScene& scene, PathOptions options = {})
      : scene_(scene), options_(options) {}

  // How many paths are best followed in one call.
  static constexpr std::size_t kBatch = 2048;

  // Follows the paths; samples: one each, in order. groups: empty, or equally many sums a path, one a light
  // group, to which its light is added. Returns how many rays it took.
  std::uint64_t trace(const PathStarts& starts, std::span<PathSample> samples,
                      std::span<Rgb> groups = {}) const;

  // Traces paths and adds what they have learned of the light to the records.
  void learn(const PathStarts& starts, std::vector<CacheRecord>& records) const;

  // Estimates of the illuminance (lux) at a point that faces along normal (unit), one a sampler.
  void illuminance(Vec3f point, Vec3f normal, std::span<const Sampler> samplers, std::span<Rgb> lux) const;

 private:
  const CompiledScene& scene_;
  PathOptions options_;
};

}  // namespace idap::render
