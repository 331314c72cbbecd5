// One step of many paths side by side: from one surface to the next. See PathTracer.
#pragma once

#include <span>
#include <vector>

#include "render/emitter/light_sample.h"
#include "render/integrator/path.h"

namespace idap::render {

// A point whose light is not known yet.
struct Lesson {
  Vec3f position, normal;
  Rgb before;  // what the path had gathered
  Rgb scale;   // what it gathers from here on, of one lux there
};

// Where paths are. Numbers of four bytes only, so that paths can be gathered into lanes word by word.
// F: float for a path by itself, Floats for lanes.
template <class F>
struct WalkState {
  Vec3T<F> origin, direction;  // of the ray under way
  F tMin;
  Vec3T<F> throughput;
  F etaScale;  // undoes the squeezing of radiance in glass where roulette judges the throughput
  Vec3T<F> fromPosition, fromNormal;  // where the ray was scattered,
  F pdf;                              // and the density with which
  F localShare, skyShare;             // how likely light sampling asked lamps and the sky there
  Vec3T<F> radiance;                  // gathered so far
  F worth;                            // cd/m2, that the guide has to expect to follow it; 0: not known yet
  SamplerT<F> sampler;
  Int<F> flags;  // WalkFlag
  Int<F> bounces, segments, rays;
};
inline constexpr std::size_t kWalkWords = sizeof(WalkState<float>) / sizeof(float);
static_assert(sizeof(WalkState<Floats>) == kWalkWords * sizeof(Floats));

enum WalkFlag : std::int32_t {
  kFromBothSides = 1,  // of the receiver there
  kLooked = 2,         // looks from there could have found the same
  kSharp = 4,          // camera or delta lobe: no light sampling could have found the same
  kFeaturesKnown = 8,
  kDepthKnown = 16,
  // At the next surface, rather than the sky; decided beforehand, so that those who do can go together.
  kAsksLamps = 32,
};

WalkState<float> beginWalk(const PathStart& start);

// The paths of one call, by number.
struct WalkBatch {
  std::span<PathSample> samples;
  std::span<Rgb> groups;
  std::size_t groupCount = 0;
  std::span<std::vector<Lesson>> lessons;  // empty: nothing is to be learned
};

class LaneWalk {
 public:
  LaneWalk(const CompiledScene& scene, const PathOptions& options, WalkBatch& batch)
      : scene_(scene), options_(options), batch_(batch) {}

  // Where the lanes' paths are, and their numbers in the batch. Lanes at rest may be anywhere.
  WalkState<Floats> state;
  int path[kLanes];

  // Follows the rays to the next surfaces and chooses where they go on from there. The lanes that do go on.
  LaneMask step(LaneMask active);
  // Lanes that will do the same at the next surface.
  LaneMask askingLamps() const { return has(kAsksLamps); }

  // Adds the light that reaches the points directly and chooses where the paths go on. The lanes that do.
  LaneMask scatter(LaneMask active, const LanePoints& at);

 private:
  bool has(WalkFlag flag, int k) const { return (lane(state.flags, k) & flag) != 0; }
  LaneMask has(WalkFlag flag) const { return toMask((state.flags & Ints(flag)) != 0); }
  void set(LaneMask lanes, WalkFlag flag) {
    state.flags = select(lanes, state.flags | Ints(flag), state.flags);
  }
  // A number for lanes that want one; all lanes' samplers go on.
  Floats draw1D(LaneMask wanted);
  LaneVec2 draw2D(LaneMask wanted);

  Receiver receiver(int k) const {
    return {lane(state.fromPosition, k), lane(state.fromNormal, k), has(kFromBothSides, k)};
  }
  LaneReceiver receiver() const { return {state.fromPosition, state.fromNormal, has(kFromBothSides)}; }
  Floats clamped(const LaneVec& light, LaneMask indirect) const;
  void add(LaneMask lanes, const LaneVec& light, const Ints& group);
  // Light that a ray has met by itself.
  void addMet(int k, Rgb light, std::uint16_t group);
  void addSky(LaneMask lanes);
  void addLamps(LaneMask lanes, const LaneHits& hits);
  void addEmission(LaneMask lanes, const LaneHits& hits, const LanePoints& at);
  void noteFeatures(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);
  void connect(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf,
               const LightSampleT<Floats>& light, LaneMask byLooks);
  void lookOut(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf, const LaneReceiver& here,
               const Floats& choice, const Floats& lookShare);
  void askLamps(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf, const LaneReceiver& here,
                const Floats& choice, const Floats& localShare, LaneMask byLooks);
  LaneMask judge(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf, LaneMask& ended);
  LaneMask takeFromCache(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);

  const CompiledScene& scene_;
  const PathOptions& options_;
  WalkBatch& batch_;
};

}  // namespace idap::render
