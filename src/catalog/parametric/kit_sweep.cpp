// Bars, legs and mouldings: sections carried along a path.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/kit.h"
#include "catalog/parametric/kit_grid.h"

namespace idap::parametric {
namespace {

struct Frame {
  Vec3 tangent, x, y;
};

Vec3 squareTo(Vec3 v, Vec3 tangent) { return v - tangent * dot(v, tangent); }

// A direction square to the tangent, as near to the wish as can be.
Vec3 squareUp(Vec3 wish, Vec3 tangent) {
  Vec3 y = squareTo(wish, tangent);
  if (length(y) < 1e-3) y = squareTo(std::abs(tangent.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, tangent);
  return normalized(y);
}

Path withoutRepeats(const Path& path) {
  Path out;
  for (const Vec3 p : path)
    if (out.empty() || length(p - out.back()) > 1e-7) out.push_back(p);
  return out;
}

// Rings of a section along a path, mitred at its corners. turning: frames are carried along without twist
// (round sections); else the section's y stays towards up.
std::vector<Path> ringsAlong(const Path& path, const std::function<Polygon(double)>& section, Vec3 up,
                             bool closed, bool turning) {
  const std::size_t n = path.size();
  std::vector<double> way(n, 0.0);
  for (std::size_t i = 1; i < n; ++i) way[i] = way[i - 1] + length(path[i] - path[i - 1]);
  const double total = way.back() + (closed ? length(path.front() - path.back()) : 0);
  std::vector<Path> rings;
  Vec3 carried = up;
  for (std::size_t i = 0; i < n; ++i) {
    const bool first = i == 0 && !closed, last = i + 1 == n && !closed;
    const Vec3 in = normalized(path[i] - path[(i + n - 1) % n]),
               out = normalized(path[(i + 1) % n] - path[i]);
    const Vec3 tangent = first ? out : in;
    const Vec3 mitre = first || last || length(in + out) < 1e-3 ? tangent : normalized(in + out);
    const Vec3 y = squareUp(turning ? carried : up, tangent);
    const Vec3 x = cross(y, tangent);
    // What a bend turns is carried on: the frame after the mitre.
    if (turning)
      carried = first || last ? y : y - (in + out) * (dot(y, out) / std::max(0.1, 1 + dot(in, out)));
    Path ring;
    for (const Vec2 s : section(way[i] / total)) {
      const Vec3 o = x * s.x + y * s.y;
      const double slant = std::max(0.35, dot(tangent, mitre));
      ring.push_back(path[i] + o - tangent * (dot(o, mitre) / slant));
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

Polygon circleSection(double radius, int sides) { return ellipse({}, {radius, radius}, sides); }

}  // namespace

void Builder::loft(const std::vector<Path>& rings, bool capped, double crease) {
  if (rings.size() < 2 || rings.front().size() < 3) return;
  const int n = static_cast<int>(rings.front().size());
  std::vector<Vec3> points;
  for (const Path& ring : rings) {
    for (int j = 0; j <= n; ++j) points.push_back(ring[static_cast<std::size_t>(j % n)]);
  }
  Mesh part;
  appendGrid(part, points, n + 1, static_cast<int>(rings.size()), false);
  if (capped) {
    for (const bool end : {false, true}) {
      const Path& ring = end ? rings.back() : rings.front();
      Vec3 centre, normal;
      for (const Vec3 p : ring) centre += p / static_cast<double>(n);
      for (std::size_t j = 0; j < ring.size(); ++j)
        normal += cross(ring[j] - centre, ring[(j + 1) % ring.size()] - centre);
      if (length(normal) < 1e-12) continue;
      const Transform plane = facing(centre, normal);
      const auto first = static_cast<std::uint32_t>(part.positions.size());
      const auto vertex = [&](Vec3 p) {
        part.positions.push_back(toFloat(p));
        part.uvs.push_back(
            {static_cast<float>(dot(p - centre, plane.x)), static_cast<float>(dot(p - centre, plane.y))});
      };
      vertex(centre);
      for (const Vec3 p : ring) vertex(p);
      for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(n); ++j) {
        const std::uint32_t a = first + 1 + j, b = first + 1 + (j + 1) % static_cast<std::uint32_t>(n);
        if (end)
          part.triangles.push_back({first, a, b});
        else
          part.triangles.push_back({first, b, a});
      }
    }
  }
  add(std::move(part), crease);
}

void Builder::tube(const Path& path, double radius, int sides, Cap cap, bool closed) {
  if (!closed)
    return tube(
        path, [radius](double) { return radius; }, sides, cap);
  const Path p = withoutRepeats(path);
  if (p.size() < 3) return;
  auto rings = ringsAlong(
      p, [&](double) { return circleSection(radius, sides); }, {0.13, 0.21, 0.97}, true, true);
  // Carried once around, the frame comes back turned: the last ring takes the step that fits best.
  const Path& start = rings.front();
  const Path& last = rings.back();
  std::size_t best = 0;
  for (std::size_t k = 1; k < start.size(); ++k)
    if (length(start[k] - last[0]) < length(start[best] - last[0])) best = k;
  Path end(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) end[k] = start[(k + best) % start.size()];
  rings.push_back(std::move(end));
  loft(rings, false, 1.0);
}

void Builder::tube(const Path& path, const std::function<double(double)>& radius, int sides, Cap cap) {
  Path p = withoutRepeats(path);
  if (p.size() < 2) return;
  const double total = pathLength(p);
  std::function<double(double)> r = radius;
  if (cap == Cap::Round) {
    // The ends are rounded within the length of the path: extra rings near them, narrowing as an ellipse.
    const double e0 = std::min(0.6 * radius(0), 0.4 * total), e1 = std::min(0.6 * radius(1), 0.4 * total);
    Path q;
    for (const double s : {0.0, 0.12, 0.45}) q.push_back(along(p, s * e0 / total));
    double way = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (i > 0) way += length(p[i] - p[i - 1]);
      if (way >= 0.999 * e0 && way <= total - 0.999 * e1) q.push_back(p[i]);
    }
    if (way > 0 && p.size() == 2) {
      q.push_back(along(p, e0 / total));
      q.push_back(along(p, 1 - e1 / total));
    }
    for (const double s : {0.45, 0.12, 0.0}) q.push_back(along(p, 1 - s * e1 / total));
    p = withoutRepeats(q);
    r = [radius, total, e0, e1](double t) {
      const double a = std::clamp(t * total / e0, 0.0, 1.0), b = std::clamp((1 - t) * total / e1, 0.0, 1.0);
      const auto round = [](double s) {
        return 0.35 + 0.65 * std::sqrt(std::max(0.0, 1 - (1 - s) * (1 - s)));
      };
      return radius(t) * round(a) * round(b);
    };
  }
  loft(ringsAlong(
           p, [&](double t) { return circleSection(r(t), sides); }, {0.13, 0.21, 0.97}, false, true),
       cap != Cap::None, 1.0);
}

void Builder::sweep(const Path& path, const std::function<Polygon(double)>& section, Vec3 up, bool closed) {
  const Path p = withoutRepeats(path);
  if (p.size() < 2) return;
  auto rings = ringsAlong(p, section, up, closed, false);
  if (closed) rings.push_back(rings.front());
  loft(rings, !closed, 0.7);
}

void Builder::sweep(const Path& path, const Polygon& section, Vec3 up, bool closed) {
  sweep(
      path, [&](double) { return section; }, up, closed);
}

void Builder::leg(Vec3 top, Vec3 foot, double topRadius, double footRadius, LegShape shape) {
  // Rings from the foot up; t is 0 at the foot.
  std::vector<Vec2> profile;  // (t, share of the radius there)
  const double tall = std::max(1e-6, std::abs(top.z - foot.z));
  if (shape == LegShape::Turned) {
    // Vase and rings: foot, taper, ring, swelling, ring, square-shouldered top.
    const std::vector<Vec2> turned{{0, 0.55},     {0.03, 0.72}, {0.07, 0.60}, {0.10, 0.55},  {0.45, 0.92},
                                   {0.50, 0.98},  {0.53, 0.70}, {0.55, 0.66}, {0.565, 0.95}, {0.59, 0.95},
                                   {0.605, 0.62}, {0.63, 0.60}, {0.76, 1.0},  {0.86, 0.90},  {0.88, 0.70},
                                   {0.90, 0.98},  {0.94, 0.98}, {1.0, 0.86}};
    profile = spline2(turned, 3);
  } else {
    const double e = std::min(0.002 / tall, 0.1);
    profile = {{0, 1 - std::min(0.3, 0.002 / footRadius)}, {e, 1}, {1, 1}};
  }
  std::vector<Path> rings;
  const int sides = shape == LegShape::Square ? 4 : 16;
  for (const Vec2 s : profile) {
    const Vec3 centre = foot + (top - foot) * s.x;
    const double r = (footRadius + (topRadius - footRadius) * s.x) * s.y;
    const Polygon section = sides == 4 ? fillet(rectangle({-r, -r}, {r, r}), std::min(0.003, 0.3 * r), 2)
                                       : ellipse({}, {r, r}, sides);
    rings.push_back(translated(atHeight(section, 0), centre));
  }
  if (top.z < foot.z) std::reverse(rings.begin(), rings.end());
  loft(rings, true, shape == LegShape::Square ? 0.6 : 0.9);
}

}  // namespace idap::parametric
