// Cushions, cloth, shells, leaves and pots.
#include <algorithm>
#include <cmath>

#include "catalog/parametric/kit.h"
#include "catalog/parametric/kit_grid.h"

namespace idap::parametric {
namespace {

constexpr double kSmooth = 3.2;  // crease angle that no edge reaches

// Irregular soft folds, about -1..1, a wave being about one unit long: a few sines that never line up.
double folds(Vec3 p) {
  const double k = 2 * kPi;
  return (std::sin(k * (0.83 * p.x + 0.41 * p.y + 0.3 * p.z) + 1.3 * std::sin(k * 0.37 * p.y)) +
          std::sin(k * (-0.51 * p.x + 0.74 * p.y - 0.4 * p.z) + 1.1 * std::sin(k * 0.29 * p.x + 0.7)) +
          0.6 * std::sin(k * (1.37 * p.x - 1.19 * p.y + 0.9 * p.z) + 2.1)) /
         2.6;
}

void fitTo(Mesh& part, Vec3 min, Vec3 max) {
  const Box3f box = part.bounds();
  const Vec3f lo = box.min, extent = box.size(), want = toFloat(max - min), to = toFloat(min);
  for (Vec3f& p : part.positions)
    for (int i = 0; i < 3; ++i) p[i] = to[i] + (p[i] - lo[i]) * (extent[i] > 0 ? want[i] / extent[i] : 1.0f);
}

double even(double v, double power) { return std::pow(std::abs(v), power); }

// How far a diamond-tufted face sinks at (u, v), counted in buttons: 1 at a button, less along the pleats.
double tuft(double u, double v) {
  // Buttons sit at whole numbers (row even) and at halves between (row odd); pleats join neighbours.
  double sink = 0;
  const double row = std::round(v);
  for (const double r : {row - 1, row, row + 1}) {
    const double offset = std::fmod(std::abs(r), 2.0) > 0.5 ? 0.5 : 0.0;
    const double c = std::round(u - offset) + offset;
    const double d2 = (u - c) * (u - c) * 1.2 + (v - r) * (v - r);
    sink = std::max(sink, std::exp(-d2 / 0.018));
    sink = std::max(sink, 0.75 * std::exp(-d2 / 0.07));
  }
  // Diagonal pleats: lines u +- v/2 = whole number.
  for (const double s : {u + v / 2, u - v / 2}) {
    const double d = s - std::round(s);
    sink = std::max(sink, 0.5 * std::exp(-d * d / 0.006));
  }
  return sink;
}

}  // namespace

void Builder::cushion(Vec3 min, Vec3 max, const Soft& soft) {
  const Vec3 size = max - min, centre = (min + max) * 0.5;
  const int thin = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  const int u = (thin + 1) % 3, v = (thin + 2) % 3;
  const bool tufted = soft.tuftColumns > 0 && soft.tuftRows > 0;
  const int tuftAxis = soft.tuftFace.x != 0 ? 0 : soft.tuftFace.y != 0 ? 1 : 2;
  const int tuftU = tuftAxis == 0 ? 1 : 0, tuftV = tuftAxis == 2 ? 1 : 2;
  std::array<int, 3> cells{};
  const double longest = std::max({size.x, size.y, size.z});
  for (int i = 0; i < 3; ++i) {
    int n = std::max(2, static_cast<int>(std::lround(soft.segments * size[i] / longest)));
    if (tufted && i == tuftU) n = std::max(n, 7 * soft.tuftColumns);
    if (tufted && i == tuftV) n = std::max(n, 6 * soft.tuftRows);
    cells[static_cast<std::size_t>(i)] = n;
  }
  Mesh part = roundedBoxGrid(min, max, soft.radius, 2, cells, size.x >= size.y ? 0 : 1);
  const Vec3 half = size * 0.5;
  const double crown = std::min(soft.crown, 0.9 * half[thin]);
  for (Vec3f& position : part.positions) {
    Vec3 p = toDouble(position) - centre;
    Vec3 q = p / half;
    const double rim = (1 - even(q[u], 2.5)) * (1 - even(q[v], 2.5));
    if (soft.pinched) {
      // Thickness falls to a seam at the border; the sides are drawn in between the corners.
      const double swell = std::pow(std::max(0.0, (1 - even(q[u], 3)) * (1 - even(q[v], 3))), 0.42);
      p[thin] = half[thin] * (q[thin] > 0 ? 1 : -1) * std::min(1.0, std::abs(q[thin]) * 1.15) *
                (0.06 + 0.94 * swell);
      p[u] *= 1 - 0.07 * even(q[u], 2) * (1 - even(q[v], 2));
      p[v] *= 1 - 0.07 * even(q[v], 2) * (1 - even(q[u], 2));
    } else {
      // The hidden face (under a seat, behind a back) is nearly flat.
      const bool hidden = thin == 2 ? q.z < 0 : thin == 1 && q.y > 0;
      p[thin] *= 1 - (hidden ? 0.25 : 1.0) * crown / half[thin] * (1 - rim);
      const double belly = 1 - q[thin] * q[thin];
      for (const int s : {u, v})
        p[s] *=
            1 - std::min(soft.bulge / half[s], 0.4) * (1 - belly * (1 - 0.5 * even(q[s == u ? v : u], 4)));
    }
    if (soft.wrinkle > 0) {
      const double w = soft.wrinkle * folds((p + centre) / soft.wrinkleLength) * (0.35 + 0.65 * rim);
      p[thin] += (q[thin] > 0 ? 1 : -1) * w * std::min(1.0, 1.5 * std::abs(q[thin]));
    }
    if (tufted) {
      const double facing = q[tuftAxis] * soft.tuftFace[tuftAxis];
      const double side = std::clamp((facing - 0.2) / 0.6, 0.0, 1.0);
      const double border = std::clamp((1 - std::abs(q[tuftU])) * 6, 0.0, 1.0) *
                            std::clamp((1 - std::abs(q[tuftV])) * 4, 0.0, 1.0);
      const double tu = (q[tuftU] + 1) / 2 * soft.tuftColumns - 0.5,
                   tv = (q[tuftV] + 1) / 2 * (soft.tuftRows + 1) - 1;
      p[tuftAxis] -= soft.tuftFace[tuftAxis] * soft.tuftDepth * side * border * tuft(tu, tv);
    }
    position = toFloat(p + centre);
  }
  fitTo(part, min, max);
  part.normals.clear();
  add(std::move(part), kSmooth);
}

void Builder::piping(Vec3 min, Vec3 max, double cornerRadius, int axis, double fraction, double radius) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Polygon ring = roundedRectangle({min[u], min[v]}, {max[u], max[v]}, cornerRadius, 6);
  Path path;
  for (const Vec2 p : ring) {
    Vec3 q;
    q[u] = p.x, q[v] = p.y, q[axis] = min[axis] + (max[axis] - min[axis]) * fraction;
    path.push_back(q);
  }
  tube(path, radius, 8, Cap::None, true);
}

