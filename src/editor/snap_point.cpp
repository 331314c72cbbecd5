// Where a point that is being drawn snaps to: ends before crossings before lines before angles before what it
// is in line with.
#include <algorithm>
#include <limits>

#include "editor/hit_test_shapes.h"
#include "editor/snap.h"
#include "model/edits/level_edits.h"
#include "model/wall_outline.h"

namespace idap {

namespace {

constexpr double kSamePlace = 1e-3;     // m
constexpr double kAngleReach = 0.07;    // radians off a step of 15 degrees that still count
constexpr double kAngleFar = 2.5;       // times the tolerance that they may move the point
constexpr double kAlignmentFar = 30.0;  // m: nobody lines up with what is out of sight

struct Line {
  Vec2 a, b;
  bool endless = false;
};

Vec2 foot(const Line& line, Vec2 p) {
  const Vec2 along = line.b - line.a;
  const double squared = dot(along, along);
  if (squared == 0) return line.a;
  double t = dot(p - line.a, along) / squared;
  if (!line.endless) t = std::clamp(t, 0.0, 1.0);
  return line.a + along * t;
}

std::optional<Vec2> crossing(const Line& p, const Line& q) {
  const Vec2 u = p.b - p.a, v = q.b - q.a;
  const double d = cross(u, v);
  if (std::abs(d) < 1e-6 * length(u) * length(v)) return {};
  const double s = cross(q.a - p.a, v) / d, t = cross(q.a - p.a, u) / d;
  constexpr double kSlack = 1e-9;
  if (!p.endless && (s < -kSlack || s > 1 + kSlack)) return {};
  if (!q.endless && (t < -kSlack || t > 1 + kSlack)) return {};
  return p.a + u * s;
}

// What is there to snap to around a point.
struct Surroundings {
  std::vector<Vec2> ends;   // near the point
  std::vector<Line> lines;  // near the point
  std::vector<Vec2> marks;  // to be in line with, near or far
};

class Look {
 public:
  Look(const Editor& editor, const SnapRequest& request)
      : home_(editor.home()), editor_(editor), request_(request), floor_(editor.elevation()) {}

  Surroundings around() {
    const bool plan = request_.plane == Plane::XY;
    for (const auto& [id, wall] : home_.walls) {
      if (!here(*wall) || contains(request_.ignored, id)) continue;
      if (plan) {
        mark(wall->start);
        mark(wall->end);
        path(wallCentreLine(*wall), false, false);
      }
      if (!plan || request_.wallFaces) path(outline(request_.plane, home_, id, *wall), true, true);
    }
    if (plan) {
      for (const auto& [id, room] : home_.rooms) {
        if (!here(*room) || contains(request_.ignored, id)) continue;
        for (const Vec2 p : room->points) mark(p);
        path(room->points, true, false);
      }
      for (const auto& [id, line] : home_.polylines)
        if (here(*line) && !contains(request_.ignored, id)) path(line->points, line->closed, true);
    } else {
      const double ceiling = floor_ + ceilingHeight(home_, editor_.level());
      for (const double z : {floor_, ceiling})
        near_.lines.push_back({{request_.at.x - 1, z}, {request_.at.x + 1, z}, true});
    }
    if (!plan || request_.wallFaces) {
      pieces(home_.furniture);
      pieces(home_.openings);
      for (const auto& [id, dimension] : home_.dimensions)
        if (here(*dimension) && !contains(request_.ignored, id))
          if (const auto line = dimensionLine(request_.plane, *dimension, floor_)) {
            end(line->start);
            end(line->end);
          }
    }
    std::erase_if(near_.lines, [this](const Line& line) {
      return length(foot(line, request_.at) - request_.at) > request_.tolerance;
    });
    return std::move(near_);
  }

