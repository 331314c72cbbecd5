// A direction in which a light was sampled from a point; one, or one a lane. World space, metres.
#pragma once

#include <limits>

#include "render/lanes/lanes.h"

namespace idap::render {

// Where light is received: what a choice among lights may depend on.
template <class F>
struct ReceiverT {
  Vec3T<F> position;
  Vec3T<F> normal;           // geometric, on the viewer's side
  Mask<F> bothSides{false};  // light from behind counts as well
};
using Receiver = ReceiverT<float>;
using LaneReceiver = ReceiverT<Floats>;

template <class F>
struct LightSampleT {
  Vec3T<F> wi;  // unit, towards the light
  F distance = std::numeric_limits<float>::infinity();
  Vec3T<F> weight;  // radiance / pdf; of a point light intensity / distance^2 / probability
  F pdf = 0.0f;     // 1/sr, with the probability of choosing this light; 0: no ray can hit it by chance
  Int<F> lightGroup = 0;
};
using LightSample = LightSampleT<float>;

// What is found by a strategy of density a counts where one of density b could have found it as well: the
// power heuristic with exponent 2; b may be 0.
template <class F>
F share(F a, F b) {
  const F r = b / a;
  return 1.0f / (1.0f + r * r);
}

}  // namespace idap::render