void Builder::surface(const Surface& f, int cellsU, int cellsV, double thickness, bool closedU,
                      bool closedV) {
  const int nu = cellsU + 1, nv = cellsV + 1;
  std::vector<Vec3> points;
  for (int j = 0; j < nv; ++j) {
    for (int i = 0; i < nu; ++i) {
      const double u = closedU ? static_cast<double>(i % cellsU) / cellsU : static_cast<double>(i) / cellsU;
      const double v = closedV ? static_cast<double>(j % cellsV) / cellsV : static_cast<double>(j) / cellsV;
      points.push_back(f(u, v));
    }
  }
  Mesh front;
  appendGrid(front, points, nu, nv, true);
  dropEmptyTriangles(front);
  if (thickness <= 0) return add(std::move(front), kSmooth);

  // Normals by grid point, seams joined.
  std::vector<Vec3> normal(points.size());
  for (const auto& t : front.triangles) {
    const Vec3 n = cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for (const auto k : t) normal[k] += n;
  }
  const auto at = [&](int i, int j) { return static_cast<std::size_t>(j * nu + i); };
  if (closedU)
    for (int j = 0; j < nv; ++j)
      normal[at(0, j)] = normal[at(nu - 1, j)] = normal[at(0, j)] + normal[at(nu - 1, j)];
  if (closedV)
    for (int i = 0; i < nu; ++i)
      normal[at(i, 0)] = normal[at(i, nv - 1)] = normal[at(i, 0)] + normal[at(i, nv - 1)];
  std::vector<Vec3> behind(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double l = length(normal[k]);
    normal[k] = l > 0 ? normal[k] / l : Vec3{0, 0, 1};
    behind[k] = points[k] - normal[k] * thickness;
  }
  Mesh part;
  appendGrid(part, points, nu, nv, true);
  Mesh rear;
  appendGrid(rear, behind, nu, nv, true);
  for (auto& t : rear.triangles) std::swap(t[1], t[2]);
  append(part, rear);
  // Rims: from the front border over a rounded edge to the back border. At a corner both rims take the same
  // way out.
  const auto outward = [&](int i, int j) {
    Vec3 sum;
    const auto away = [&](int in, int jn) {
      const Vec3 d = points[at(i, j)] - points[at(in, jn)],
                 out = d - normal[at(i, j)] * dot(d, normal[at(i, j)]);
      if (const double l = length(out); l > 1e-9) sum += out / l;
    };
    if (!closedU && i == 0) away(1, j);
    if (!closedU && i == nu - 1) away(nu - 2, j);
    if (!closedV && j == 0) away(i, 1);
    if (!closedV && j == nv - 1) away(i, nv - 2);
    const double l = length(sum);
    return l > 1e-9 ? sum / l : Vec3{};
  };
  const auto rim = [&](bool alongU, bool last) {
    const int n = alongU ? nu : nv;
    std::vector<Vec3> strip;
    for (int row = 0; row < 4; ++row) {
      for (int k = 0; k < n; ++k) {
        const int i = alongU ? k : last ? nu - 1 : 0, j = alongU ? (last ? nv - 1 : 0) : k;
        const Vec3 p = points[at(i, j)], q = behind[at(i, j)], swell = outward(i, j) * (0.35 * thickness);
        strip.push_back(row == 0   ? p
                        : row == 1 ? p + (q - p) * 0.3 + swell
                        : row == 2 ? p + (q - p) * 0.7 + swell
                                   : q);
      }
    }
    Mesh edge;
    appendGrid(edge, strip, n, 4, true);
    // Where a strip's way (along the rim) x (to the back) points into the shell, it is turned.
    if (alongU != last)
      for (auto& t : edge.triangles) std::swap(t[1], t[2]);
    append(part, edge);
  };
  if (!closedV) rim(true, false), rim(true, true);
  if (!closedU) rim(false, false), rim(false, true);
  part.normals.clear();
  add(std::move(part), 1.2);
}

