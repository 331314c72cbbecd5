#include "scene/wall_builder.h"

#include <algorithm>

namespace idap {

namespace {

constexpr double kCoplanar = 4e-4;  // m

Vec2 outward(Vec2 direction) { return {direction.y, -direction.x}; }

Polygon rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

// The heights between which the line u = constant runs inside the shape, as pairs.
std::vector<double> heightsAt(const Regions& shape, double u) {
  std::vector<double> heights;
  const auto ring = [&](const Polygon& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      if ((a.x > u) != (b.x > u)) heights.push_back(a.y + (b.y - a.y) * (u - a.x) / (b.x - a.x));
    }
  };
  for (const Region& r : shape) {
    ring(r.outer);
    for (const Polygon& hole : r.holes) ring(hole);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

bool inside(const Regions& shape, Vec2 p) {
  for (const Region& r : shape) {
    if (!contains(r.outer, p)) continue;
    if (std::none_of(r.holes.begin(), r.holes.end(), [&](const Polygon& h) { return contains(h, p); })) {
      return true;
    }
  }
  return false;
}

}  // namespace

WallBuilder::WallBuilder(const Home& home, const std::vector<WallSolid>& walls,
                         const std::vector<std::vector<WallCut>>& cuts)
    : home_(home), walls_(walls), cuts_(cuts) {
  for (const WallSolid& wall : walls_) faces_.push_back(facesOf(wall));
}

std::shared_ptr<const Mesh> WallBuilder::build(std::size_t index, Vec3 centre, StructureMemo* memo) const {
  if (!memo) return make(index, centre);
  return memo->meshes.get(keyOf(index, centre), [&] { return make(index, centre); });
}

bool WallBuilder::near(const WallSolid& wall, const WallSolid& other) const {
  return other.box.overlaps({wall.box.min - Vec2{0.001, 0.001}, wall.box.max + Vec2{0.001, 0.001}});
}

// All that make() looks at: the wall, those it meets, and what cuts it.
std::string WallBuilder::keyOf(std::size_t index, Vec3 centre) const {
  MemoKey key('W');
  key.add(centre.x).add(centre.y).add(centre.z);
  const auto addWall = [&](const WallSolid& s) {
    const Wall& w = *s.wall;
    key.add(w.start).add(w.end).add(w.arcExtent).add(w.thickness).add(w.heightAtStart).add(w.heightAtEnd);
    key.add(w.neighbourAtStart.value).add(w.neighbourAtEnd.value).add(s.id.value);
    key.add(s.floor).add(s.bottom).add(s.raised);
    key.add(s.outline.left).add(s.outline.right).add(s.outline.startCap).add(s.outline.endCap);
  };
  const WallSolid& wall = walls_[index];
  addWall(wall);
  for (const WallSide* side : {&wall.wall->left, &wall.wall->right}) {
    key.add(side->baseboard ? side->baseboard->thickness : -1);
    key.add(side->baseboard ? side->baseboard->height : -1);
  }
  for (std::size_t j = 0; j < walls_.size(); ++j) {
    if (j != index && near(wall, walls_[j])) key.add(j < index), addWall(walls_[j]);
  }
  for (const WallCut& cut : cuts_[index]) {
    const OpeningCut& o = *cut.opening;
    key.add(cut.throughLow).add(cut.throughHigh).add(cut.leftIsHigh);
    key.add(o.origin).add(o.uAxis).add(o.vAxis).add(o.v0).add(o.v1).add(o.bothSides).add(o.shape);
  }
  return key.take();
}

std::shared_ptr<const Mesh> WallBuilder::make(std::size_t index, Vec3 centre) const {
  MeshSink sink(centre);
  for (const Face& face : faces_[index]) addFace(index, face, sink);
  addTop(index, sink);
  for (const WallCut& cut : cuts_[index]) {
    addReveals(index, cut, sink);
    if (!cut.throughLow) addBackPlate(index, cut, true, sink);
    if (!cut.throughHigh) addBackPlate(index, cut, false, sink);
  }
  if (walls_[index].wall->left.baseboard) addBaseboard(index, true, sink);
  if (walls_[index].wall->right.baseboard) addBaseboard(index, false, sink);
  return sink.empty() ? nullptr : sink.take();
}

std::vector<WallBuilder::Face> WallBuilder::facesOf(const WallSolid& wall) const {
  std::vector<Face> faces;
  const auto side = [&](const std::vector<Vec2>& line, std::uint32_t slot, bool cap) {
    const std::size_t first = faces.size();
    double s = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 d = line[i + 1] - line[i];
      const double l = length(d);
      if (l < 1e-7) continue;
      const Vec2 n = outward(d / l);
      faces.push_back({line[i], line[i + 1], n, n, s, slot, cap});
      s += l;
    }
    if (!wall.outline.round || cap) return;
    for (std::size_t i = first; i + 1 < faces.size(); ++i) {
      faces[i].n1 = faces[i + 1].n0 = normalized(outward(normalized(faces[i].p1 - faces[i].p0)) +
                                                 outward(normalized(faces[i + 1].p1 - faces[i + 1].p0)));
    }
  };
  // An end belongs half to the right side and half to the left.
  const auto cap = [&](Vec2 from, std::vector<Vec2> between, Vec2 to, std::uint32_t slot0,
                       std::uint32_t slot1) {
    const Vec2 middle = between.empty() ? (from + to) / 2 : between[between.size() / 2];
    side({from, middle}, slot0, true);
    side({middle, to}, slot1, true);
  };
  const WallOutline& o = wall.outline;
  side(o.right, kWallRight, false);
  cap(o.right.back(), o.endCap, o.left.back(), kWallRight, kWallLeft);
  side({o.left.rbegin(), o.left.rend()}, kWallLeft, false);
  cap(o.left.front(), o.startCap, o.right.front(), kWallLeft, kWallRight);
  return faces;
}

Regions WallBuilder::cutFace(const WallSolid& wall, const WallCut& cut, const Face& face) const {
  const OpeningCut& o = *cut.opening;
  const double l = length(face.p1 - face.p0);
  const Vec2 d = (face.p1 - face.p0) / l;
  const double u0 = o.uOf(face.p0), k = dot(d, o.uAxis);
  const double uMin = std::min(u0, u0 + k * l), uMax = std::max(u0, u0 + k * l);
  if (uMax < o.box.min.x || uMin > o.box.max.x) return {};
  // Only the faces of the stretch of wall that the opening stands in, on the sides that it reaches.
  double low = 0, high = 0;
  const double uMiddle = std::clamp((std::max(uMin, o.box.min.x) + std::min(uMax, o.box.max.x)) / 2,
                                    o.box.min.x + 1e-6, o.box.max.x - 1e-6);
  // An end lies on the border of where the wall is.
  if (!wallSpanAt(wall, o, uMiddle, low, high) && !wallSpanAt(wall, o, uMiddle - 1e-6, low, high) &&
      !wallSpanAt(wall, o, uMiddle + 1e-6, low, high)) {
    return {};
  }
  const double v = o.vOf(face.p0 + d * (std::abs(k) > 1e-3 ? (uMiddle - u0) / k : l / 2));
  if (v < low - 0.01 || v > high + 0.01) return {};

  if (face.cap) {
    const double v0 = cut.throughLow ? low - 1 : o.v0, v1 = cut.throughHigh ? high + 1 : o.v1;
    const double va = o.vOf(face.p0), kv = dot(d, o.vAxis);
    if (std::abs(kv) < 0.1) return {};
    const double sa = (v0 - va) / kv, sb = (v1 - va) / kv;
    const std::vector<double> z =
        heightsAt(o.shape, std::clamp((uMin + uMax) / 2, o.box.min.x + 1e-6, o.box.max.x - 1e-6));
    Regions result;
    for (std::size_t i = 0; i + 1 < z.size(); i += 2) {
      result.push_back({rectangle(std::min(sa, sb), z[i], std::max(sa, sb), z[i + 1]), {}});
    }
    return result;
  }
  const bool atHigh = std::abs(v - high) < std::abs(v - low);
  if (atHigh ? !cut.throughHigh : !cut.throughLow) return {};
  if (std::abs(k) < 0.1) return {};
  Regions result = o.shape;
  const auto map = [&](Polygon& points) {
    for (Vec2& p : points) p.x = (p.x - u0) / k;
  };
  for (Region& r : result) {
    map(r.outer);
    for (Polygon& hole : r.holes) map(hole);
  }
  return result;
}

// Where another wall's face lies in the same plane and takes precedence: sides over ends, then lower ids.
Regions WallBuilder::coveredByOthers(std::size_t index, const Face& face) const {
  Regions result;
  const WallSolid& wall = walls_[index];
  const double l = length(face.p1 - face.p0);
  const Vec2 d = (face.p1 - face.p0) / l, n = outward(d);
  for (std::size_t j = 0; j < walls_.size(); ++j) {
    const WallSolid& other = walls_[j];
    if (j == index || !near(wall, other)) continue;
    for (const Face& f : faces_[j]) {
      if (f.cap != face.cap ? f.cap : j > index) continue;
      if (std::abs(dot(f.p0 - face.p0, n)) > kCoplanar || std::abs(dot(f.p1 - face.p0, n)) > kCoplanar)
        continue;
      const double a = dot(f.p0 - face.p0, d), b = dot(f.p1 - face.p0, d);
      if (b <= a || std::min(b, l) - std::max(a, 0.0) < 1e-4) continue;
      const double topA = other.topAt(f.p0), topB = other.topAt(f.p1);
      if (std::min(wall.topAt(face.p0), topA) - std::max(wall.bottom, other.bottom) < 1e-3) continue;
      result.push_back({{{a, other.bottom}, {b, other.bottom}, {b, topB}, {a, topA}}, {}});
    }
  }
  return result;
}

void WallBuilder::addFace(std::size_t index, const Face& face, MeshSink& sink) const {
  const WallSolid& wall = walls_[index];
  const double l = length(face.p1 - face.p0);
  const double top0 = wall.topAt(face.p0), top1 = wall.topAt(face.p1);
  if (std::max(top0, top1) <= wall.bottom + 1e-6) return;
  Regions region{{{{0, wall.bottom},
                   {l, wall.bottom},
                   {l, std::max(top1, wall.bottom)},
                   {0, std::max(top0, wall.bottom)}},
                  {}}};
  Regions away = coveredByOthers(index, face);
  for (const WallCut& cut : cuts_[index]) {
    Regions part = cutFace(wall, cut, face);
    away.insert(away.end(), part.begin(), part.end());
  }
  if (!away.empty()) region = subtract(region, away);
  sink.face(region, face.slot, [&](Vec2 p) {
    const double f = std::clamp(p.x / l, 0.0, 1.0);
    const Vec2 at = face.p0 + (face.p1 - face.p0) * f;
    const Vec2 n = normalized(face.n0 * (1 - f) + face.n1 * f);
    return MeshSink::Vertex{{at.x, at.y, p.y}, {n.x, n.y, 0}, {face.s + p.x, p.y - wall.floor}};
  });
}

void WallBuilder::addTop(std::size_t index, MeshSink& sink) const {
  const WallSolid& wall = walls_[index];
  Regions region{{wall.polygon, {}}};
  if (signedArea(wall.polygon) <= 0) region = repair(wall.polygon);
  // Walls that overlap show one top, not two that flicker.
  Regions others;
  if (wall.flatTop()) {
    const double top = wall.topAt(wall.wall->start);
    for (std::size_t j = 0; j < index; ++j) {
      const WallSolid& other = walls_[j];
      if (other.flatTop() && other.box.overlaps(wall.box) &&
          std::abs(other.topAt(other.wall->start) - top) < 5e-4) {
        others.push_back({other.polygon, {}});
      }
    }
  }
  if (!others.empty()) region = subtract(region, others);
  const Vec2 d = wall.wall->end - wall.wall->start;
  const double slope = (wall.wall->heightAtEnd - wall.wall->heightAtStart) / std::max(dot(d, d), 1e-9);
  const Vec3 normal = normalized(Vec3{-d.x * slope, -d.y * slope, 1});
  sink.face(region, kWallTop, [&](Vec2 p) { return MeshSink::Vertex{{p.x, p.y, wall.topAt(p)}, normal, p}; });
  sink.horizontal({{wall.polygon, {}}}, wall.bottom, false, kWallTop);
}

void WallBuilder::addReveals(std::size_t index, const WallCut& cut, MeshSink& sink) const {
  const WallSolid& wall = walls_[index];
  const OpeningCut& o = *cut.opening;
  // Breaks of the wall's sides, so that reveals follow round walls.
  std::vector<double> breaks;
  for (const Vec2& p : wall.polygon) {
    const double u = o.uOf(p);
    if (u > o.box.min.x && u < o.box.max.x) breaks.push_back(u);
  }
  std::sort(breaks.begin(), breaks.end());
  const double middle = (o.v0 + o.v1) / 2;
  const std::uint32_t lowSlot = cut.leftIsHigh ? kWallRight : kWallLeft;
  const std::uint32_t highSlot = cut.leftIsHigh ? kWallLeft : kWallRight;

  const auto strip = [&](Vec2 a, Vec2 b, Vec2 spanA, Vec2 spanB, std::uint32_t slot, double s, double next) {
    const auto at = [&](Vec2 p, double v) {
      const Vec2 plan = o.plan(p.x, v);
      return Vec3{plan.x, plan.y, p.y};
    };
    // Going round the shape counter-clockwise in (u, z) the hole lies on the left; the face looks into it.
    sink.quad({at(a, spanA.x), at(b, spanB.x), at(b, spanB.y), at(a, spanA.y)},
              {Vec2{spanA.x, s}, Vec2{spanB.x, next}, Vec2{spanB.y, next}, Vec2{spanA.y, s}}, slot);
  };
  const auto piece = [&](Vec2 a, Vec2 b, double s) {
    if (length(b - a) < 1e-6) return;
    const auto spanAt = [&](double u, double towards, Vec2& span) {
      const double nudge = towards > u ? 1e-6 : towards < u ? -1e-6 : 0;
      double low = 0, high = 0;
      bool found = wallSpanAt(wall, o, u + nudge, low, high);
      if (!found && nudge == 0) {
        found = wallSpanAt(wall, o, u + 1e-6, low, high) || wallSpanAt(wall, o, u - 1e-6, low, high);
      }
      if (!found) return false;
      span = {cut.throughLow ? low : std::max(low, o.v0), cut.throughHigh ? high : std::min(high, o.v1)};
      return span.x < span.y;
    };
    Vec2 spanA, spanB;
    if (!spanAt(a.x, b.x, spanA) || !spanAt(b.x, a.x, spanB)) return;
    // Only what lies between the wall's bottom and top.
    const auto topOver = [&](Vec2 p) { return wall.topAt(o.plan(p.x, middle)); };
    const double overA = a.y - topOver(a), overB = b.y - topOver(b);
    if (overA >= -1e-6 && overB >= -1e-6) return;
    if (a.y <= wall.bottom + 1e-6 && b.y <= wall.bottom + 1e-6) return;
    const Vec2 a0 = a;
    const auto clip = [&](double fa, double fb) {
      if ((fa > 0) == (fb > 0)) return;
      const double t = fa / (fa - fb);
      const Vec2 p = a + (b - a) * t, span = spanA + (spanB - spanA) * t;
      if (fa > 0) {
        a = p, spanA = span;
      } else {
        b = p, spanB = span;
      }
    };
    clip(overA, overB);
    clip(wall.bottom - a.y, wall.bottom - b.y);
    // Where openings overlap, the one has no reveal within the other.
    const Vec2 centre = (a + b) / 2;
    for (const WallCut& other : cuts_[index]) {
      if (other.opening == cut.opening) continue;
      const Vec2 plan = o.plan(centre.x, middle);
      if (inside(other.opening->shape, {other.opening->uOf(plan), centre.y})) return;
    }
    const double sa = s + length(a - a0), sb = sa + length(b - a);
    const auto split = [&](Vec2 span) { return std::clamp(middle, span.x, span.y); };
    strip(a, b, {spanA.x, split(spanA)}, {spanB.x, split(spanB)}, lowSlot, sa, sb);
    strip(a, b, {split(spanA), spanA.y}, {split(spanB), spanB.y}, highSlot, sa, sb);
  };
  const auto ring = [&](const Polygon& points) {
    double s = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      Vec2 from = a;
      const auto stop = [&](double u) {
        const double t = (u - a.x) / (b.x - a.x);
        if (!(t > 0 && t < 1)) return;
        const Vec2 p = a + (b - a) * t;
        piece(from, p, s + length(from - a));
        from = p;
      };
      if (std::abs(b.x - a.x) > 1e-9) {
        if (b.x > a.x) {
          std::for_each(breaks.begin(), breaks.end(), stop);
        } else {
          std::for_each(breaks.rbegin(), breaks.rend(), stop);
        }
      }
      piece(from, b, s + length(from - a));
      s += length(b - a);
    }
  };
  for (const Region& r : o.shape) {
    ring(r.outer);
    for (const Polygon& hole : r.holes) ring(hole);
  }
}

