#include "catalog/parametric/kit_grid.h"

#include <algorithm>
#include <cmath>

namespace idap::parametric {

void appendGrid(Mesh& part, const std::vector<Vec3>& points, int columns, int rows, bool rowsAreGrain) {
  const auto first = static_cast<std::uint32_t>(part.positions.size());
  const auto at = [&](int c, int r) { return points[static_cast<std::size_t>(r * columns + c)]; };
  // Lengths along the middle lines stand for the whole grid.
  std::vector<double> across(static_cast<std::size_t>(columns)), up(static_cast<std::size_t>(rows));
  for (int c = 1; c < columns; ++c) {
    double longest = 0;
    for (const int r : {0, rows / 2, rows - 1}) longest = std::max(longest, length(at(c, r) - at(c - 1, r)));
    across[static_cast<std::size_t>(c)] = across[static_cast<std::size_t>(c - 1)] + longest;
  }
  for (int r = 1; r < rows; ++r) {
    double longest = 0;
    for (const int c : {0, columns / 2, columns - 1})
      longest = std::max(longest, length(at(c, r) - at(c, r - 1)));
    up[static_cast<std::size_t>(r)] = up[static_cast<std::size_t>(r - 1)] + longest;
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      part.positions.push_back(toFloat(at(c, r)));
      const auto a = static_cast<float>(across[static_cast<std::size_t>(c)]),
                 b = static_cast<float>(up[static_cast<std::size_t>(r)]);
      part.uvs.push_back(rowsAreGrain ? Vec2f{a, b} : Vec2f{b, a});
    }
  }
  for (int r = 0; r + 1 < rows; ++r) {
    for (int c = 0; c + 1 < columns; ++c) {
      const std::uint32_t a = first + static_cast<std::uint32_t>(r * columns + c), b = a + 1,
                          d = a + static_cast<std::uint32_t>(columns), e = d + 1;
      if (length(at(c, r) - at(c + 1, r + 1)) <= length(at(c + 1, r) - at(c, r + 1))) {
        part.triangles.push_back({a, b, e});
        part.triangles.push_back({a, e, d});
      } else {
        part.triangles.push_back({a, b, d});
        part.triangles.push_back({b, e, d});
      }
    }
  }
}

void dropEmptyTriangles(Mesh& part) {
  std::erase_if(part.triangles, [&](const std::array<std::uint32_t, 3>& t) {
    const Vec3f a = part.positions[t[0]], b = part.positions[t[1]], c = part.positions[t[2]];
    // Equal corners are told apart first: a fused multiply-add leaves a residue in their cross product.
    return a == b || b == c || c == a || length(cross(b - a, c - a)) < 1e-10f;
  });
}

Mesh roundedBoxGrid(Vec3 min, Vec3 max, double radius, int half, std::array<int, 3> cells, int grain) {
  const Vec3 size = max - min;
  const double r = std::min(radius, 0.5 * std::min({size.x, size.y, size.z}));
  // Stations along each axis: the slope of the normal towards that axis, and where the round's centre is.
  struct Axis {
    std::vector<double> slope, core;
  };
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i) {
    Axis& axis = axes[static_cast<std::size_t>(i)];
    const double lo = min[i] + r, hi = std::max(lo, max[i] - r);
    for (int k = 0; k <= half; ++k) {
      axis.slope.push_back(k == half ? 0.0 : std::tan(-kPi / 4 * (half - k) / half));
      axis.core.push_back(lo);
    }
    const int n = cells[static_cast<std::size_t>(i)];
    for (int k = 1; k < n; ++k) axis.slope.push_back(0), axis.core.push_back(lo + (hi - lo) * k / n);
    for (int k = 0; k <= half; ++k) {
      axis.slope.push_back(k == 0 ? 0.0 : std::tan(kPi / 4 * k / half));
      axis.core.push_back(hi);
    }
    axis.slope.front() = -1, axis.slope.back() = 1;
  }
  Mesh part;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const Axis &A = axes[static_cast<std::size_t>(a)], &B = axes[static_cast<std::size_t>(b)],
               &C = axes[static_cast<std::size_t>(c)];
    for (const bool far : {false, true}) {
      const auto first = static_cast<std::uint32_t>(part.positions.size());
      const std::size_t nb = B.slope.size(), nc = C.slope.size();
      const int u = a == grain ? b : grain, v = 3 - a - u;
      for (std::size_t j = 0; j < nc; ++j) {
        for (std::size_t i = 0; i < nb; ++i) {
          Vec3 d, core;
          d[a] = far ? 1 : -1, d[b] = B.slope[i], d[c] = C.slope[j];
          core[a] = far ? A.core.back() : A.core.front(), core[b] = B.core[i], core[c] = C.core[j];
          // Summed in a fixed order, so that faces agree to the bit along their common edges.
          const Vec3 n = d / std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
          const Vec3 p = core + n * r;
          part.positions.push_back(toFloat(p));
          part.normals.push_back(toFloat(n));
          part.uvs.push_back({static_cast<float>(p[u]), static_cast<float>(p[v])});
        }
      }
      for (std::size_t j = 0; j + 1 < nc; ++j) {
        for (std::size_t i = 0; i + 1 < nb; ++i) {
          const auto p = first + static_cast<std::uint32_t>(j * nb + i), q = p + 1,
                     s = p + static_cast<std::uint32_t>(nb), t = s + 1;
          if (far) {
            part.triangles.push_back({p, q, t});
            part.triangles.push_back({p, t, s});
          } else {
            part.triangles.push_back({p, t, q});
            part.triangles.push_back({p, s, t});
          }
        }
      }
    }
  }
  return part;
}

Polygon insetRing(const Polygon& ring, double by) {
  if (by <= 0) return ring;
  const std::size_t n = ring.size();
  Polygon out;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = ring[i] - ring[(i + n - 1) % n], after = ring[(i + 1) % n] - ring[i];
    const Vec2 a = length(before) > 1e-9 ? normalized(before) : Vec2{},
               b = length(after) > 1e-9 ? normalized(after) : a;
    const Vec2 na = perpendicular(a), nb = perpendicular(b);
    const double share = std::max(0.3, 1 + dot(na, nb));  // of a needle's point, no more than this
    out.push_back(ring[i] + (na + nb) * (by / share));
  }
  return out;
}

}  // namespace idap::parametric
