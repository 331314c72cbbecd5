#include "editor/tools/select/opening_measures.h"

#include <algorithm>

#include "editor/selection.h"
#include "model/wall_path.h"

namespace idap {

std::vector<MeasureLine> openingMeasures(const Home& home, Plane plane, const Opening& opening,
                                         const Elements& ignored) {
  std::vector<MeasureLine> lines;
  const double floor = elevationOf(home, opening.level);
  const Vec2 at{opening.position.x, opening.position.y};
  if (plane != Plane::XY && opening.position.z > 1e-3) {
    const Vec2 sill = project(plane, opening.position + Vec3{0, 0, floor});
    lines.push_back({sill, {sill.x, floor}, false});
  }
  const Wall* wall = home.walls.find(opening.wall);
  if (!wall || wall->arcExtent != 0) return lines;
  const WallPath path(*wall);
  double low = 0, high = path.length();
  if (const Wall* other = home.walls.find(wall->neighbourAtStart)) low += other->thickness / 2;
  if (const Wall* other = home.walls.find(wall->neighbourAtEnd)) high -= other->thickness / 2;
  const double middle = path.nearest(at);
  for (const auto& [id, other] : home.openings) {
    if (other->wall != opening.wall || contains(ignored, id)) continue;
    const double s = path.nearest({other->position.x, other->position.y}), half = other->size.x / 2;
    if (s < middle)
      low = std::max(low, s + half);
    else
      high = std::min(high, s - half);
  }
  const double half = opening.size.x / 2, z = floor + opening.position.z + opening.size.z / 2;
  const auto add = [&](double from, double to) {
    const Vec2 a = path.point(from), b = path.point(to);
    const Vec2 p = project(plane, {a.x, a.y, z}), q = project(plane, {b.x, b.y, z});
    if (length(q - p) > 1e-3) lines.push_back({p, q, false});
  };
  if (middle - half > low) add(middle - half, low);
  if (middle + half < high) add(middle + half, high);
  return lines;
}

}  // namespace idap
