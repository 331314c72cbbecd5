// A binary tree over local lights that chooses one with a probability near its share of the light a point
// receives. Source: Conty Estevez and Kulla 2018, "Importance sampling of many lights with adaptive tree
// splitting".
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

  float importance(const Receiver& at) const;
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
  float probability(const Receiver& at, std::uint32_t light) const;

 private:
  struct Node {
    LightBounds bounds;
    std::uint32_t right = 0;  // the left child follows its parent; 0: a leaf
    std::uint32_t light = 0;
  };
  std::uint32_t build(std::span<const LightBounds> lights, std::span<std::uint32_t> order, std::uint64_t path,
                      int depth);
  std::vector<Node> nodes_;
  std::vector<std::uint64_t> paths_;  // bit d of a light's: which way to turn at depth d
};

}  // namespace idap::render
