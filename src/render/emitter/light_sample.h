// A direction in which a light was sampled from a point. World space, metres.
#pragma once

#include <cstdint>
#include <limits>

#include "light/rgb.h"

namespace idap::render {

// Where light is received: what a choice among lights may depend on.
struct Receiver {
  Vec3f position;
  Vec3f normal;            // geometric, on the viewer's side
  bool bothSides = false;  // light from behind counts as well
};

struct LightSample {
  Vec3f wi;  // unit, towards the light
  float distance = std::numeric_limits<float>::infinity();
  Rgb weight{};      // radiance / pdf; of a point light intensity / distance^2 / probability
  float pdf = 0.0f;  // 1/sr, with the probability of choosing this light; 0: no ray can hit it by chance
  std::uint16_t lightGroup = 0;
};

}  // namespace idap::render
