#include "scene/fixture_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "render/emitter/local_lights.h"

namespace idap {

namespace {

// Evenly spread directions: a Fibonacci spiral on the sphere.
Vec3f direction(int i, int count) {
  const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(std::max(0.0, 1 - z * z));
  const double phi = i * kPi * (3 - std::sqrt(5.0));
  return {float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)};
}

// Distance along the ray; 0 for a miss. @cite moller1997
float hit(Vec3f corner, Vec3f e1, Vec3f e2, Vec3f origin, Vec3f d) {
  const Vec3f p = cross(d, e2);
  const float det = dot(e1, p);
  if (std::fabs(det) < 1e-14f) return 0;
  const float inverse = 1 / det;
  const Vec3f s = origin - corner;
  const float u = dot(s, p) * inverse;
  if (u < -1e-5f || u > 1.00001f) return 0;
  const Vec3f q = cross(s, e1);
  const float v = dot(d, q) * inverse;
  if (v < -1e-5f || u + v > 1.00001f) return 0;
  const float distance = dot(e2, q) * inverse;
  return distance > 1e-5f ? distance : 0;
}

}  // namespace

MeshParts meshParts(const Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) {
    const Vec3f p = mesh.positions[i];
    return std::tuple(p.x, p.y, p.z);
  };
  std::ranges::sort(order, {}, key);
  std::vector<std::uint32_t> place(mesh.positions.size());
  std::uint32_t places = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (k > 0 && key(order[k]) != key(order[k - 1])) ++places;
    place[order[k]] = places;
  }

  std::vector<std::uint32_t> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> corners;  // place, slot, triangle
  corners.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t v : mesh.triangles[t]) corners.emplace_back(place[v], mesh.slotOf(t), t);
  }
  std::ranges::sort(corners);
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const auto& [p, slot, t] = corners[k];
    const auto& [p0, slot0, t0] = corners[k - 1];
    if (p == p0 && slot == slot0) parent[root(t)] = root(t0);
  }

  MeshParts parts;
  constexpr std::uint32_t kNone = ~0u;
  std::vector<std::uint32_t> number(mesh.triangles.size(), kNone);
  parts.partOf.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& n = number[root(t)];
    if (n == kNone) n = parts.count++;
    parts.partOf.push_back(n);
  }
  return parts;
}

FixtureRays::FixtureRays(const Mesh& mesh, const Transform& meshToScene)
    : mesh_(mesh), parts_(meshParts(mesh)) {
  const Transformf t = toFloat(meshToScene);
  std::vector<Vec3f> points;
  points.reserve(mesh.positions.size());
  for (const Vec3f& p : mesh.positions) points.push_back(t.point(p));
  const std::vector<bool> closed = render::outsideOfClosedShells(mesh);
  triangles_.reserve(mesh.triangles.size());
  areas_.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& v = mesh.triangles[i];
    const Vec3f a = points[v[0]], b = points[v[1]], c = points[v[2]];
    const Vec3f middle = (a + b + c) / 3.0f;
    const float radius = std::max({length(a - middle), length(b - middle), length(c - middle)}) * 1.0001f;
    triangles_.push_back({a, b - a, c - a, middle, radius});
    areas_.push_back(double(length(cross(b - a, c - a))) / 2 * (closed[i] ? 1 : 2));
  }
}

