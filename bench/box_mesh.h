// A box of twelve triangles, for scenes of the benchmarks.
#pragma once

#include "geometry/mesh.h"

namespace idap {

inline Mesh box(Vec3f a, Vec3f b) {
  Mesh m;
  for (unsigned i = 0; i < 8; ++i)
    m.positions.push_back({i & 1 ? b.x : a.x, i & 2 ? b.y : a.y, i & 4 ? b.z : a.z});
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

}  // namespace idap
