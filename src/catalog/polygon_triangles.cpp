#include "catalog/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace idap {

namespace {

// Clipping ears costs the square of the corners; beyond this a fan must do.
constexpr std::size_t kMaxEarCorners = 4096;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Drops the axis the normal is longest in; the outline comes out counter-clockwise.
std::vector<Vec2f> flattened(std::span<const Vec3f> outline, Vec3f normal) {
  const float x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  std::vector<Vec2f> flat;
  flat.reserve(outline.size());
  for (const Vec3f& p : outline) {
    if (x >= y && x >= z) {
      flat.push_back(normal.x > 0 ? Vec2f{p.y, p.z} : Vec2f{p.z, p.y});
    } else if (y >= z) {
      flat.push_back(normal.y > 0 ? Vec2f{p.z, p.x} : Vec2f{p.x, p.z});
    } else {
      flat.push_back(normal.z > 0 ? Vec2f{p.x, p.y} : Vec2f{p.y, p.x});
    }
  }
  return flat;
}

float turn(Vec2f a, Vec2f b, Vec2f c) { return cross(b - a, c - a); }

bool isConvex(const std::vector<Vec2f>& p) {
  const std::size_t n = p.size();
  float angleSum = 0;  // a star that winds twice turns left everywhere too
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2f in = p[(i + 1) % n] - p[i], out = p[(i + 2) % n] - p[(i + 1) % n];
    const float side = cross(in, out);
    if (side < 0) return false;
    angleSum += std::atan2(side, dot(in, out));
  }
  return angleSum < 3 * float(kPi);
}

bool holds(Vec2f a, Vec2f b, Vec2f c, Vec2f p) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

void clipEars(const std::vector<Vec2f>& p, Triangles& triangles) {
  std::vector<std::uint32_t> ring(p.size());
  std::iota(ring.begin(), ring.end(), 0u);
  std::size_t i = 0, refused = 0;
  while (ring.size() > 3) {
    const std::size_t n = ring.size();
    i %= n;
    const std::uint32_t a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    bool ear = turn(p[a], p[b], p[c]) > 0;
    for (std::size_t k = 0; ear && k < n; ++k) {
      const std::uint32_t other = ring[k];
      if (other == a || other == b || other == c) continue;
      // Corners at the same place as the ear's belong to a slit and do not spoil it.
      if (p[other] == p[a] || p[other] == p[b] || p[other] == p[c]) continue;
      ear = !holds(p[a], p[b], p[c], p[other]);
    }
    if (ear || refused > n) {  // after a whole round without an ear anything goes: the polygon cuts itself
      triangles.push_back({a, b, c});
      ring.erase(ring.begin() + std::ptrdiff_t(i));
      refused = 0;
    } else {
      ++i;
      ++refused;
    }
  }
  triangles.push_back({ring[0], ring[1], ring[2]});
}

}  // namespace

void triangulatePolygon(std::span<const Vec3f> outline, Vec3f normal, Triangles& triangles) {
  const auto n = std::uint32_t(outline.size());
  if (n < 3) return;
  if (n == 3) {
    triangles.push_back({0, 1, 2});
    return;
  }
  if (n == 4) {  // the bend of a concave quad lies on the diagonal that keeps both halves facing the same way
    const auto faces = [&](int a, int b, int c) {
      const auto at = [&](int i) { return outline[std::size_t(i)]; };
      return dot(cross(at(b) - at(a), at(c) - at(a)), normal) >= 0;
    };
    if (faces(0, 1, 2) && faces(0, 2, 3)) {
      triangles.push_back({0, 1, 2});
      triangles.push_back({0, 2, 3});
    } else {
      triangles.push_back({1, 2, 3});
      triangles.push_back({1, 3, 0});
    }
    return;
  }
  const std::vector<Vec2f> flat = flattened(outline, normal);
  if (n > kMaxEarCorners || isConvex(flat)) {
    for (std::uint32_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i, i + 1});
    return;
  }
  clipEars(flat, triangles);
}

}  // namespace idap
