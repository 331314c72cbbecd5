// Where the sun falls into rooms through portals. These patches are small and so bright that most of a sunny
// room's light comes from them; a path tracer finds them by steering part of its bounces there. They guide
// only: what a ray finds is what counts, so patches that are out of date or hidden cost time, not truth.
#pragma once

#include <vector>

#include "render/emitter/light_sample.h"

namespace idap::render {

class CompiledScene;

class SunPatches {
 public:
  SunPatches() = default;
  explicit SunPatches(const CompiledScene& scene);

  static constexpr int kMost = 32;
  bool empty() const { return !(total_ > 0); }

 private:
  friend class SunPatchView;
  struct Spot {
    Vec3f position, normal;
    float flux = 0.0f;
  };
  void cluster(std::vector<Spot>& spots);

  // Spheres around groups of spots, each quantity side by side; unused ones have no flux.
  alignas(32) float x_[kMost] = {}, y_[kMost] = {}, z_[kMost] = {};
  float radius_[kMost] = {};
  float flux_[kMost] = {};
  float normalX_[kMost] = {}, normalY_[kMost] = {}, normalZ_[kMost] = {};  // means of unit normals
  float slack_[kMost] = {};                                                // how far the normals differ
  float total_ = 0.0f;
};

// The patches as one point sees them: a density over directions, a mixture of cones.
class SunPatchView {
 public:
  SunPatchView(const SunPatches& patches, const Receiver& at);

  bool empty() const { return !(sum_ > 0); }
  float pdf(Vec3f direction) const;  // 1/sr
  Vec3f sample(float choice, Vec2f u) const;

 private:
  static constexpr int kMost = SunPatches::kMost;
  alignas(32) float x_[kMost], y_[kMost], z_[kMost];  // unit directions to the middles
  float oneMinusCos_[kMost];
  float weight_[kMost];
  float density_[kMost];  // weight over solid angle
  float sum_ = 0.0f;
};

}  // namespace idap::render
