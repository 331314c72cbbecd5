#include "model/wall_outline.h"

#include <algorithm>
#include <optional>

namespace idap {

namespace {

constexpr double kChordError = 0.001;  // m, of round walls' sides
constexpr double kSmallestArc = 1e-3;  // radians; rounder than this a wall is straight

using Line = std::vector<Vec2>;

struct Arc {
  Vec2 centre;
  double radius = 0, from = 0, sweep = 0;
  Vec2 at(double fraction, double r) const {
    const double angle = from + sweep * fraction;
    return centre + Vec2{std::cos(angle), std::sin(angle)} * r;
  }
};

std::optional<Arc> arcOf(const Wall& wall) {
  const double sweep = std::clamp(wall.arcExtent, -1.98 * kPi, 1.98 * kPi);
  const Vec2 chord = wall.end - wall.start;
  const double c = length(chord);
  if (std::abs(sweep) < kSmallestArc || c < 1e-6) return std::nullopt;
  Arc arc;
  arc.sweep = sweep;
  arc.radius = c / (2 * std::sin(std::abs(sweep) / 2));
  arc.centre = (wall.start + wall.end) / 2 + perpendicular(chord) * (0.5 / std::tan(sweep / 2));
  const Vec2 spoke = wall.start - arc.centre;
  arc.from = std::atan2(spoke.y, spoke.x);
  return arc;
}

int stepsOf(const Arc& arc, double halfThickness) {
  const double outer = arc.radius + halfThickness;
  const double step = 2 * std::acos(std::max(0.0, 1 - kChordError / outer));
  return static_cast<int>(std::clamp(std::ceil(std::abs(arc.sweep) / step), 2.0, 720.0));
}

struct Sides {
  Line left, right;
  bool round = false;
};

// Both side lines with square ends.
Sides squareSides(const Wall& wall, double widening) {
  const double h = wall.thickness / 2 + widening;
  Sides sides;
  if (const auto arc = arcOf(wall)) {
    const int n = stepsOf(*arc, h);
    const double inner = std::max(arc->radius - h, 1e-3), outer = arc->radius + h;
    for (int i = 0; i <= n; ++i) {
      const double f = double(i) / n;
      sides.left.push_back(arc->at(f, arc->sweep > 0 ? inner : outer));
      sides.right.push_back(arc->at(f, arc->sweep > 0 ? outer : inner));
    }
    sides.round = true;
  } else {
    const Vec2 d = wall.end - wall.start;
    const double l = length(d);
    const Vec2 across = l > 0 ? perpendicular(d / l) * h : Vec2{0, h};
    sides.left = {wall.start + across, wall.end + across};
    sides.right = {wall.start - across, wall.end - across};
  }
  return sides;
}

// The side lines seen from one end of the wall: both run away from it.
struct End {
  Line left, right;
};
End endOf(const Sides& sides, bool atStart) {
  if (atStart) return {sides.left, sides.right};
  End end{sides.right, sides.left};
  std::reverse(end.left.begin(), end.left.end());
  std::reverse(end.right.begin(), end.right.end());
  return end;
}

struct Meeting {
  Vec2 point;               // where line a begins now
  std::size_t segment = 0;  // of a that it lies on
  bool beyond = false;      // too far out: must be cut off
};

// Where side line a of one wall meets side line b of its neighbour. Nothing where they do not within reach.
std::optional<Meeting> meet(const Line& a, const Line& b, double reach) {
  const Vec2 da = normalized(a[1] - a[0]), db = normalized(b[1] - b[0]);
  const double turn = cross(da, db);
  if (std::abs(turn) < 1e-3) {
    // One wall goes on in the other: they share the point in the middle if their sides are one line.
    if (dot(da, db) < 0 && length(a[0] - b[0]) < 0.002) return Meeting{(a[0] + b[0]) / 2};
    if (std::abs(turn) < 1e-4) return std::nullopt;
  }
  if (a.size() > 2 || b.size() > 2) {
    for (std::size_t i = 0; i + 1 < a.size(); ++i) {
      for (std::size_t j = 0; j + 1 < b.size(); ++j) {
        const Vec2 u = a[i + 1] - a[i], v = b[j + 1] - b[j], w = b[j] - a[i];
        const double c = cross(u, v);
        if (c == 0) continue;
        const double s = cross(w, v) / c, t = cross(w, u) / c;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1 && length(a[i] - a[0]) < 2 * reach)
          return Meeting{a[i] + u * s, i};
      }
    }
  }
  const Vec2 between = b[0] - a[0];
  const double s = cross(between, db) / turn, t = cross(between, da) / turn;
  if (s > std::min(length(a[1] - a[0]), 4 * reach) || t > std::min(length(b[1] - b[0]), 4 * reach)) {
    return std::nullopt;
  }
  if (s < -reach || t < -reach) {
    // In one line but of different thickness there is no tip to cut off.
    if (dot(da, db) < -0.95) return std::nullopt;
    return Meeting{a[0] - da * reach, 0, true};
  }
  return Meeting{a[0] + da * s};
}

void cutBack(Line& line, const Meeting& meeting) {
  line.erase(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(meeting.segment));
  line[0] = meeting.point;
  if (line.size() > 2 && length(line[1] - line[0]) < 1e-6) line.erase(line.begin() + 1);
}

// The neighbour's end that is joined to this wall, if the joint is mutual.
std::optional<bool> jointOf(const Wall& neighbour, WallId wall, Vec2 joint) {
  const bool start = neighbour.neighbourAtStart == wall, end = neighbour.neighbourAtEnd == wall;
  if (start && end) return length(neighbour.start - joint) <= length(neighbour.end - joint);
  if (start) return true;
  if (end) return false;
  return std::nullopt;
}

// Shapes one end. cap receives the points between end.right's and end.left's beginnings.
void join(const Home& home, WallId id, const Wall& wall, bool atStart, double widening, End& end, Line& cap) {
  const WallId neighbourId = atStart ? wall.neighbourAtStart : wall.neighbourAtEnd;
  const Wall* neighbour = neighbourId == id ? nullptr : home.walls.find(neighbourId);
  if (!neighbour || neighbour->level != wall.level) return;
  const auto theirs = jointOf(*neighbour, id, atStart ? wall.start : wall.end);
  if (!theirs) return;
  const End other = endOf(squareSides(*neighbour, widening), *theirs);
  const double thickest = std::max(wall.thickness, neighbour->thickness) + 2 * widening;
  const double reach = 2 * thickest;
  // Seen from the joint, the left line of one wall meets the right line of the other.
  const auto left = meet(end.left, other.right, reach), right = meet(end.right, other.left, reach);
  if (!left || !right) {
    // Walls of different thickness in one line, or folded back: let the thinner one run into the other.
    if (wall.thickness < neighbour->thickness) {
      for (Line* line : {&end.left, &end.right}) {
        (*line)[0] = (*line)[0] - normalized((*line)[1] - (*line)[0]) * 0.005;
      }
    }
    return;
  }
  if (left->beyond || right->beyond) {
    const auto tip = [&](const Line& mine, const Line& their) {
      return (mine[0] - normalized(mine[1] - mine[0]) * reach + their[0] -
              normalized(their[1] - their[0]) * reach) /
             2;
    };
    if (left->beyond && !right->beyond) cap.push_back(tip(end.left, other.right));
    if (right->beyond && !left->beyond) cap.push_back(tip(end.right, other.left));
  }
  cutBack(end.left, *left);
  cutBack(end.right, *right);
}

}  // namespace