 private:
  template <class T>
  bool here(const T& element) const {
    return element.level == editor_.level();
  }
  void end(Vec2 p) {
    if (length(p - request_.at) <= request_.tolerance) near_.ends.push_back(p);
  }
  void mark(Vec2 p) {
    end(p);
    if (std::abs(p.x - request_.at.x) < kAlignmentFar && std::abs(p.y - request_.at.y) < kAlignmentFar)
      near_.marks.push_back(p);
  }
  void path(const std::vector<Vec2>& points, bool closed, bool ends) {
    if (ends)
      for (const Vec2 p : points) end(p);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) near_.lines.push_back({points[i], points[i + 1]});
    if (closed && points.size() > 2) near_.lines.push_back({points.back(), points.front()});
  }
  template <class Pieces>
  void pieces(const Pieces& table) {
    for (const auto& [id, piece] : table) {
      if (!here(*piece) || contains(request_.ignored, id)) continue;
      const Vec3 centre = piece->position + Vec3{0, 0, floor_ + piece->size.z / 2};
      const Vec2 off = project(request_.plane, centre) - request_.at;
      const double reach = length(piece->size) / 2 + request_.tolerance;
      if (dot(off, off) > reach * reach || !isShown(home_, *piece)) continue;
      if (piece->group && contains(request_.ignored, outermost(home_, piece->group))) continue;
      path(outline(request_.plane, *piece, floor_), true, true);
    }
  }

  const Home& home_;
  const Editor& editor_;
  const SnapRequest& request_;
  double floor_;
  Surroundings near_;
};

// The line from a point in the step of 15 degrees that is nearest to the pointer.
std::optional<Line> angleLine(const SnapRequest& request) {
  if (!request.from) return {};
  const Vec2 to = request.at - *request.from;
  const double far = length(to);
  if (far < kSamePlace) return {};
  const double angle = std::atan2(to.y, to.x);
  double off = std::numeric_limits<double>::infinity(), step = 0;
  for (const double base : {0.0, request.along.value_or(0)}) {
    const double candidate = base + std::round((angle - base) / (kPi / 12)) * (kPi / 12);
    if (std::abs(angle - candidate) < off - 1e-9) off = std::abs(angle - candidate), step = candidate;
  }
  // Near the start by angle, further off by what is still near on the screen.
  if (far * off > (off > kAngleReach ? 1 : kAngleFar) * request.tolerance) return {};
  return Line{*request.from, *request.from + rotated(Vec2{1, 0}, step), true};
}

std::vector<Line> alignmentLines(const SnapRequest& request, const std::vector<Vec2>& marks) {
  std::vector<Line> lines;
  for (const bool vertical : {true, false}) {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Vec2> best;
    for (const Vec2 mark : marks) {
      const Vec2 off = mark - request.at;
      const double aside = std::abs(vertical ? off.x : off.y), away = std::abs(vertical ? off.y : off.x);
      if (aside > request.tolerance * 0.7) continue;
      // Of equally good ones the nearest: its guide line is the shortest.
      const double score = aside + away * 1e-3;
      if (score < nearest) nearest = score, best = mark;
    }
    if (best) lines.push_back({*best, *best + (vertical ? Vec2{0, 1} : Vec2{1, 0}), true});
  }
  return lines;
}

SnappedPoint onGrid(const Editor& editor, const SnapRequest& request) {
  SnappedPoint point{request.at, SnappedPoint::To::Nothing, {}};
  if (!editor.settings().gridSnapping) return point;
  const double step = gridStep(request.tolerance, editor.settings().unit);
  point.at = {std::round(request.at.x / step) * step, std::round(request.at.y / step) * step};
  point.to = SnappedPoint::To::Grid;
  return point;
}

}  // namespace

double gridStep(double tolerance, LengthUnit unit) {
  static constexpr double kMetric[]{0.001, 0.005, 0.01, 0.05, 0.1, 0.5, 1, 5, 10};
  static constexpr double kFeet[]{0.0254 / 8, 0.0254 / 2, 0.0254, 0.0762, 0.1524, 0.3048, 1.524, 3.048};
  const auto pick = [tolerance](const auto& steps) {
    for (const double step : steps)
      if (step >= tolerance * 0.999) return step;
    return *std::rbegin(steps);
  };
  return unit == LengthUnit::FeetInches ? pick(kFeet) : pick(kMetric);
}

