#include "render/integrator/path.h"

#include <algorithm>
#include <cstring>

#include "render/integrator/lane_walk.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

using WalkQueue = LaneQueue<WalkState>;

// Room for all the random numbers of a step, so that those of the next do not depend on which were drawn.
constexpr std::uint32_t kDrawsAStep = 24;

// Follows the paths to their ends. begin: what happens to the lanes first, instead of a step.
template <class Begin>
void follow(WalkQueue& paths, LaneWalk& walk, Begin&& begin) {
  WalkQueue next;
  for (bool first = true; !paths.empty(); first = false) {
    next.clear();
    paths.visit([&](LaneMask active, const WalkState& state) {
      walk.state = state;
      const Words dimension = walk.state.sampler.dimension;
      const LaneMask goesOn = first ? begin(walk, active) : walk.step(active);
      walk.state.sampler.dimension = dimension + kDrawsAStep;
      if (any(goesOn)) next.push(goesOn, walk.state);
    });
    walk.answer();
    std::swap(paths, next);
  }
}

// flags: WalkFlags that they all have.
WalkQueue begun(const PathStarts& starts, std::int32_t flags = 0) {
  WalkQueue paths;
  Ints path = laneNumbers();
  starts.visit([&](LaneMask lanes, const PathStart& start) {
    WalkState state = beginWalk(start, path);
    state.flags |= flags;
    paths.push(lanes, state);
    path += kLanes;
  });
  return paths;
}

LaneMask oneStep(LaneWalk& walk, LaneMask active) { return walk.step(active); }

}  // namespace

void add(PathStarts& starts, const Ray& ray, const SamplerT<float>& sampler) {
  starts.push(firstLanes(1), {toLanes(ray.origin),
                              toLanes(ray.direction),
                              {sampler.reversedIndex, sampler.seed, sampler.dimension}});
}

std::uint64_t PathTracer::trace(const PathStarts& starts, std::span<PathSample> samples,
                                std::span<Rgb> groups) const {
  if (starts.empty()) return 0;
  WalkQueue paths = begun(starts);
  samples = samples.first(starts.size());
  std::ranges::fill(samples, PathSample{});
  WalkBatch batch{samples, groups, groups.size() / starts.size(), {}};
  LaneWalk walk(scene_, options_, batch);
  follow(paths, walk, oneStep);
  return batch.rays;
}

void PathTracer::learn(const PathStarts& starts, std::vector<CacheRecord>& records) const {
  WalkQueue paths = begun(starts);
  std::vector<PathSample> samples(starts.size());
  std::vector<std::vector<Lesson>> lessons(starts.size());
  WalkBatch batch{samples, {}, 0, lessons};
  LaneWalk walk(scene_, options_, batch);
  follow(paths, walk, oneStep);
  for (std::size_t i = 0; i < starts.size(); ++i)
    for (const Lesson& l : lessons[i]) {
      Rgb irradiance{};
      for (int k = 0; k < 3; ++k)
        if (l.scale[k] > 0) irradiance[k] = (samples[i].radiance[k] - l.before[k]) / l.scale[k];
      if (std::isfinite(maxComponent(irradiance)))
        records.push_back({l.position, LightCache::facing(l.normal), irradiance, l.squares});
    }
}

void PathTracer::illuminance(Vec3f point, Vec3f normal, std::span<const Sampler> samplers,
                             std::span<Rgb> lux) const {
  // A white Lambertian surface sends out the illuminance it receives over pi.
  PathStarts starts;
  for (const Sampler& sampler : samplers) add(starts, {point, -normal}, sampler);
  WalkQueue paths = begun(starts, kFeaturesKnown | kDepthKnown);
  LanePoints at;
  at.position = toLanes(point);
  at.offset = 1e-5f * std::max({std::fabs(point.x), std::fabs(point.y), std::fabs(point.z), 1.0f});
  at.shading.ng = at.shading.ns = toLanes(normal);
  at.shading.baseColor = toLanes({1, 1, 1});
  at.shading.roughness = at.shading.ior = 1.0f;
  at.shading.metalness = at.shading.f0 = at.shading.f90 = 0.0f;
  at.shading.transmission = at.shading.translucency = 0.0f;
  at.shading.thin = at.shading.frontFace = LaneMask(true);
  std::vector<PathSample> samples(samplers.size());
  WalkBatch batch{samples, {}, 0, {}};
  LaneWalk walk(scene_, options_, batch);
  follow(paths, walk, [&](LaneWalk& lanes, LaneMask active) { return lanes.scatter(active, at); });
  for (std::size_t i = 0; i < samplers.size(); ++i) lux[i] = samples[i].radiance * kPiF;
}

}  // namespace idap::render