Polygon WallOutline::polygon() const {
  Polygon ring = right;
  ring.insert(ring.end(), endCap.begin(), endCap.end());
  ring.insert(ring.end(), left.rbegin(), left.rend());
  ring.insert(ring.end(), startCap.begin(), startCap.end());
  return ring;
}

WallOutline wallOutline(const Home& home, WallId id, const Wall& wall, double widening) {
  Sides sides = squareSides(wall, widening);
  WallOutline outline;
  outline.round = sides.round;

  End start = endOf(sides, true);
  join(home, id, wall, true, widening, start, outline.startCap);
  sides.left = std::move(start.left);
  sides.right = std::move(start.right);

  End end = endOf(sides, false);
  join(home, id, wall, false, widening, end, outline.endCap);
  outline.left.assign(end.right.rbegin(), end.right.rend());
  outline.right.assign(end.left.rbegin(), end.left.rend());
  return outline;
}

std::vector<Vec2> wallCentreLine(const Wall& wall) {
  const auto arc = arcOf(wall);
  if (!arc) return {wall.start, wall.end};
  const int n = stepsOf(*arc, wall.thickness / 2);
  std::vector<Vec2> line;
  for (int i = 0; i <= n; ++i) line.push_back(arc->at(double(i) / n, arc->radius));
  line.front() = wall.start;
  line.back() = wall.end;
  return line;
}

double alongWall(const Wall& wall, Vec2 point) {
  if (const auto arc = arcOf(wall)) {
    const Vec2 spoke = point - arc->centre;
    // Measured from the middle of the arc, so that both ends are far from where the angle wraps.
    const double middle = arc->from + arc->sweep / 2;
    const double angle = std::remainder(std::atan2(spoke.y, spoke.x) - middle, 2 * kPi);
    return std::clamp(0.5 + angle / arc->sweep, 0.0, 1.0);
  }
  const Vec2 d = wall.end - wall.start;
  const double l2 = dot(d, d);
  return l2 > 0 ? dot(point - wall.start, d) / l2 : 0;
}

}  // namespace idap
