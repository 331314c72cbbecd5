#include "render/integrator/path.h"

#include <algorithm>
#include <cstring>

#include "render/integrator/lane_walk.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

using WalkQueue = LaneQueue<WalkState<Floats>>;

// Lanes are filled one by one.
class WalkMaker {
 public:
  explicit WalkMaker(WalkQueue& queue) : queue_(queue) {}
  ~WalkMaker() { flush(); }
  void put(const WalkState<float>& state) {
    const auto* words = reinterpret_cast<const char*>(&state);
    for (std::size_t w = 0; w < WalkQueue::kWords; ++w)
      std::memcpy(&words_[w][held_], words + w * sizeof(float), sizeof(float));
    ++count_;
    if (++held_ == kLanes) flush();
  }
  int count() const { return count_; }

 private:
  void flush() {
    WalkState<Floats> lanes;
    std::memcpy(static_cast<void*>(&lanes), static_cast<const void*>(words_), sizeof(lanes));
    queue_.push(toMask(Ints([](int k) { return k; }) < held_), lanes);
    held_ = 0;
  }
  WalkQueue& queue_;
  LaneArray words_[WalkQueue::kWords];
  int held_ = 0, count_ = 0;
};

// Room for all the random numbers of a step, so that those of the next do not depend on which were drawn.
constexpr std::uint32_t kDrawsAStep = 24;

// Follows the paths to their ends. begin: what happens to the lanes first, instead of a step.
template <class Begin>
void follow(WalkQueue& paths, LaneWalk& walk, Begin&& begin) {
  WalkQueue next;
  for (bool first = true; !paths.empty(); first = false) {
    next.clear();
    paths.visit(walk.state, [&](LaneMask active) {
      const Words dimension = walk.state.sampler.dimension;
      const LaneMask goesOn = first ? begin(walk, active) : walk.step(active);
      walk.state.sampler.dimension = dimension + kDrawsAStep;
      if (any(goesOn)) next.push(goesOn, walk.state);
    });
    walk.answer();
    std::swap(paths, next);
  }
}

WalkQueue begun(std::span<const PathStart> starts) {
  WalkQueue paths;
  for (WalkMaker make(paths); const PathStart& start : starts) make.put(beginWalk(start, make.count()));
  return paths;
}

LaneMask oneStep(LaneWalk& walk, LaneMask active) { return walk.step(active); }

}  // namespace

void PathTracer::trace(std::span<const PathStart> starts, std::span<PathSample> samples,
                       std::span<Rgb> groups) const {
  if (starts.empty()) return;
  WalkQueue paths = begun(starts);
  samples = samples.first(starts.size());
  std::ranges::fill(samples, PathSample{});
  WalkBatch batch{samples, groups, groups.size() / starts.size(), {}};
  LaneWalk walk(scene_, options_, batch);
  follow(paths, walk, oneStep);
}

void PathTracer::learn(std::span<const PathStart> starts, std::vector<CacheRecord>& records) const {
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
  WalkQueue paths;
  for (WalkMaker make(paths); const Sampler& sampler : samplers) {
    WalkState<float> state = beginWalk({{point, -normal}, sampler}, make.count());
    state.flags |= kFeaturesKnown | kDepthKnown;
    make.put(state);
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
  follow(paths, walk, [&](LaneWalk& lanes, LaneMask active) { return lanes.scatter(active, at); });
  for (std::size_t i = 0; i < samplers.size(); ++i) lux[i] = samples[i].radiance * kPiF;
}

}  // namespace idap::render
