#include "studio/plan/elevation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/wall_outline.h"

namespace idap {

namespace {

// Along the horizontal of the plane, and towards the eye.
double across(Plane plane, Vec2 p) { return plane == Plane::XZ ? p.x : p.y; }
double towards(Plane plane, Vec2 p) { return plane == Plane::XZ ? -p.y : p.x; }

}  // namespace

std::vector<WallFace> wallFaces(const Home& home, WallId id, const Wall& wall, Plane plane, double section) {
  const Polygon ring = wallOutline(home, id, wall).polygon();
  const double base = elevationOf(home, wall.level);
  if (ring.size() < 3) return {};
  WallFace whole;
  whole.near = -std::numeric_limits<double>::infinity();
  double far = -whole.near;
  std::vector<std::pair<double, double>> tops;  // along the plane, height
  for (const Vec2 p : ring) {
    whole.near = std::max(whole.near, towards(plane, p));
    far = std::min(far, towards(plane, p));
    tops.emplace_back(across(plane, p), base + wallHeightAt(wall, p));
  }
  std::sort(tops.begin(), tops.end());
  // The upper hull of the top: straight for nearly every wall.
  const double left = tops.front().first, right = tops.back().first;
  double leftTop = base, rightTop = base;
  for (const auto& [u, z] : tops) {
    if (u < left + 1e-6) leftTop = std::max(leftTop, z);
    if (u > right - 1e-6) rightTop = std::max(rightTop, z);
  }
  const double end = std::max(leftTop, rightTop);
  const bool thin = std::abs(right - left) < 2.5 * wall.thickness;  // seen along: its higher end shows
  whole.polygon = {{left, base}, {right, base}, {right, thin ? end : rightTop}, {left, thin ? end : leftTop}};
  whole.kind = far > section ? WallFace::Kind::Front : WallFace::Kind::Behind;
  std::vector<WallFace> faces{whole};
  if (!(far < section && whole.near > section)) return faces;

  // Where the line of the section crosses the wall's outline, in pairs.
  std::vector<std::pair<double, double>> crossings;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    const double ta = towards(plane, a) - section, tb = towards(plane, b) - section;
    if ((ta > 0) == (tb > 0)) continue;
    const Vec2 p = a + (b - a) * (ta / (ta - tb));
    crossings.emplace_back(across(plane, p), base + wallHeightAt(wall, p));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto [u0, z0] = crossings[i];
    const auto [u1, z1] = crossings[i + 1];
    faces.push_back({{{u0, base}, {u1, base}, {u1, z1}, {u0, z0}}, WallFace::Kind::Cut, section});
  }
  return faces;
}

}  // namespace idap