void Builder::drape(Vec3 min, Vec3 max, const Drape& d) {
  const double w = max.x - min.x, l = max.y - min.y;
  const double cx = (min.x + max.x) / 2, cy = (min.y + max.y) / 2;
  const double r = std::max(0.005, d.radius);
  const double bend = r * kPi / 2;
  // Cloth coordinates: metres from the middle; beyond the edge the cloth bends over it and hangs.
  const auto reach = [&](double drop) { return drop > 0 ? bend - r + drop : 0.0; };
  const double a0 = -w / 2 - reach(d.left), a1 = w / 2 + reach(d.right);
  const double b0 = -l / 2 - reach(d.front), b1 = l / 2 + reach(d.back);
  const auto place = [&](double u, double v) {
    const double a = a0 + (a1 - a0) * u, b = b0 + (b1 - b0) * v;
    // Where the bend begins: a bend's radius before the edge on the sides it hangs over.
    const double ix0 = -w / 2 + (d.left > 0 ? r : 0), ix1 = w / 2 - (d.right > 0 ? r : 0);
    const double iy0 = -l / 2 + (d.front > 0 ? r : 0), iy1 = l / 2 - (d.back > 0 ? r : 0);
    const double fx = std::clamp(a, ix0, ix1), fy = std::clamp(b, iy0, iy1);
    Vec2 over{a - fx, b - fy};
    const double flat = length(over), far = std::max(std::abs(over.x), std::abs(over.y));
    Vec3 p{fx, fy, max.z};
    double hang = 0;
    if (flat > 1e-9) {
      const Vec2 out = over / flat;
      const double s = far;
      const double turn = std::min(s / r, kPi / 2);
      hang = std::max(0.0, s - bend);
      double push = r * std::sin(turn);
      if (hang > 0) {
        // Folds swing outwards more towards the hem; around corners they follow the way around.
        const double around = a * std::abs(out.y) + b * std::abs(out.x) + 0.35 * std::atan2(out.y, out.x);
        const double deep = std::min(1.0, hang / 0.25);
        push += d.fold * deep *
                (0.75 + 0.7 * std::sin(2 * kPi * around / d.foldLength + 1.5 * std::sin(2.3 * around)) +
                 0.35 * std::sin(2 * kPi * around / (0.61 * d.foldLength) + 1.0));
      }
      p.x += out.x * push, p.y += out.y * push;
      p.z -= r * (1 - std::cos(turn)) + hang;
    }
    const double mx = 2 * fx / w, my = 2 * fy / l;
    p.z += d.crown * std::max(0.0, (1 - mx * mx) * (1 - my * my));
    if (hang <= 0) p.z += d.wrinkle * (folds({a / 0.45, b / 0.38, 0.2}) - 0.4);
    return Vec3{p.x + cx, p.y + cy, p.z + d.thickness};
  };
  const double wide = a1 - a0, deep = b1 - b0;
  const int nu = std::max(8, static_cast<int>(d.segments * wide / std::max(wide, deep))),
            nv = std::max(8, static_cast<int>(d.segments * deep / std::max(wide, deep)));
  surface(place, nu, nv, d.thickness);
}