SnappedPoint snapPoint(const Editor& editor, const SnapRequest& request, bool off) {
  using To = SnappedPoint::To;
  if (off) return {request.at, To::Nothing, {}};
  if (!editor.settings().snapping) return onGrid(editor, request);

  Surroundings near = Look(editor, request).around();
  const auto distance = [&request](Vec2 p) { return length(p - request.at); };
  const auto zero = [&request](Vec2 p) { return request.from && length(p - *request.from) < kSamePlace; };

  // Ends. Those of the line itself first: closing it is meant before touching what is beside.
  std::optional<SnappedPoint> best;
  const auto offer = [&](Vec2 p, To to) {
    if (distance(p) > request.tolerance || zero(p)) return;
    if (!best || distance(p) < distance(best->at)) best = SnappedPoint{p, to, {}};
  };
  for (const Vec2 p : request.own) offer(p, To::Own);
  if (best) return *best;
  for (const Vec2 p : near.ends) offer(p, To::End);
  if (best) return *best;

  const std::optional<Line> angle = angleLine(request);
  near.marks.insert(near.marks.end(), request.own.begin(), request.own.end());
  near.marks.insert(near.marks.end(), request.marks.begin(), request.marks.end());
  if (request.from) near.marks.push_back(*request.from);
  const std::vector<Line> aligned = alignmentLines(request, near.marks);

  const auto guided = [&](Vec2 p, To to, std::initializer_list<const Line*> lines) {
    SnappedPoint point{p, to, {}};
    for (const Line* line : lines)
      if (line && length(p - line->a) > kSamePlace) point.guides.push_back({line->a, p});
    return point;
  };

  // Crossings of what is there, and with the line in its angle.
  for (std::size_t i = 0; i < near.lines.size(); ++i)
    for (std::size_t j = i + 1; j < near.lines.size(); ++j)
      if (const auto p = crossing(near.lines[i], near.lines[j])) offer(*p, To::Crossing);
  if (best) return *best;
  for (const Line& line : near.lines) {
    if (angle)
      if (const auto p = crossing(*angle, line)) offer(*p, To::Crossing);
    if (request.from) {
      const Vec2 square = foot(line, *request.from);
      if (length(square - *request.from) > request.tolerance) offer(square, To::Crossing);
    }
  }
  if (best) return guided(best->at, To::Crossing, {angle ? &*angle : nullptr});

  // Lines, and on them what is in line with something.
  for (const Line& line : near.lines) offer(foot(line, request.at), To::Line);
  if (best) {
    for (const Line& line : near.lines)
      for (const Line& axis : aligned)
        if (const auto p = crossing(line, axis);
            p && distance(*p) <= request.tolerance && length(foot(line, best->at) - best->at) < 1e-9)
          return guided(*p, To::Line, {&axis});
    return *best;
  }

  if (angle)
    for (const Line& axis : aligned)
      if (const auto p = crossing(*angle, axis); p && distance(*p) <= 2 * request.tolerance && !zero(*p))
        return guided(*p, To::Angle, {&*angle, &axis});
  if (aligned.size() == 2)
    if (const auto p = crossing(aligned[0], aligned[1]); p && !zero(*p))
      return guided(*p, To::Alignment, {&aligned[0], &aligned[1]});
  const Line* nearest = angle ? &*angle : nullptr;
  for (const Line& axis : aligned) {
    const Vec2 p = foot(axis, request.at);
    if (!zero(p) && (!nearest || distance(p) < distance(foot(*nearest, request.at)))) nearest = &axis;
  }
  if (nearest)
    return guided(foot(*nearest, request.at), angle && nearest == &*angle ? To::Angle : To::Alignment,
                  {nearest});
  return onGrid(editor, request);
}

}  // namespace idap
