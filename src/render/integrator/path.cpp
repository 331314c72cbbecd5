#include "render/integrator/path.h"

#include <algorithm>
#include <cstring>

#include "render/integrator/lane_walk.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

// The states of a batch's paths, word by word behind one another, with room for the lanes at rest.
class WalkPool {
 public:
  explicit WalkPool(std::size_t count) : words_((count + kLanes) * kWalkWords) {}

  void put(std::size_t i, const WalkState<float>& state) {
    std::memcpy(words_.data() + i * kWalkWords, static_cast<const void*>(&state), sizeof(state));
  }
  WalkState<float> get(std::size_t i) const {
    WalkState<float> state;
    std::memcpy(static_cast<void*>(&state), words_.data() + i * kWalkWords, sizeof(state));
    return state;
  }
  void load(const Ints& paths, WalkState<Floats>& state) const {
    Floats lanes[kWalkWords];
    const Ints first = paths * static_cast<std::int32_t>(kWalkWords);
    for (std::size_t w = 0; w < kWalkWords; ++w) lanes[w] = gather(words_.data() + w, first);
    std::memcpy(static_cast<void*>(&state), static_cast<const void*>(lanes), sizeof(state));
  }
  void store(const Ints& paths, const WalkState<Floats>& state) {
    float lanes[kWalkWords][kLanes];
    std::memcpy(static_cast<void*>(lanes), static_cast<const void*>(&state), sizeof(state));
    for (int k = 0; k < kLanes; ++k) {
      float* words = words_.data() + static_cast<std::size_t>(lane(paths, k)) * kWalkWords;
      for (std::size_t w = 0; w < kWalkWords; ++w) words[w] = lanes[w][k];
    }
  }

 private:
  std::vector<float> words_;
};

// Room for all the random numbers of a step, so that those of the next do not depend on which were drawn.
constexpr std::uint32_t kDrawsAStep = 16;

// Follows the paths to their ends. begin: what happens to the lanes first, instead of a step.
template <class Begin>
void follow(WalkPool& pool, LaneWalk& walk, const WalkBatch& batch, Begin&& begin) {
  const std::size_t count = batch.samples.size();
  std::vector<std::int32_t> alive(count), next, toLamps;
  for (std::size_t i = 0; i < count; ++i) alive[i] = static_cast<std::int32_t>(i);
  for (bool first = true; !alive.empty(); first = false) {
    next.clear();
    toLamps.clear();
    for (std::size_t from = 0; from < alive.size(); from += kLanes) {
      const std::size_t some = std::min(alive.size() - from, static_cast<std::size_t>(kLanes));
      for (std::size_t k = 0; k < kLanes; ++k)
        walk.path[k] = k < some ? alive[from + k] : static_cast<std::int32_t>(count + k);
      const Ints paths(walk.path, simd::element_aligned);
      pool.load(paths, walk.state);
      const LaneMask active = toMask(paths < static_cast<std::int32_t>(count));
      const Words dimension = walk.state.sampler.dimension;
      const LaneMask goesOn = first ? begin(walk, active) : walk.step(active);
      walk.state.sampler.dimension = dimension + kDrawsAStep;
      pool.store(paths, walk.state);
      const LaneMask lamps = walk.askingLamps();
      forLanes(goesOn, [&](int k) { (lane(lamps, k) ? toLamps : next).push_back(walk.path[k]); });
    }
    // Those that will ask the same go together.
    next.insert(next.end(), toLamps.begin(), toLamps.end());
    alive.swap(next);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const WalkState<float> end = pool.get(i);
    batch.samples[i].radiance = end.radiance;
    batch.samples[i].rays = static_cast<std::uint32_t>(end.rays);
  }
}

LaneMask oneStep(LaneWalk& walk, LaneMask active) { return walk.step(active); }

}  // namespace

void PathTracer::trace(std::span<const PathStart> starts, std::span<PathSample> samples,
                       std::span<Rgb> groups) const {
  if (starts.empty()) return;
  WalkPool pool(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) pool.put(i, beginWalk(starts[i]));
  samples = samples.first(starts.size());
  std::ranges::fill(samples, PathSample{});
  WalkBatch batch{samples, groups, groups.size() / starts.size(), {}};
  LaneWalk walk(scene_, options_, batch);
  follow(pool, walk, batch, oneStep);
}

void PathTracer::learn(std::span<const PathStart> starts, std::vector<CacheRecord>& records) const {
  WalkPool pool(starts.size());
  for (std::size_t i = 0; i < starts.size(); ++i) pool.put(i, beginWalk(starts[i]));
  std::vector<PathSample> samples(starts.size());
  std::vector<std::vector<Lesson>> lessons(starts.size());
  WalkBatch batch{samples, {}, 0, lessons};
  LaneWalk walk(scene_, options_, batch);
  follow(pool, walk, batch, oneStep);
  for (std::size_t i = 0; i < starts.size(); ++i)
    for (const Lesson& l : lessons[i]) {
      Rgb irradiance{};
      for (int k = 0; k < 3; ++k)
        if (l.scale[k] > 0) irradiance[k] = (samples[i].radiance[k] - l.before[k]) / l.scale[k];
      if (std::isfinite(maxComponent(irradiance)))
        records.push_back({l.position, LightCache::facing(l.normal), irradiance});
    }
}

void PathTracer::illuminance(Vec3f point, Vec3f normal, std::span<const Sampler> samplers,
                             std::span<Rgb> lux) const {
  // A white Lambertian surface sends out the illuminance it receives over pi.
  WalkPool pool(samplers.size());
  for (std::size_t i = 0; i < samplers.size(); ++i) {
    WalkState<float> state = beginWalk({{point, -normal}, samplers[i]});
    state.flags |= kFeaturesKnown | kDepthKnown;
    pool.put(i, state);
  }
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
  follow(pool, walk, batch, [&](LaneWalk& lanes, LaneMask active) { return lanes.scatter(active, at); });
  for (std::size_t i = 0; i < samplers.size(); ++i) lux[i] = samples[i].radiance * kPiF;
}

}  // namespace idap::render
