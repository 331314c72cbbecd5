// The light that comes to surface points straight from its sources. Only some points ask each source (what a
// guide expects little of, seldom), so the questions of many lanes are collected and answered side by side
// again: no lane is idle, however few ask.
#pragma once

#include "render/emitter/light_sample.h"
#include "render/integrator/walk_batch.h"
#include "render/lanes/lane_queue.h"
#include "render/material/bsdf.h"

namespace idap::render {

// A surface point, and what weighs the light that comes to it. Numbers of four bytes only, so that lanes can
// be moved word by word.
struct Ask {
  LaneVec position, ng, ns, baseColor;
  LaneVec direction;  // of the ray that found the point
  LaneVec throughput;
  // Where that ray had been scattered, with what density, and how likely a look went out from there.
  LaneVec fromPosition, fromNormal;
  Floats fromPdf, fromSkyShare;
  Floats offset, roughness, metalness, ior, f0, f90, transmission, translucency;  // as in LanePoints
  Floats share;  // how likely the source was asked
  LaneSampler sampler;
  Ints flags;  // AskFlag
  Ints path;   // its number in the batch
};

enum AskFlag : std::int32_t {
  kAskThin = 1,  // as in LanePoints
  kAskFront = 2,
  kAskSmooth = 4,
  kAskBothSides = 8,       // light from behind counts as well
  kAskFromBothSides = 16,  // the same where the ray came from
  kAskSharp = 32,          // no light sampling could have found what the ray has
  kAskByLooks = 64,        // looks from where the ray came from could have
  kAskIndirect = 128,      // the camera does not see the point
  kAskFarther = 256,       // nor the point before
  kAskLearns = 512,        // the path's last lesson is of this point
};

class DirectLight {
 public:
  DirectLight(const CompiledScene& scene, const PathOptions& options, WalkBatch& batch)
      : scene_(scene), options_(options), batch_(batch) {}

  void ask(LightSource source, LaneMask lanes, const Ask& ask) {
    if (any(lanes)) queues_[static_cast<std::size_t>(source)].push(lanes, ask);
  }
  // Asks for what a look finds instead of the sky.
  void askByLook(LaneMask lanes, const Ask& ask) {
    if (any(lanes)) looks_.push(lanes, ask);
  }
  // Rays that have left the scene.
  void meetSky(LaneMask lanes, const Ask& ask) {
    if (any(lanes)) out_.push(lanes, ask);
  }
  // Adds the light of all that has been asked and met.
  void answer();

 private:
  struct Point;
  // Light of a source that a look could have found as well, and how likely.
  struct Doubled {
    LaneVec light;
    LaneVec direction, fromPosition, fromNormal;  // as in Ask
    Floats fromPdf, fromSkyShare, share;
    Ints flags, path, group, source;
  };
  void addSky(LaneMask lanes, const Ask& ask);
  void askSun(LaneMask lanes, const Ask& ask);
  void askLamps(LaneMask lanes, const Ask& ask);
  void askSky(LaneMask lanes, const Ask& ask);
  void lookOut(LaneMask lanes, const Ask& ask);
  void addDoubled(LaneMask lanes, const Doubled& found);
  void connect(LightSource source, LaneMask lanes, const Ask& ask, const Point& point,
               const LightSampleT<Floats>& light);
  // asked: an Ask or Doubled.
  template <class Asked>
  void add(LightSource source, LaneMask lanes, const Asked& asked, const LaneVec& light, const Ints& group);

  const CompiledScene& scene_;
  const PathOptions& options_;
  WalkBatch& batch_;
  LaneQueue<Ask> queues_[kLightSources], looks_, out_;
  LaneQueue<Doubled> doubled_;
};

// What indirect light is to be multiplied by, lest it be too bright.
inline Floats clampScale(const PathOptions& options, const LaneVec& light, LaneMask indirect) {
  if (!(options.clampIndirect > 0)) return 1.0f;
  const Floats scale = lane_math::min(options.clampIndirect / lane_math::max(luminance(light), 1e-20f), 1.0f);
  return select(indirect, scale, Floats(1.0f));
}

}  // namespace idap::render
