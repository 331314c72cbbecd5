#include "scene/sloped_ceiling.h"

#include <algorithm>
#include <map>

namespace idap {

namespace {

constexpr double kNearEdge = 0.3;  // m
constexpr double kReach = 0.02;    // m that the ceiling reaches into the walls

Polygon withBreaks(const Polygon& outline, const std::vector<Vec2>& breaks) {
  Polygon result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], d = outline[(i + 1) % outline.size()] - a;
    const double l = length(d);
    result.push_back(a);
    if (l < 1e-6) continue;
    std::vector<double> stops;
    for (const Vec2& p : breaks) {
      const double along = dot(p - a, d) / l;
      if (along > 0.2 && along < l - 0.2 && std::abs(cross(d, p - a)) / l < kNearEdge) stops.push_back(along);
    }
    std::sort(stops.begin(), stops.end());
    double last = -1;
    for (const double s : stops) {
      if (s - last > 0.01) result.push_back(a + d * (s / l));
      last = s;
    }
  }
  return result;
}

// Flips edges that run through a fold open to above until none is left. Each flip raises the surface, so this
// ends (Lawson); the bound is for rounding.
void raise(Mesh3& mesh) {
  const auto plan = [&](std::uint32_t i) { return Vec2{mesh.points[i].x, mesh.points[i].y}; };
  const auto left = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return cross(plan(b) - plan(a), plan(c) - plan(a));
  };
  std::size_t budget = 64 * mesh.triangles.size() + 64;
  for (bool changed = true; changed && budget > 0;) {
    changed = false;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> owner;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        owner[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = t;
      }
    }
    for (const auto& [edge, t] : owner) {
      const auto [a, b] = edge;
      const auto twin = owner.find({b, a});
      if (a > b || twin == owner.end()) continue;
      const auto apex = [&, a = a, b = b](std::size_t triangle) {
        for (const std::uint32_t v : mesh.triangles[triangle]) {
          if (v != a && v != b) return v;
        }
        return a;
      };
      const std::uint32_t c = apex(t), d = apex(twin->second);
      if (left(d, c, a) * left(d, c, b) >= -1e-9) continue;  // the quadrilateral is not convex
      // d over or under the plane of a, b, c
      const Vec3 n = cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
      if (dot(n, mesh.points[d] - mesh.points[a]) <= 1e-6 * length(n)) continue;
      mesh.triangles[t] = {a, d, c};
      mesh.triangles[twin->second] = {d, b, c};
      changed = true;
      --budget;
      break;  // the owners have changed
    }
  }
}

}  // namespace

Mesh3 slopedCeiling(const Polygon& outline, const std::vector<Vec2>& breaks,
                    const std::function<double(Vec2)>& heightAt) {
  Mesh3 mesh;
  const Polygon corners = withBreaks(outline, breaks);
  const Triangulation flat = triangulate({{corners, {}}});
  // Heights are asked for at the corners, then these move outwards into the walls.
  std::map<std::pair<double, double>, Vec2> moved;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 before = corners[(i + corners.size() - 1) % corners.size()], at = corners[i],
               after = corners[(i + 1) % corners.size()];
    Vec2 n0 = at - before, n1 = after - at;
    n0 = length(n0) > 0 ? -perpendicular(normalized(n0)) : Vec2{};
    n1 = length(n1) > 0 ? -perpendicular(normalized(n1)) : Vec2{};
    const Vec2 sum = n0 + n1;
    const double s = dot(sum, sum);
    moved[{at.x, at.y}] = s > 0.1 ? at + sum * (2 * kReach / s) : at;
  }
  for (const Vec2& p : flat.points) {
    const auto found = moved.find({p.x, p.y});
    const Vec2 q = found == moved.end() ? p : found->second;
    mesh.points.push_back({q.x, q.y, heightAt(p)});
  }
  mesh.triangles = flat.triangles;
  raise(mesh);
  return mesh;
}

}  // namespace idap