// The bottom of a hole that does not go through.
void WallBuilder::addBackPlate(std::size_t index, const WallCut& cut, bool atLow, MeshSink& sink) const {
  const WallSolid& wall = walls_[index];
  const OpeningCut& o = *cut.opening;
  const double v = atLow ? o.v0 : o.v1;
  // The wall's own face in (u, z).
  Box2 along;
  for (const Vec2& p : wall.polygon) along.add({o.uOf(p), 0});
  const double middle = (o.v0 + o.v1) / 2;
  const Regions face{{{{along.min.x, wall.bottom},
                       {along.max.x, wall.bottom},
                       {along.max.x, wall.topAt(o.plan(along.max.x, middle))},
                       {along.min.x, wall.topAt(o.plan(along.min.x, middle))}},
                      {}}};
  const bool left = cut.leftIsHigh == atLow;  // seen from the open side
  const Vec2 n = atLow ? o.vAxis : -o.vAxis;
  Regions region = intersect(o.shape, face);
  if (atLow) {
    // v runs away from who looks along u: mirrored, the face looks the other way.
    for (Region& r : region) {
      for (Vec2& p : r.outer) p.x = -p.x;
      for (Polygon& hole : r.holes) {
        for (Vec2& p : hole) p.x = -p.x;
      }
    }
  }
  sink.face(region, left ? kWallLeft : kWallRight, [&](Vec2 p) {
    const Vec2 plan = o.plan(atLow ? -p.x : p.x, v);
    return MeshSink::Vertex{{plan.x, plan.y, p.y}, {n.x, n.y, 0}, {p.x, p.y - wall.floor}};
  });
}

