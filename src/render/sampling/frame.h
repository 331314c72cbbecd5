// A right-handed orthonormal frame around a unit vector. Source: Duff et al. 2017, "Building an orthonormal
// basis, revisited".
#pragma once

#include <cmath>

#include "geometry/vec.h"

namespace idap::render {

struct Frame {
  Vec3f x, y, z;

  explicit Frame(Vec3f n) : z(n) {
    const float s = std::copysign(1.0f, n.z);
    const float a = -1 / (s + n.z);
    const float b = n.x * n.y * a;
    x = {1 + s * n.x * n.x * a, s * b, -s * n.x};
    y = {b, s + n.y * n.y * a, -n.y};
  }
  Vec3f toWorld(Vec3f v) const { return x * v.x + y * v.y + z * v.z; }
  Vec3f toLocal(Vec3f v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

}  // namespace idap::render
