#include "scene/opening_cut.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/error.h"
#include "geometry/svg_path.h"

namespace idap {

namespace {

constexpr double kUnderFrame = 0.001;      // m that the wall reaches under the frame
constexpr double kThreshold = 0.02;        // m; sills up to here are doorsteps
constexpr double kUnderThreshold = 0.004;  // m that the hole of a door goes below the floor
constexpr double kLeastParallel = 0.5;     // cosine; walls more across than that are left whole
constexpr double kReach = 0.03;            // m that a box may end short of a wall's face and still cut it

Regions shapeOf(const Opening& opening, double sill, bool atFloor) {
  std::vector<Polygon> rings;
  try {
    rings = parseSvgPath(opening.cutOut);
  } catch (const ParseError&) {
  }
  if (rings.empty()) rings = {{{0, 0}, {0, 1}, {1, 1}, {1, 0}}};
  const double inset = opening.kind == OpeningKind::Bare ? 0 : kUnderFrame;
  const double width = std::max(opening.size.x - 2 * inset, 1e-4);
  const double height = std::max(opening.size.z - 2 * inset, 1e-4);
  for (Polygon& ring : rings) {
    for (Vec2& p : ring) {
      const double u = (p.x - 0.5) * width;
      const bool bottom = p.y > 1 - 1e-9;
      p = {opening.mirrored ? -u : u, sill + inset + (1 - p.y) * height};
      if (bottom && atFloor) p.y = sill - kUnderThreshold;
    }
  }
  return unite(rings);
}

}  // namespace

bool wallSpanAt(const WallSolid& wall, const OpeningCut& cut, double u, double& low, double& high) {
  // Crossings of the outline with the line u = constant; between pairs of them lies wall.
  double crossings[16];
  int count = 0;
  for (std::size_t i = 0; i < wall.polygon.size() && count < 16; ++i) {
    const Vec2 a = wall.polygon[i], b = wall.polygon[(i + 1) % wall.polygon.size()];
    const double ua = cut.uOf(a) - u, ub = cut.uOf(b) - u;
    if ((ua > 0) == (ub > 0)) continue;
    const double t = ua / (ua - ub);
    crossings[count++] = cut.vOf(a + (b - a) * t);
  }
  std::sort(crossings, crossings + count);
  const double middle = (cut.v0 + cut.v1) / 2;
  double nearest = 1e300;
  for (int i = 0; i + 1 < count; i += 2) {
    const double distance = std::max({crossings[i] - middle, middle - crossings[i + 1], 0.0});
    if (distance < nearest) {
      nearest = distance;
      low = crossings[i];
      high = crossings[i + 1];
    }
  }
  return nearest < 1e300;
}

std::vector<OpeningCut> openingCuts(const Home& home, const std::vector<Storey>& storeys) {
  std::vector<OpeningCut> cuts;
  for (const auto& [id, opening] : home.openings) {
    if (!opening->cutsWalls || !isShownOn(home, storeys, *opening)) continue;
    const auto storey = std::ranges::find(storeys, opening->level, &Storey::id);
    if (storey == storeys.end() || !isFinite(opening->position) || !isFinite(opening->size)) continue;
    OpeningCut cut;
    cut.id = id;
    cut.origin = {opening->position.x, opening->position.y};
    cut.uAxis = rotated(Vec2{1, 0}, opening->angle);
    cut.vAxis = perpendicular(cut.uAxis);
    const double depth = opening->size.y;
    cut.v1 = depth / 2 - opening->wallDistance * depth;
    cut.v0 = cut.v1 - opening->wallThickness * depth;
    if (opening->kind == OpeningKind::Bare) cut.v0 = -depth / 2, cut.v1 = depth / 2;
    cut.bothSides = opening->cutsBothSides || opening->kind == OpeningKind::Bare;
    cut.sill = storey->elevation + opening->position.z;
    cut.storey = static_cast<std::size_t>(storey - storeys.begin());
    cut.atFloor = std::abs(opening->position.z) <= kThreshold;
    if (cut.atFloor) cut.sill = storey->elevation;
    cut.shape = shapeOf(*opening, cut.sill, cut.atFloor);
    for (const Region& r : cut.shape) {
      for (const Vec2& p : r.outer) cut.box.add(p);
    }
    if (!cut.shape.empty()) cuts.push_back(std::move(cut));
  }
  return cuts;
}

std::vector<WallCut> cutsOf(const WallSolid& wall, const std::vector<OpeningCut>& openings) {
  std::vector<WallCut> result;
  const double top = wall.floor + wall.raised + std::max(wall.wall->heightAtStart, wall.wall->heightAtEnd);
  for (const OpeningCut& cut : openings) {
    if (cut.box.min.y >= top || cut.box.max.y <= wall.floor - kUnderThreshold - 1e-6) continue;
    const double u0 = cut.box.min.x, u1 = cut.box.max.x;
    const Polygon box{cut.plan(u0, cut.v0), cut.plan(u1, cut.v0), cut.plan(u1, cut.v1), cut.plan(u0, cut.v1)};
    if (!bounds(box).overlaps(wall.box)) continue;
    const Regions common = intersect({{box, {}}}, {{wall.polygon, {}}});
    const double depth = cut.v1 - cut.v0;
    if (common.empty() || area(common) < (u1 - u0) * std::min(0.005, 0.3 * depth)) continue;

    // The wall's direction where it is cut.
    const std::vector<Vec2> line = wallCentreLine(*wall.wall);
    const Vec2 middle = cut.plan((u0 + u1) / 2, (cut.v0 + cut.v1) / 2);
    Vec2 direction = normalized(line[1] - line[0]);
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const double distance = length((line[i] + line[i + 1]) / 2 - middle);
      if (distance < nearest) nearest = distance, direction = normalized(line[i + 1] - line[i]);
    }
    const double cosine = dot(direction, cut.uAxis);
    if (std::abs(cosine) < kLeastParallel) continue;

    WallCut wallCut{&cut, true, true, cosine > 0};
    if (!cut.bothSides) {
      Vec2 at{};
      double count = 0;
      for (const Vec2& p : common.front().outer) at += p, count += 1;
      double low = 0, high = 0;
      if (wallSpanAt(wall, cut, cut.uOf(at / count), low, high)) {
        wallCut.throughLow = cut.v0 <= low + kReach;
        wallCut.throughHigh = cut.v1 >= high - kReach;
        // A box lost inside the wall opens both sides: nobody wants a hole that cannot be seen.
        if (!wallCut.throughLow && !wallCut.throughHigh) wallCut.throughLow = wallCut.throughHigh = true;
      }
    }
    result.push_back(wallCut);
  }
  return result;
}

std::vector<std::vector<WallCut>> cutsOf(const std::vector<WallSolid>& walls,
                                         const std::vector<OpeningCut>& openings) {
  std::vector<std::vector<WallCut>> cuts(walls.size());
  tbb::parallel_for(std::size_t{0}, walls.size(),
                    [&](std::size_t i) { cuts[i] = cutsOf(walls[i], openings); });
  return cuts;
}

}  // namespace idap