void Builder::leaf(Vec3 base, Vec3 direction, Vec3 up, const Leaf& l) {
  const Vec3 forward = normalized(direction);
  Vec3 above = up - forward * dot(up, forward);
  above = length(above) < 1e-4 ? facing({}, forward).y : normalized(above);
  const Vec3 side = cross(forward, above);
  const double a = 0.75, b = a * (1 - l.widest) / l.widest * l.tip;
  const double peak = std::pow(a / (a + b), a) * std::pow(b / (a + b), b);
  const int along = std::max(l.segments, l.lobes * 6), across = l.fold == 0 && l.wave == 0 ? 2 : 4;
  const auto place = [&](double u, double v) {
    // The midrib is an arc that bends down by droop.
    const double bend = std::max(1e-4, std::abs(l.droop)), sign = l.droop < 0 ? -1 : 1;
    const double t = u * bend, run = l.length / bend * std::sin(t),
                 drop = sign * l.length / bend * (1 - std::cos(t));
    const Vec3 rib = base + forward * run - above * drop;
    const Vec3 normal = above * std::cos(t) + forward * (sign * std::sin(t));
    double half = 0.5 * l.width * std::pow(u, a) * std::pow(std::max(0.0, 1 - u), b) / peak;
    double s = 1 - 2 * v;  // 1 at the left border, -1 at the right
    if (l.lobes > 0 && u > 0.12 && u < 0.93) {
      const double phase = (u - 0.12) / 0.81 * l.lobes, d = phase - std::round(phase - 0.5) - 0.5;
      half *= 1 - l.lobeDepth * std::exp(-d * d / 0.012);
    }
    const double w = s * half;
    const double ripple = l.wave * s * s * std::sin(2 * kPi * (3 * u + 0.25 * s));
    return rib - side * (w * std::cos(l.fold)) + normal * (std::abs(w) * std::sin(l.fold) + ripple);
  };
  surface(place, along, across);
}

void Builder::pot(Vec3 base, double bottomRadius, double topRadius, double height, double rim) {
  const std::uint32_t before = slot_;
  slot("pot");
  const double wall = std::max(0.004, 0.05 * topRadius);
  const auto radiusAt = [&](double t) { return bottomRadius + (topRadius - bottomRadius) * t; };
  std::vector<Vec2> p{{0, 0}, {bottomRadius, 0}};
  if (rim > 0) {
    p.push_back({radiusAt(0.8) - rim, 0.8 * height});
    p.push_back({radiusAt(0.8), 0.8 * height});
  }
  p.push_back({topRadius, height});
  p.push_back({topRadius - wall, height});
  p.push_back({radiusAt(0.86) - wall - rim, 0.86 * height});
  p.push_back({0, 0.86 * height});
  lathe(base, fillet(p, std::min(0.004, 0.4 * wall), 3, false), 32);
  slot("soil");
  cone(base + Vec3{0, 0, 0.862 * height}, radiusAt(0.86) - wall - rim - 0.0015, 0.6 * topRadius,
       0.03 * height, 0, 24);
  slot_ = before;
}

void Builder::shade(Vec3 base, double bottomRadius, double topRadius, double height, double thickness,
                    int sides) {
  const double t = thickness;
  lathe(base,
        {{bottomRadius, 0},
         {topRadius, height},
         {topRadius - t, height},
         {bottomRadius - t, 0},
         {bottomRadius, 0}},
        sides);
}

}  // namespace idap::parametric
