// Where the sun falls into rooms through portals, and after dark the insides of lamps that are open but shade
// their bulbs. These patches are small and so bright that much of a room's light comes from them; a path
// tracer finds them by looking there. They guide only: what a ray finds is what counts, so patches that are
// out of date or hidden cost time, not truth.
#pragma once

#include <vector>

#include "render/emitter/light_sample.h"

namespace idap::render {

class CompiledScene;

class SunPatches {
 public:
  SunPatches() = default;
  explicit SunPatches(const CompiledScene& scene);

  static constexpr int kMost = 64;
  bool empty() const { return !(total_ > 0); }
  // Whether there are lamps to look at.
  bool hasLamps() const { return firstLamp_ < patches_.size(); }
  // The points that lie within the patches of lamps.
  LaneMask nearLamps(const LaneVec& points) const;

 private:
  template <class F>
  friend class SunPatchViewT;
  struct Spot {
    Vec3f position, normal;
    float flux = 0.0f;
  };
  // Adds the spots in at most so many groups of about so large a radius (m) or more, with a margin around.
  void cluster(std::vector<Spot>& spots, std::size_t most, float smallest, float margin);
  void addSun(const CompiledScene& scene);
  void addLamps(const CompiledScene& scene);

  // A sphere around a group of spots.
  struct Patch {
    Vec3f centre;
    float radius = 0.0f, flux = 0.0f;
    Vec3f normal;        // the mean of the spots' unit normals
    float slack = 0.0f;  // how far those differ
  };
  std::vector<Patch> patches_;  // at most kMost; the sun's first
  std::size_t firstLamp_ = 0;
  float total_ = 0.0f;
};

// The patches as a point sees them: a density over directions, a mixture of cones. F: float, or Floats for
// one point a lane.
template <class F>
class SunPatchViewT {
 public:
  SunPatchViewT(const SunPatches& patches, const ReceiverT<F>& at);

  Mask<F> empty() const { return !(sum_ > 0.0f); }
  F pdf(const Vec3T<F>& direction) const;  // 1/sr
  Vec3T<F> sample(F choice, const Vec2T<F>& u) const;

 private:
  int count_ = 0;                          // of those that shine on the point
  Vec3T<F> direction_[SunPatches::kMost];  // to the middles, unit
  F oneMinusCos_[SunPatches::kMost];
  F weight_[SunPatches::kMost];
  F sum_ = 0.0f;
};
using SunPatchView = SunPatchViewT<float>;

extern template class SunPatchViewT<float>;
extern template class SunPatchViewT<Floats>;

}  // namespace idap::render