FixtureRays::Escape FixtureRays::escapeFrom(Vec3f point, const std::vector<bool>& isClear) const {
  Escape escape;
  escape.outermost.assign(parts_.count, 0);
  escape.firstSlot.assign(isClear.size(), 0);

  // Triangles in the way, each with the cone of directions that it can be hit in.
  struct Cone {
    Vec3f axis;
    float cosine;
    std::uint32_t triangle;
  };
  std::vector<Cone> cones;
  cones.reserve(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const std::uint32_t slot = mesh_.slotOf(t);
    if (slot >= isClear.size() || isClear[slot]) continue;
    const Vec3f to = triangles_[t].middle - point;
    const float distance = length(to), radius = triangles_[t].radius;
    if (distance <= radius * 1.001f) {
      cones.push_back({{0, 0, 1}, -2, t});
    } else {
      const float sine = radius / distance;
      cones.push_back({to / distance, std::sqrt(std::max(0.0f, 1 - sine * sine)) - 1e-5f, t});
    }
  }
  if (cones.empty()) return escape;
  const int rays = triangles_.size() > 100'000 ? 64 : triangles_.size() > 20'000 ? 128 : 256;
  int free = 0;
  for (int i = 0; i < rays; ++i) {
    const Vec3f d = direction(i, rays);
    float nearest = 1e30f, farthest = 0;
    std::uint32_t first = 0, last = 0;
    for (const Cone& cone : cones) {
      if (dot(d, cone.axis) < cone.cosine) continue;
      const Triangle& t = triangles_[cone.triangle];
      const float at = hit(t.corner, t.edge1, t.edge2, point, d);
      if (at <= 0) continue;
      if (at < nearest) nearest = at, first = cone.triangle;
      if (at > farthest) farthest = at, last = cone.triangle;
    }
    if (farthest == 0) {
      ++free;
    } else {
      ++escape.firstSlot[mesh_.slotOf(first)];
      ++escape.outermost[parts_.partOf[last]];
    }
  }
  escape.free = double(free) / rays;
  return escape;
}

std::vector<bool> FixtureRays::shadeParts(const Escape& escape) const {
  std::vector<std::uint32_t> order(parts_.count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, std::greater{}, [&](std::uint32_t p) { return escape.outermost[p]; });
  const int blocked = std::accumulate(escape.outermost.begin(), escape.outermost.end(), 0);
  std::vector<bool> shade(parts_.count, false);
  int covered = 0;
  for (const std::uint32_t p : order) {
    // A shade may be of one piece or of many alike; sockets, cords and frames hide far less than either.
    const int n = escape.outermost[p];
    if (n == 0 || (covered * 5 >= blocked * 4 && n * 4 < escape.outermost[order[0]])) break;
    shade[p] = true;
    covered += n;
  }
  return shade;
}

float FixtureRays::distanceTo(Vec3f p) const {
  float nearest = 1e30f;
  for (const Triangle& t : triangles_) {
    if (length(p - t.middle) - t.radius >= nearest) continue;
    const Vec3f ap = p - t.corner, n = cross(t.edge1, t.edge2);
    const float nn = dot(n, n);
    if (nn > 0) {
      const float v = dot(cross(ap, t.edge2), n) / nn, w = dot(cross(t.edge1, ap), n) / nn;
      if (v >= 0 && w >= 0 && v + w <= 1) {
        nearest = std::min(nearest, std::fabs(dot(ap, n)) / std::sqrt(nn));
        continue;
      }
    }
    const auto edge = [&](Vec3f a, Vec3f d) {
      const float dd = dot(d, d);
      const float s = dd > 0 ? std::clamp(dot(p - a, d) / dd, 0.0f, 1.0f) : 0.0f;
      nearest = std::min(nearest, length(p - a - d * s));
    };
    edge(t.corner, t.edge1);
    edge(t.corner, t.edge2);
    edge(t.corner + t.edge1, t.edge2 - t.edge1);
  }
  return nearest;
}

double FixtureRays::illuminance(std::size_t triangle, Vec3f bulb) const {
  const Triangle& t = triangles_[triangle];
  const Vec3f n = cross(t.edge1, t.edge2), to = bulb - t.middle;
  const double area2 = double(length(n)), d2 = double(dot(to, to));
  if (!(area2 > 0) || !(d2 > 0)) return 0;
  return std::abs(double(dot(n, to))) / (area2 * d2 * std::sqrt(d2));
}

}  // namespace idap