void WallBuilder::addBaseboard(std::size_t index, bool left, MeshSink& sink) const {
  const WallSolid& wall = walls_[index];
  const Baseboard& board = left ? *wall.wall->left.baseboard : *wall.wall->right.baseboard;
  const double height = std::min(board.height, std::max(wall.wall->heightAtStart, wall.wall->heightAtEnd));
  if (!(board.thickness > 1e-5) || !(height > 1e-4)) return;
  // Widened by the board, the outline is mitred at its corners as the boards are.
  const WallOutline wide = wallOutline(home_, wall.id, *wall.wall, board.thickness);
  const std::vector<Vec2>& outer = left ? wide.left : wide.right;
  const std::vector<Vec2>& inner = left ? wall.outline.left : wall.outline.right;
  Polygon ring = outer;
  ring.insert(ring.end(), inner.rbegin(), inner.rend());
  Regions region = repair(ring);
  Regions gaps;
  for (const WallCut& cut : cuts_[index]) {
    const OpeningCut& o = *cut.opening;
    if (o.box.min.y >= wall.floor + height - 0.005) continue;
    double low = 0, high = 0;
    if (!wallSpanAt(wall, o, (o.box.min.x + o.box.max.x) / 2, low, high)) continue;
    low -= 0.3, high += 0.3;
    gaps.push_back({{o.plan(o.box.min.x, low), o.plan(o.box.max.x, low), o.plan(o.box.max.x, high),
                     o.plan(o.box.min.x, high)},
                    {}});
  }
  if (!gaps.empty()) region = subtract(region, gaps);
  const std::uint32_t slot = left ? kBaseboardLeft : kBaseboardRight;
  sink.horizontal(region, wall.floor + height, true, slot);
  sink.sides(region, wall.floor, wall.floor + height, slot);
}

}  // namespace idap
