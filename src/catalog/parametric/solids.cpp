// Plain bodies, drawn by the solid tools: box, cylinder and cone, ball, extruded outline, turned profile.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/registry.h"

namespace idap::parametric {

namespace {

// The box seen along an axis: w runs along it from 0, u and v are square to it with their middle on it.
struct Along {
  Transform place;
  double u, v, w;
};

// "up", "across" (left to right), "deep" (front to back). In the plane that looks along the axis, u and v
// are that plane's own: x and y, y and z; for "deep" z and x, as three axes can only be turned, not swapped.
Along along(const Builder& b, const std::string& axis) {
  const Vec3 s = b.size();
  if (axis == "across") return {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {b.left(), 0, s.z / 2}}, s.y, s.z, s.x};
  if (axis == "deep") return {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, b.front(), s.z / 2}}, s.z, s.x, s.y};
  return {{}, s.x, s.y, s.z};
}

void solidBox(Builder& b, const Parameters& p) {
  b.slot("body");
  const double most = 0.5 * std::min({b.width(), b.depth(), b.height()});
  const double radius = std::clamp(p.number("rounding", 0), 0.0, most);
  const Vec3 min{b.left(), b.front(), 0}, max{b.right(), b.back(), b.height()};
  if (radius < 1e-4)
    b.box(min, max, 0);
  else
    b.roundedBox(min, max, std::min(radius, 0.999 * most), 12);
}

void solidCylinder(Builder& b, const Parameters& p) {
  b.slot("body");
  const int sides = std::clamp(p.count("sides", 64), 3, 128);
  const double top = std::clamp(p.number("taper", 1), 0.0, 1.0);
  const Along box = along(b, p.text("axis", "up"));
  b.within(box.place, [&] {
    const auto ring = [&](double share, double w) {
      return atHeight(ellipse({}, {share * box.u / 2, share * box.v / 2}, sides), w);
    };
    // A cone ends in a point: its last ring has no width, and what has no area is dropped.
    b.loft({ring(1, 0), ring(top, box.w)}, true, 0.75);
  });
}

void solidSphere(Builder& b, const Parameters& p) {
  b.slot("body");
  // Even quarters, so that the ball touches its box on all sides.
  const int sides = std::clamp(4 * (p.count("sides", 64) / 4), 8, 128);
  const Vec3 half = b.size() / 2;
  b.ellipsoid({0, 0, half.z}, half, sides);
}

// What was clicked crosses itself now and then: of the pieces that are left, the largest.
Region soundRegion(const std::vector<Vec2>& outline) {
  Region best;
  double largest = 0;
  for (const Region& region : repair(outline)) {
    const double size = area({region});
    if (size > largest) largest = size, best = region;
  }
  return best;
}

void solidExtrusion(Builder& b, const Parameters& p) {
  b.slot("body");
  const std::string axis = p.text("axis", "up");
  const Along box = along(b, axis);
  std::vector<Vec2> outline;
  for (const Vec2 q : p.outline) {
    const Vec2 turned = axis == "deep" ? Vec2{q.y, q.x} : q;
    outline.push_back({(turned.x - 0.5) * box.u, (turned.y - 0.5) * box.v});
  }
  Region region = soundRegion(outline);
  if (region.outer.size() < 3) region.outer = rectangle({-box.u / 2, -box.v / 2}, {box.u / 2, box.v / 2});
  b.within(box.place, [&] { b.extrude(region, 0, box.w, 0); });
}

void solidTurned(Builder& b, const Parameters& p) {
  b.slot("body");
  const int sides = std::clamp(4 * (p.count("sides", 64) / 4), 8, 128);
  const Along box = along(b, p.text("axis", "up"));
  std::vector<Vec2> profile = p.outline;
  if (p.flag("smooth") && profile.size() >= 3)
    profile = spline2(profile, std::clamp(static_cast<int>(400 / profile.size()), 2, 8));
  for (Vec2& q : profile) q = {std::clamp(q.x, 0.0, 1.0), std::clamp(q.y, 0.0, 1.0)};
  Box2 extent;
  extent.add(Vec2{0, profile.empty() ? 0 : profile.front().y});
  for (const Vec2 q : profile) extent.add(q);
  if (extent.max.x < 1e-6 || extent.max.y - extent.min.y < 1e-6) profile = {{1, 0}, {1, 1}};
  // From axis to axis it bounds a solid, which is to lie on the left of its way.
  if (profile.front().x > 1e-6) profile.insert(profile.begin(), {0, profile.front().y});
  if (profile.back().x > 1e-6) profile.push_back({0, profile.back().y});
  profile.front().x = profile.back().x = 0;
  if (signedArea(profile) < 0) std::reverse(profile.begin(), profile.end());
  const double radius = std::max(box.u, box.v) / 2;
  for (Vec2& q : profile) q = {q.x * radius, q.y * box.w};
  b.within(box.place, [&] {
    b.within(Transform::scaling({box.u / 2 / radius, box.v / 2 / radius, 1}),
             [&] { b.lathe({}, profile, sides); });
  });
}

}  // namespace

void addSolids(Generators& to) {
  to["solid-box"] = solidBox;
  to["solid-cylinder"] = solidCylinder;
  to["solid-sphere"] = solidSphere;
  to["solid-extrusion"] = solidExtrusion;
  to["solid-turned"] = solidTurned;
}

}  // namespace idap::parametric
