// Boards, blocks, turned parts and prisms.
#include <algorithm>
#include <array>
#include <cmath>

#include "catalog/parametric/kit.h"
#include "catalog/parametric/kit_grid.h"

namespace idap::parametric {
namespace {

int grainAxis(Grain grain, Vec3 size) {
  if (grain != Grain::Auto) return static_cast<int>(grain) - 1;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

// Texture coordinates of a face square to axis a: u along the grain where the face holds it.
Vec2f boardUv(Vec3 p, int a, int grain) {
  const int u = a == grain ? (a + 1) % 3 : grain;
  const int v = 3 - a - u;
  return {static_cast<float>(p[u]), static_cast<float>(p[v])};
}

void triangle(Mesh& part, std::uint32_t a, std::uint32_t b, std::uint32_t c, bool flip) {
  part.triangles.push_back(flip ? std::array{a, c, b} : std::array{a, b, c});
}

void ordered(Vec3& min, Vec3& max) {
  for (int i = 0; i < 3; ++i)
    if (min[i] > max[i]) std::swap(min[i], max[i]);
}

double signedHalf(int sign, double lo, double hi, double inset) { return sign < 0 ? lo + inset : hi - inset; }

}  // namespace

// Faces keep their flat normals to the border, and the bevel's normals run from one face's to the other's:
// 44 triangles that catch the light like a round.
void Builder::box(Vec3 min, Vec3 max, double bevel, Grain grain) {
  ordered(min, max);
  const Vec3 size = max - min;
  const int g = grainAxis(grain, size);
  const double r = std::min(bevel, 0.45 * std::min({size.x, size.y, size.z}));
  // The corner of the box towards signs s, on the face square to axis a.
  const auto corner = [&](std::array<int, 3> s, int a) {
    Vec3 p;
    for (int i = 0; i < 3; ++i)
      p[i] = signedHalf(s[static_cast<std::size_t>(i)], min[i], max[i], i == a ? 0 : r);
    return p;
  };
  Mesh part;
  const auto vertex = [&](std::array<int, 3> s, int a, int uvFace) {
    const Vec3 p = corner(s, a);
    Vec3f n{};
    n[a] = static_cast<float>(s[static_cast<std::size_t>(a)]);
    part.positions.push_back(toFloat(p));
    part.normals.push_back(n);
    part.uvs.push_back(boardUv(p, uvFace, g));
    return static_cast<std::uint32_t>(part.positions.size() - 1);
  };
  for (int a = 0; a < 3; ++a) {
    const auto ia = static_cast<std::size_t>(a), ib = static_cast<std::size_t>((a + 1) % 3),
               ic = static_cast<std::size_t>((a + 2) % 3);
    for (const int sa : {-1, 1}) {
      std::array<std::uint32_t, 4> q{};
      std::size_t k = 0;
      for (const auto& [sb, sc] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
        std::array<int, 3> s{};
        s[ia] = sa, s[ib] = sb, s[ic] = sc;
        q[k++] = vertex(s, a, a);
      }
      triangle(part, q[0], q[1], q[2], sa < 0);
      triangle(part, q[0], q[2], q[3], sa < 0);
    }
    if (r <= 0) continue;
    // The four edges along axis c, between faces a and b.
    for (const int sa : {-1, 1}) {
      for (const int sb : {-1, 1}) {
        std::array<int, 3> low{}, high{};
        low[ia] = high[ia] = sa, low[ib] = high[ib] = sb, low[ic] = -1, high[ic] = 1;
        const auto p = vertex(low, a, a), q = vertex(low, a == 2 ? 0 : a + 1, a), t = vertex(high, a, a),
                   u = vertex(high, a == 2 ? 0 : a + 1, a);
        triangle(part, p, q, u, sa * sb < 0);
        triangle(part, p, u, t, sa * sb < 0);
      }
    }
  }
  if (r > 0) {
    for (int bits = 0; bits < 8; ++bits) {
      const std::array<int, 3> s{bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1};
      const auto x = vertex(s, 0, g), y = vertex(s, 1, g), z = vertex(s, 2, g);
      triangle(part, x, y, z, s[0] * s[1] * s[2] < 0);
    }
  }
  add(std::move(part));
}

void Builder::roundedBox(Vec3 min, Vec3 max, double radius, int segments, Grain grain) {
  ordered(min, max);
  Mesh part =
      roundedBoxGrid(min, max, radius, std::max(1, segments / 2), {1, 1, 1}, grainAxis(grain, max - min));
  add(std::move(part));
}

void Builder::lathe(Vec3 base, const std::vector<Vec2>& profile, int sides) {
  std::vector<Vec2> p;
  for (Vec2 q : profile) {
    if (std::abs(q.x) < 1e-7) q.x = 0;  // curves reach the axis to rounding only
    if (p.empty() || length(q - p.back()) > 1e-7) p.push_back(q);
  }
  const std::size_t n = p.size();
  if (n < 2) return;
  // Each vertex takes the mean direction of its two edges unless they meet in a corner.
  const auto outward = [&](std::size_t edge) {
    const Vec2 d = normalized(p[edge + 1] - p[edge]);
    return Vec2{d.y, -d.x};
  };
  Mesh part;
  double run = 0;
  const double crease = std::cos(0.7);
  for (std::size_t e = 0; e + 1 < n; ++e) {
    const Vec2 own = outward(e);
    const auto joined = [&](Vec2 other) { return dot(own, other) > crease ? normalized(own + other) : own; };
    const bool ring = length(p.front() - p.back()) < 1e-7;
    const Vec2 n0 = e > 0 ? joined(outward(e - 1)) : ring ? joined(outward(n - 2)) : own;
    const Vec2 n1 = e + 2 < n ? joined(outward(e + 1)) : ring ? joined(outward(0)) : own;
    const double step = length(p[e + 1] - p[e]);
    const double girth = std::max(p[e].x, p[e + 1].x);
    const auto first = static_cast<std::uint32_t>(part.positions.size());
    for (int i = 0; i <= sides; ++i) {
      const double a = 2 * kPi * (i % sides) / sides, c = std::cos(a), s = std::sin(a);
      for (const int end : {0, 1}) {
        const Vec2 q = p[e + static_cast<std::size_t>(end)], m = end ? n1 : n0;
        part.positions.push_back(toFloat(base + Vec3{q.x * c, q.x * s, q.y}));
        part.normals.push_back(toFloat(Vec3{m.x * c, m.x * s, m.y}));
        part.uvs.push_back(
            {static_cast<float>(run + end * step), static_cast<float>(girth * 2 * kPi * i / sides)});
      }
    }
    for (int i = 0; i < sides; ++i) {
      const std::uint32_t k = first + static_cast<std::uint32_t>(2 * i);
      part.triangles.push_back({k, k + 2, k + 3});
      part.triangles.push_back({k, k + 3, k + 1});
    }
    run += step;
  }
  add(std::move(part));
}

void Builder::cone(Vec3 base, double bottomRadius, double topRadius, double height, double bevel, int sides) {
  const double room = 0.45 * std::min(height, std::max(bottomRadius, topRadius));
  std::vector<Vec2> p{{0, 0}, {bottomRadius, 0}, {topRadius, height}, {0, height}};
  if (bottomRadius <= 1e-6) p.erase(p.begin() + 1);
  if (topRadius <= 1e-6) p.erase(p.end() - 2);
  lathe(base, fillet(p, std::min(bevel, room), bevel > 0.004 ? 4 : 2, false), sides);
}

void Builder::cylinder(Vec3 base, double radius, double height, double bevel, int sides) {
  cone(base, radius, radius, height, bevel, sides);
}

void Builder::sphere(Vec3 centre, double radius, int sides) {
  ellipsoid(centre, {radius, radius, radius}, sides);
}

void Builder::ellipsoid(Vec3 centre, Vec3 radii, int sides) {
  within(Transform::translation(centre) * Transform::scaling(radii), [&] {
    std::vector<Vec2> p;
    const int rows = std::max(4, sides / 2);
    for (int i = 0; i <= rows; ++i) {
      const double a = -kPi / 2 + kPi * i / rows;
      p.push_back({i == 0 || i == rows ? 0.0 : std::cos(a), std::sin(a)});
    }
    lathe({}, p, sides);
  });
}

void Builder::torus(Vec3 centre, double ringRadius, double radius, int ringSides, int sides) {
  std::vector<Vec2> p;
  for (int i = 0; i <= sides; ++i) {
    const double a = 2 * kPi * (i % sides) / sides;
    p.push_back({ringRadius + radius * std::cos(a), radius * std::sin(a)});
  }
  lathe(centre, p, ringSides);
}

void Builder::extrude(const Polygon& polygon, double z, double height, double bevel, Grain grain) {
  Region region{polygon, {}};
  if (signedArea(polygon) < 0) std::reverse(region.outer.begin(), region.outer.end());
  extrude(region, z, height, bevel, grain);
}

void Builder::extrude(const Region& region, double z, double height, double bevel, Grain grain) {
  const double r = std::min(bevel, 0.45 * height);
  const Box2 box = bounds(region.outer);
  const bool alongX =
      grain == Grain::X || (grain != Grain::Y && box.max.x - box.min.x >= box.max.y - box.min.y);
  Mesh part;
  const auto side = [&](const Polygon& ring) {
    const Polygon inner = insetRing(ring, r);
    const std::size_t n = ring.size();
    std::vector<Vec3> points;
    std::vector<double> heights =
        r > 0 ? std::vector{z, z + r, z + height - r, z + height} : std::vector{z, z + height};
    for (std::size_t row = 0; row < heights.size(); ++row) {
      const Polygon& p = r > 0 && (row == 0 || row + 1 == heights.size()) ? inner : ring;
      for (std::size_t j = 0; j <= n; ++j) points.push_back({p[j % n].x, p[j % n].y, heights[row]});
    }
    appendGrid(part, points, static_cast<int>(n) + 1, static_cast<int>(heights.size()), false);
    return inner;
  };
  Region cap;
  cap.outer = side(region.outer);
  for (const Polygon& hole : region.holes) cap.holes.push_back(side(hole));
  const Triangulation flat = triangulate({cap});
  for (const bool top : {false, true}) {
    const auto first = static_cast<std::uint32_t>(part.positions.size());
    for (const Vec2 p : flat.points) {
      part.positions.push_back(toFloat(Vec3{p.x, p.y, top ? z + height : z}));
      part.uvs.push_back(alongX ? toFloat(p) : Vec2f{static_cast<float>(p.y), static_cast<float>(p.x)});
    }
    for (const auto& t : flat.triangles) triangle(part, first + t[0], first + t[1], first + t[2], !top);
  }
  add(std::move(part), 0.9);
}

void Builder::extrudeAlongY(const Polygon& xz, double y0, double y1, double bevel) {
  within({{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}},
         [&] { extrude(xz, -std::max(y0, y1), std::abs(y1 - y0), bevel); });
}

void Builder::extrudeAlongX(const Polygon& yz, double x0, double x1, double bevel) {
  within({{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}},
         [&] { extrude(yz, std::min(x0, x1), std::abs(x1 - x0), bevel); });
}

}  // namespace idap::parametric
