// A right-handed orthonormal frame around a unit vector. Source: Duff et al. 2017, "Building an orthonormal
// basis, revisited".
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

template <class F>
struct FrameT {
  using V = Vec3T<F>;
  V x, y, z;

  explicit FrameT(const V& n) : z(n) {
    using lane_math::copysign;
    const F s = copysign(F(1.0f), n.z);
    const F a = -1.0f / (s + n.z);
    const F b = n.x * n.y * a;
    x = {1.0f + s * n.x * n.x * a, s * b, -s * n.x};
    y = {b, s + n.y * n.y * a, -n.y};
  }
  V toWorld(const V& v) const { return x * v.x + y * v.y + z * v.z; }
  V toLocal(const V& v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};
using Frame = FrameT<float>;

}  // namespace idap::render
