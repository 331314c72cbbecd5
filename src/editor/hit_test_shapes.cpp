#include "editor/hit_test_shapes.h"

#include <algorithm>
#include <limits>

#include "model/wall_outline.h"

namespace idap {

Vec2 cameraAim(Plane plane, const Camera& camera) {
  const Vec2 flat = project(plane, viewDirection(camera)), eye = project(plane, camera.eye);
  const double share = length(flat);
  return share > 0.05 ? eye + flat * (kCameraCone * (0.4 + 0.6 * share) / share) : eye;
}

Polygon cameraCone(Plane plane, const Camera& camera) {
  const Vec2 eye = project(plane, camera.eye);
  const Vec2 ahead = cameraAim(plane, camera) - eye;
  double half = camera.fieldOfView / 2;
  if (plane != Plane::XY) half = std::atan(std::tan(half) * 0.75);
  half = std::clamp(half, 0.05, kPi * 0.49);
  return {eye, eye + rotated(ahead, -half), eye + rotated(ahead, half)};
}

std::optional<DimensionLine> dimensionLine(Plane plane, const Dimension& dimension, double elevation) {
  const double rise = dimension.endElevation - dimension.startElevation;
  if (plane != Plane::XY && std::abs(rise) < 1e-6 && std::abs(dimension.startElevation) < 1e-6) return {};
  DimensionLine line;
  line.start = project(plane, {dimension.start.x, dimension.start.y, elevation + dimension.startElevation});
  line.end = project(plane, {dimension.end.x, dimension.end.y, elevation + dimension.endElevation});
  const Vec2 along = line.end - line.start;
  const double span = length(along);
  if (span < 1e-3) return {};
  const Vec2 aside = perpendicular(along / span) * dimension.offset;
  line.from = line.start + aside;
  line.to = line.end + aside;
  return line;
}

Polygon labelBox(const Label& label) {
  std::size_t lines = 1, letters = 0, widest = 0;
  for (const char c : label.text) {
    if (c == '\n') {
      ++lines;
      letters = 0;
    } else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80) {  // the first byte of a letter
      widest = std::max(widest, ++letters);
    }
  }
  const double size = label.style.size;
  const double width = std::max(1.0, 0.55 * static_cast<double>(widest)) * size;
  const double left = label.style.alignment == TextAlignment::Left    ? 0
                      : label.style.alignment == TextAlignment::Right ? -width
                                                                      : -width / 2;
  const double top = 0.6 * size * static_cast<double>(lines), bottom = -top;
  Polygon box{{left, bottom}, {left + width, bottom}, {left + width, top}, {left, top}};
  for (Vec2& p : box) p = label.position + rotated(p, label.angle);
  return box;
}

Polygon outline(Plane plane, const Home& home, WallId id, const Wall& wall) {
  Polygon plan = wallOutline(home, id, wall).polygon();
  if (plane == Plane::XY) return plan;
  const double floor = elevationOf(home, wall.level);
  std::vector<Vec2> points;
  points.reserve(plan.size() * 2);
  for (const Vec2 p : plan) {
    points.push_back(project(plane, {p.x, p.y, floor}));
    points.push_back(project(plane, {p.x, p.y, floor + wallHeightAt(wall, p)}));
  }
  return convexHull(std::move(points));
}

double sectionNearness(const Home& home, LevelId level, Plane plane) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != level) continue;
    for (const Vec2 p : {wall->start, wall->end}) {
      const double near = nearness(plane, {p.x, p.y, 0});
      low = std::min(low, near);
      high = std::max(high, near);
    }
  }
  return low <= high ? (low + high) / 2 : 0;
}

}  // namespace idap
