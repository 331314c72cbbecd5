#include "editor/plane.h"

#include <algorithm>

namespace idap {

Polygon outline(Plane plane, const Piece& piece, double elevation) {
  const Transform place = placement(piece);
  std::vector<Vec2> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const Vec3 p = place.point({x * piece.size.x, y * piece.size.y, z * piece.size.z});
        corners.push_back(project(plane, p + Vec3{0, 0, elevation}));
      }
  // Andrew's monotone chain.
  std::sort(corners.begin(), corners.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  Polygon hull;
  for (const bool upper : {false, true}) {
    const std::size_t base = hull.size();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 p = corners[upper ? corners.size() - 1 - i : i];
      while (hull.size() >= base + 2 &&
             cross(hull[hull.size() - 1] - hull[hull.size() - 2], p - hull[hull.size() - 1]) <= 1e-12)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
  }
  return hull;
}

}  // namespace idap
