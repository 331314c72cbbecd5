// How far a piece is from what is around it.
#include <limits>
#include <optional>

#include "editor/hit_test_shapes.h"
#include "editor/snap_support.h"
#include "model/edits/level_edits.h"

namespace idap {

namespace {

constexpr double kFar = 15;         // m: what is further away is in another room
constexpr double kTouching = 1e-3;  // m
constexpr double kFlat = 0.05;      // m: a rug is no obstacle

// A strip that goes out from a side of the piece.
struct Strip {
  Vec2 start;    // middle of the side
  Vec2 outward;  // unit
  double half;   // of the side
  double nearest = kFar;
  double at = 0;  // along the side, where the nearest was

  // How far out a line from a to b comes into the strip, and there where along the side.
  void meet(Vec2 a, Vec2 b) {
    const Vec2 side = perpendicular(outward);
    Vec2 p{dot(a - start, outward), dot(a - start, side)}, q{dot(b - start, outward), dot(b - start, side)};
    if (p.y > q.y) std::swap(p, q);
    const double low = -half + kTouching, high = half - kTouching;
    if (q.y < low || p.y > high) return;
    const auto outAt = [&](double y) {
      return q.y - p.y < 1e-12 ? std::min(p.x, q.x) : p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y);
    };
    const double from = std::max(p.y, low), to = std::min(q.y, high);
    const double first = outAt(from), last = outAt(to), out = std::min(first, last);
    if (out < -kTouching || out >= nearest) return;
    nearest = out;
    at = std::abs(first - last) < 1e-6 ? std::clamp(0.0, from, to) : first < last ? from : to;
  }
  void meet(const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i) meet(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  std::optional<MeasureLine> line() const {
    if (nearest >= kFar || nearest < kTouching) return {};
    const Vec2 from = start + perpendicular(outward) * at;
    return MeasureLine{from, from + outward * nearest, false};
  }
};

std::vector<MeasureLine> measured(const std::array<Strip, 4>& strips) {
  std::vector<MeasureLine> lines;
  for (const Strip& strip : strips)
    if (const auto line = strip.line()) lines.push_back(*line);
  return lines;
}

std::vector<MeasureLine> onPlan(const Home& home, const Piece& piece, const Elements& ignored) {
  const Vec2 at = planOf(piece), right = rotated(Vec2{1, 0}, piece.angle), back = perpendicular(right);
  std::array<Strip, 4> strips{{{at - right * (piece.size.x / 2), -right, piece.size.y / 2},
                               {at + right * (piece.size.x / 2), right, piece.size.y / 2},
                               {at - back * (piece.size.y / 2), -back, piece.size.x / 2},
                               {at + back * (piece.size.y / 2), back, piece.size.x / 2}}};
  const auto meet = [&strips](const Polygon& polygon) {
    for (Strip& strip : strips) strip.meet(polygon);
  };
  bool walls = false;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != piece.level || contains(ignored, id)) continue;
    if (std::max(wall->heightAtStart, wall->heightAtEnd) <= piece.position.z) continue;
    walls = true;
    meet(outline(Plane::XY, home, id, *wall));
  }
  if (!walls)
    for (const auto& [id, room] : home.rooms)
      if (room->level == piece.level && contains(room->points, at)) meet(room->points);
  const double reach = kFar + std::hypot(piece.size.x, piece.size.y) / 2;
  forPiecesAround(home, piece.level, at, reach, ignored, [&](const Furniture& other) {
    if (other.size.z < kFlat || !heightsMeet(piece, other)) return;
    // Most are in none of the strips, which a look at their circle tells.
    const Vec2 off = planOf(other) - at;
    const double r = std::hypot(other.size.x, other.size.y) / 2;
    const double u = std::abs(dot(off, right)) - r, v = std::abs(dot(off, back)) - r;
    if (u > piece.size.x / 2 && v > piece.size.y / 2) return;
    const auto corners = footprint(other);
    meet({corners.begin(), corners.end()});
  });
  return measured(strips);
}

std::vector<MeasureLine> fromTheSide(const Home& home, Plane plane, const Piece& piece,
                                     const Elements& ignored) {
  const double floor = elevationOf(home, piece.level);
  const Box2 box = bounds(outline(plane, piece, floor));
  const Vec2 middle = (box.min + box.max) / 2, half = (box.max - box.min) / 2;
  std::array<Strip, 4> strips{{{{box.min.x, middle.y}, {-1, 0}, half.y},
                               {{box.max.x, middle.y}, {1, 0}, half.y},
                               {{middle.x, box.min.y}, {0, -1}, half.x},
                               {{middle.x, box.max.y}, {0, 1}, half.x}}};
  const auto meet = [&strips](const Polygon& polygon) {
    for (Strip& strip : strips) strip.meet(polygon);
  };
  const Vec2 sight = plane == Plane::XZ ? Vec2{0, 1} : Vec2{1, 0};
  const double across = dot(planOf(piece), sight), depth = halfExtent(piece, sight);
  const double ceiling = floor + ceilingHeight(home, piece.level);
  for (const double z : {floor, ceiling}) meet({{box.min.x, z}, {box.max.x, z}});
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != piece.level || contains(ignored, id)) continue;
    const Polygon plan = outline(Plane::XY, home, id, *wall);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec2 p : plan) low = std::min(low, dot(p, sight)), high = std::max(high, dot(p, sight));
    // Only what stands beside it, not the wall before or behind.
    if (low >= across + depth - kTouching || high <= across - depth + kTouching) continue;
    meet(outline(plane, home, id, *wall));
  }
  forPiecesAround(home, piece.level, planOf(piece), kFar, ignored, [&](const Furniture& other) {
    if (std::abs(dot(planOf(other), sight) - across) >= depth + halfExtent(other, sight) - kTouching) return;
    meet(outline(plane, other, floor));
  });
  return measured(strips);
}

}  // namespace

std::vector<MeasureLine> clearances(const Editor& editor, Plane plane, const Piece& piece,
                                    const Elements& ignored) {
  return plane == Plane::XY ? onPlan(editor.home(), piece, ignored)
                            : fromTheSide(editor.home(), plane, piece, ignored);
}

}  // namespace idap
