#include "catalog/parametric/paths.h"

#include <algorithm>
#include <cmath>

namespace idap::parametric {
namespace {

// Centripetal Catmull-Rom by the pyramid of Barry and Goldman: no loops or overshoot at short spans.
template <class V>
std::vector<V> catmullRom(const std::vector<V>& p, int samples, bool closed) {
  const int n = static_cast<int>(p.size());
  if (n < 3) return p;
  const auto at = [&](int i) -> V {
    if (closed) return p[static_cast<std::size_t>((i % n + n) % n)];
    if (i < 0) return p[0] * 2.0 - p[1];
    if (i >= n) return p[static_cast<std::size_t>(n - 1)] * 2.0 - p[static_cast<std::size_t>(n - 2)];
    return p[static_cast<std::size_t>(i)];
  };
  std::vector<V> out;
  const int spans = closed ? n : n - 1;
  for (int i = 0; i < spans; ++i) {
    const V p0 = at(i - 1), p1 = at(i), p2 = at(i + 1), p3 = at(i + 2);
    const double t0 = 0, t1 = t0 + std::sqrt(std::max(1e-9, length(p1 - p0))),
                 t2 = t1 + std::sqrt(std::max(1e-9, length(p2 - p1))),
                 t3 = t2 + std::sqrt(std::max(1e-9, length(p3 - p2)));
    for (int s = 0; s < samples; ++s) {
      const double t = t1 + (t2 - t1) * s / samples;
      const auto mix = [t](V a, V b, double ta, double tb) {
        return a * ((tb - t) / (tb - ta)) + b * ((t - ta) / (tb - ta));
      };
      const V a1 = mix(p0, p1, t0, t1), a2 = mix(p1, p2, t1, t2), a3 = mix(p2, p3, t2, t3);
      const V b1 = mix(a1, a2, t0, t2), b2 = mix(a2, a3, t1, t3);
      out.push_back(mix(b1, b2, t1, t2));
    }
  }
  if (!closed) out.push_back(p.back());
  return out;
}

// Replaces corners by arcs; works in the plane of each corner.
template <class V>
std::vector<V> roundCorners(const std::vector<V>& p, double radius, int segments, bool closed) {
  const std::size_t n = p.size();
  if (n < 3 || radius <= 0) return p;
  std::vector<V> out;
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && (i == 0 || i == n - 1)) {
      out.push_back(p[i]);
      continue;
    }
    const V a = p[(i + n - 1) % n] - p[i], b = p[(i + 1) % n] - p[i];
    const double la = length(a), lb = length(b);
    if (la < 1e-9 || lb < 1e-9) continue;
    const V da = a / la, db = b / lb;
    const double cosine = std::clamp(dot(da, db), -1.0, 1.0);
    const double half = std::acos(cosine) / 2;
    if (half < 0.02 || half > kPi / 2 - 0.02) {
      out.push_back(p[i]);
      continue;
    }
    const double room = 0.499 * std::min(la, lb);
    const double cut = std::min(radius / std::tan(half), room);
    const double r = cut * std::tan(half);
    const V bisector = (da + db) / length(da + db);
    const V centre = p[i] + bisector * (r / std::sin(half));
    const V from = p[i] + da * cut - centre, to = p[i] + db * cut - centre;
    const double sweep = kPi - 2 * half;
    for (int s = 0; s <= segments; ++s) {
      const double t = sweep * s / segments;
      out.push_back(centre + from * (std::sin(sweep - t) / std::sin(sweep)) +
                    to * (std::sin(t) / std::sin(sweep)));
    }
  }
  return out;
}

}  // namespace

Path spline(const Path& points, int samples, bool closed) { return catmullRom(points, samples, closed); }
std::vector<Vec2> spline2(const std::vector<Vec2>& points, int samples, bool closed) {
  return catmullRom(points, samples, closed);
}

Path roundedPath(const Path& points, double radius, int segments, bool closed) {
  return roundCorners(points, radius, segments, closed);
}
std::vector<Vec2> fillet(const std::vector<Vec2>& points, double radius, int segments, bool closed) {
  return roundCorners(points, radius, segments, closed);
}

Path translated(Path path, Vec3 by) {
  for (Vec3& p : path) p += by;
  return path;
}

Polygon rectangle(Vec2 min, Vec2 max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

Polygon roundedRectangle(Vec2 min, Vec2 max, double radius, int segments) {
  return fillet(rectangle(min, max), radius, segments);
}

Polygon ellipse(Vec2 centre, Vec2 radii, int points) {
  Polygon out;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * kPi * i / points;
    out.push_back({centre.x + radii.x * std::cos(a), centre.y + radii.y * std::sin(a)});
  }
  return out;
}

Polygon superellipse(Vec2 centre, Vec2 radii, double exponent, int points) {
  Polygon out;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * kPi * i / points, c = std::cos(a), s = std::sin(a);
    // Along the ray at that angle, so that points are spread evenly.
    const double r =
        std::pow(std::pow(std::abs(c), exponent) + std::pow(std::abs(s), exponent), -1 / exponent);
    out.push_back({centre.x + radii.x * r * c, centre.y + radii.y * r * s});
  }
  return out;
}

Polygon arc(Vec2 centre, double radius, double from, double to, int segments) {
  Polygon out;
  for (int i = 0; i <= segments; ++i) {
    const double a = from + (to - from) * i / segments;
    out.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
  }
  return out;
}

Path atHeight(const Polygon& polygon, double z) {
  Path out;
  for (const Vec2 p : polygon) out.push_back({p.x, p.y, z});
  return out;
}

Path atDepth(const std::vector<Vec2>& xz, double y) {
  Path out;
  for (const Vec2 p : xz) out.push_back({p.x, y, p.y});
  return out;
}

Transform facing(Vec3 origin, Vec3 direction) {
  const Vec3 z = normalized(direction);
  const Vec3 level = std::abs(z.z) > 0.999 ? Vec3{1, 0, 0} : normalized(cross(Vec3{0, 0, 1}, z));
  const Vec3 y = normalized(cross(z, level));
  return {cross(y, z), y, z, origin};
}

double pathLength(const Path& path) {
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += length(path[i] - path[i - 1]);
  return sum;
}

Vec3 along(const Path& path, double fraction) {
  double rest = fraction * pathLength(path);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double step = length(path[i] - path[i - 1]);
    if (rest <= step && step > 0) return path[i - 1] + (path[i] - path[i - 1]) * (rest / step);
    rest -= step;
  }
  return path.back();
}

}  // namespace idap::parametric
