// Walls from point to point, for tests.
#pragma once

#include <vector>

#include "model/home.h"

namespace idap::test {

inline Wall wall(Vec2 start, Vec2 end, double thickness = 0.2, double height = 2.5) {
  Wall w;
  w.start = start;
  w.end = end;
  w.thickness = thickness;
  w.heightAtStart = w.heightAtEnd = height;
  return w;
}

// Adds walls from point to point, joined to each other; closed: also from the last to the first.
inline std::vector<WallId> addWalls(Home& home, const std::vector<Vec2>& points, bool closed = true,
                                    double thickness = 0.2, double height = 2.5) {
  std::vector<WallId> ids;
  const std::size_t n = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < n; ++i) ids.push_back(home.newId<WallId>());
  for (std::size_t i = 0; i < n; ++i) {
    Wall w = wall(points[i], points[(i + 1) % points.size()], thickness, height);
    if (i > 0 || closed) w.neighbourAtStart = ids[(i + n - 1) % n];
    if (i + 1 < n || closed) w.neighbourAtEnd = ids[(i + 1) % n];
    home.walls.set(ids[i], w);
  }
  return ids;
}

}  // namespace idap::test
