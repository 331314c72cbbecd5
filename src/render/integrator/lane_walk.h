// One step of many paths side by side: from one surface to the next. See PathTracer.
#pragma once

#include "render/integrator/direct_light.h"

namespace idap::render {

// Where paths are, one a lane. Numbers of four bytes only, so that lanes can be moved word by word.
struct WalkState {
  LaneVec origin, direction;  // of the ray under way
  Floats tMin;
  LaneVec throughput;
  Floats etaScale;  // undoes the squeezing of radiance in glass where roulette judges the throughput
  LaneVec fromPosition, fromNormal;  // where the ray was scattered,
  Floats pdf;                        // and the density with which
  Floats localShare, skyShare;       // how likely light sampling asked lamps and the sky there
  Floats worth;                      // cd/m2, that the guide has to expect to follow it; 0: not known yet
  LaneSampler sampler;
  Ints flags;  // WalkFlag
  Ints bounces, segments;
  Ints path;  // its number in the batch
};

// Roulette: bounces that are always followed where the guide does not know the surface, and the likelihood
// that no path goes beyond after them.
inline constexpr int kRouletteWithGuide = 8;
inline constexpr float kMostSurvival = 0.98f;

enum WalkFlag : std::int32_t {
  kFromBothSides = 1,  // of the receiver there
  kLooked = 2,         // looks from there could have found the same
  kSharp = 4,          // camera or delta lobe: no light sampling could have found the same
  kFeaturesKnown = 8,
  kDepthKnown = 16,
};

WalkState beginWalk(const PathStart& start, const Ints& path);

class LaneWalk {
 public:
  LaneWalk(const CompiledScene& scene, const PathOptions& options, WalkBatch& batch)
      : scene_(scene),
        options_(options),
        guide_(options.guide ? options.guide : options.cache),
        batch_(batch),
        direct_(scene, options, batch) {}

  // Where the lanes' paths are. Lanes at rest may be anywhere.
  WalkState state;

  // Follows the rays to the next surfaces and chooses where they go on from there. The lanes that do go on.
  LaneMask step(LaneMask active);

  // Asks for the light that reaches the points directly and chooses where the paths go on. The lanes that do.
  LaneMask scatter(LaneMask active, const LanePoints& at);
  // Adds the light that has been asked for since the last time.
  void answer() { direct_.answer(); }

 private:
  int pathOf(int k) const { return lane(state.path, k); }
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
  void add(LaneMask lanes, const LaneVec& light, const Ints& group);
  // Light that a ray has met by itself.
  void addMet(int k, Rgb light, std::uint16_t group);
  void addLamps(LaneMask lanes, const LaneHits& hits);
  void addEmission(LaneMask lanes, const LaneHits& hits, const LanePoints& at);
  void noteFeatures(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);
  // What the guide says of the lanes' points.
  struct Guided {
    LaneMask known{false};
    Floats lux = 0.0f;
    Floats carries = 0.0f;  // cd/m2 of the picture, of one lux here
    Floats asked[kLightSources];
  };
  Guided askGuide(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);
  LaneMask judge(LaneMask lanes, Guided& guided);
  Floats rate(const Guided& guided, LightSource source) const;
  Ask askAlong() const;
  Ask askAt(const LanePoints& at, const LaneReceiver& here) const;
  // The lanes that learn at this point.
  LaneMask learn(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);
  LaneMask takeFromCache(LaneMask lanes, const LanePoints& at, const BsdfT<Floats>& bsdf);

  const CompiledScene& scene_;
  const PathOptions& options_;
  const LightCache* guide_;
  WalkBatch& batch_;
  DirectLight direct_;
};

}  // namespace idap::render
