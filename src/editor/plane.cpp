#include "editor/plane.h"

#include <algorithm>
#include <limits>

namespace idap {

Polygon convexHull(std::vector<Vec2> points) {
  // Andrew's monotone chain.
  std::sort(points.begin(), points.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  Polygon hull;
  for (const bool upper : {false, true}) {
    const std::size_t base = hull.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 p = points[upper ? points.size() - 1 - i : i];
      while (hull.size() >= base + 2 &&
             cross(hull[hull.size() - 1] - hull[hull.size() - 2], p - hull[hull.size() - 1]) <= 1e-12)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
  }
  return hull;
}

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double squared = dot(along, along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return length(p - (a + along * t));
}

double distanceToPath(const std::vector<Vec2>& points, bool closed, Vec2 p) {
  double nearest = points.empty() ? std::numeric_limits<double>::infinity() : length(points.front() - p);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(p, points[i], points[i + 1]));
  if (closed && points.size() > 2)
    nearest = std::min(nearest, distanceToSegment(p, points.back(), points.front()));
  return nearest;
}

Polygon outline(Plane plane, const Piece& piece, double elevation) {
  const Transform place = placement(piece);
  std::vector<Vec2> corners;
  corners.reserve(8);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const Vec3 p = place.point({x * piece.size.x, y * piece.size.y, z * piece.size.z});
        corners.push_back(project(plane, p + Vec3{0, 0, elevation}));
      }
  return convexHull(std::move(corners));
}

}  // namespace idap
