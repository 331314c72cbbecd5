// A tree over local lights, eight children a node, that chooses one light with a probability near its share
// of the light a point receives. Source of the measures: Conty Estevez and Kulla 2018, "Importance sampling
// of many lights with adaptive tree splitting"; eight children are judged at once by vector instructions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "render/emitter/light_sample.h"

namespace idap::render {

// What the tree knows of a light, or of all the lights below a node.
struct LightBounds {
  Box3f box;
  Vec3f axis{0, 0, 1};     // every direction of emission's centre lies within acos(cosSpread) of it
  float cosSpread = 1.0f;  // -1: all around
  float intensity = 0.0f;  // the largest, cd; beyond the spread it falls as the cosine
  bool bothSides = false;  // shines along -axis as well
};

LightBounds join(const LightBounds& a, const LightBounds& b);

class LightTree {
 public:
  LightTree() = default;
  explicit LightTree(std::span<const LightBounds> lights);

  bool empty() const { return nodes_.empty(); }
  struct Choice {
    std::uint32_t light = 0;
    float probability = 0.0f;  // 0: no light reaches the point
    float u = 0.0f;            // what is left of the random number, uniform again
  };
  Choice choose(const Receiver& at, float u) const;
  // The same for each lane that the mask has.
  void choose(LaneMask active, const LaneReceiver& at, const Floats& u, Choice (&choices)[kLanes]) const;
  float probability(const Receiver& at, std::uint32_t light) const;

 private:
  static constexpr int kWidth = 8;
  // Eight children, each quantity side by side.
  struct alignas(32) Node {
    float x[kWidth], y[kWidth], z[kWidth];                             // middles of their boxes
    float radius[kWidth], inverseRadius[kWidth];                       // of spheres around those
    float axisX[kWidth], axisY[kWidth], axisZ[kWidth], slack[kWidth];  // middle and radius of a ball around
                                                                       // the normals
    float intensity[kWidth];                                           // 0: no child
    float backSign[kWidth];       // -1: shines to the back as well; else 1
    std::uint32_t child[kWidth];  // node, or light with kLeaf set
    std::uint32_t parent;         // node * kWidth + place; of the root kNoParent
  };
  static constexpr std::uint32_t kLeaf = 0x80000000u, kNoParent = 0xffffffffu;

  Choice descend(std::uint32_t node, const Receiver& at, Choice choice) const;

  struct Builder;
  template <class F>
  static F importanceOf(const Node& node, int child, const Vec3T<F>& position, const Vec3T<F>& normal,
                        F behind);
  // Fills in the importance of each child; returns their sum.
  static float judge(const Node& node, const Receiver& at, float (&importance)[kWidth]);
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> places_;  // where each light hangs: node * kWidth + place
};

}  // namespace idap::render
