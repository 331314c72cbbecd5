#include "model/edits/arrange_edits.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/error.h"
#include "geometry/polygon.h"
#include "model/edits/motion.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

// A piece or a group: what is lined up as one.
struct Unit {
  Elements elements;  // one id
  std::vector<Vec2> corners;
  double angle = 0;    // a group has none of its own
  bool fixed = false;  // locked, or held by a wall
};

void addCorners(std::vector<Vec2>& corners, const Piece& piece) {
  const Transform place = placement(piece);
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const Vec3 p = place.point({x * piece.size.x, y * piece.size.y, z * piece.size.z});
        corners.push_back({p.x, p.y});
      }
}

std::vector<Unit> unitsOf(const Home& home, const Elements& elements) {
  std::vector<Unit> units;
  const auto addOne = [&](Elements one, double angle) {
    Unit unit;
    const Elements all = withGroups(home, one);
    const Elements free = unlocked(home, one);
    unit.fixed = free.furniture.empty() && free.openings.empty() && free.groups.empty();
    for (const OpeningId id : all.openings) {
      const Opening& opening = *home.openings.find(id);
      addCorners(unit.corners, opening);
      unit.fixed = unit.fixed || opening.wall;
    }
    for (const FurnitureId id : all.furniture) addCorners(unit.corners, *home.furniture.find(id));
    unit.elements = std::move(one);
    unit.angle = angle;
    if (!unit.corners.empty()) units.push_back(std::move(unit));
  };
  for (const OpeningId id : elements.openings)
    if (const Opening* opening = home.openings.find(id)) {
      Elements one;
      one.openings = {id};
      addOne(std::move(one), opening->angle);
    }
  for (const FurnitureId id : elements.furniture)
    if (const Furniture* piece = home.furniture.find(id)) {
      Elements one;
      one.furniture = {id};
      addOne(std::move(one), piece->angle);
    }
  for (const GroupId id : elements.groups)
    if (home.groups.contains(id)) {
      Elements one;
      one.groups = {id};
      addOne(std::move(one), 0);
    }
  // What cannot move leads; otherwise the first in order.
  std::stable_partition(units.begin(), units.end(), [](const Unit& unit) { return unit.fixed; });
  return units;
}

struct Span {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  double middle() const { return (low + high) / 2; }
  double width() const { return high - low; }
};
Span spanOf(const Unit& unit, Vec2 axis) {
  Span span;
  for (const Vec2 p : unit.corners) {
    span.low = std::min(span.low, dot(p, axis));
    span.high = std::max(span.high, dot(p, axis));
  }
  return span;
}

void shift(Home& home, const Unit& unit, Vec2 axis, double distance) {
  if (unit.fixed || distance == 0) return;
  home = moveElements(home, unit.elements, {axis.x * distance, axis.y * distance, 0});
}

enum class Line { Low, Middle, High };
double lineOf(Span span, Line line) {
  return line == Line::Low ? span.low : line == Line::High ? span.high : span.middle();
}

Home alignOn(const Home& home, const std::vector<Unit>& units, Vec2 axis, Line line) {
  Home next = home;
  const double lead = lineOf(spanOf(units.front(), axis), line);
  for (std::size_t i = 1; i < units.size(); ++i)
    shift(next, units[i], axis, lead - lineOf(spanOf(units[i], axis), line));
  return next;
}

// Those right of the lead's middle go on to its right in their order, the others to its left.
Home inARow(const Home& home, const std::vector<Unit>& units, Vec2 right, Vec2 back) {
  const Span lead = spanOf(units.front(), right);
  std::vector<const Unit*> toRight, toLeft;
  for (std::size_t i = 1; i < units.size(); ++i)
    (spanOf(units[i], right).middle() < lead.middle() ? toLeft : toRight).push_back(&units[i]);
  const auto byPlace = [right](const Unit* a, const Unit* b) {
    return spanOf(*a, right).middle() < spanOf(*b, right).middle();
  };
  std::stable_sort(toRight.begin(), toRight.end(), byPlace);
  std::stable_sort(toLeft.begin(), toLeft.end(), byPlace);
  std::reverse(toLeft.begin(), toLeft.end());
  Home next = home;
  double free = lead.high;
  const double line = spanOf(units.front(), back).high;
  for (const Unit* unit : toRight) {
    const Span span = spanOf(*unit, right);
    shift(next, *unit, right, free - span.low);
    shift(next, *unit, back, line - spanOf(*unit, back).high);
    free += span.width();
  }
  free = lead.low;
  for (const Unit* unit : toLeft) {
    const Span span = spanOf(*unit, right);
    shift(next, *unit, right, free - span.high);
    shift(next, *unit, back, line - spanOf(*unit, back).high);
    free -= span.width();
  }
  return next;
}

// m2 of a footprint.
double footArea(const Piece& piece) { return piece.size.x * piece.size.y; }

bool standsOver(const Piece& support, const Piece& piece) {
  const auto corners = footprint(support);
  return support.visible && support.level == piece.level && footArea(support) > footArea(piece) &&
         support.position.z <= piece.position.z + 1e-6 &&
         contains(Polygon(corners.begin(), corners.end()), {piece.position.x, piece.position.y});
}

}  // namespace

Home alignElements(const Home& home, const Elements& elements, Alignment alignment) {
  const std::vector<Unit> units = unitsOf(home, elements);
  if (units.size() < 2) return home;
  const double angle = units.front().angle;
  const Vec2 right = rotated(Vec2{1, 0}, angle), back = perpendicular(right);
  switch (alignment) {
    case Alignment::Left:
      return alignOn(home, units, {1, 0}, Line::Low);
    case Alignment::Right:
      return alignOn(home, units, {1, 0}, Line::High);
    case Alignment::CentreHorizontal:
      return alignOn(home, units, {1, 0}, Line::Middle);
    case Alignment::Top:
      return alignOn(home, units, {0, 1}, Line::High);
    case Alignment::Bottom:
      return alignOn(home, units, {0, 1}, Line::Low);
    case Alignment::CentreVertical:
      return alignOn(home, units, {0, 1}, Line::Middle);
    case Alignment::FrontSide:
      return alignOn(home, units, back, Line::Low);
    case Alignment::BackSide:
      return alignOn(home, units, back, Line::High);
    case Alignment::LeftSide:
      return alignOn(home, units, right, Line::Low);
    case Alignment::RightSide:
      return alignOn(home, units, right, Line::High);
    case Alignment::SideBySide:
      return inARow(home, units, right, back);
  }
  return home;
}

Home distributeElements(const Home& home, const Elements& elements, bool horizontally) {
  std::vector<Unit> units = unitsOf(home, elements);
  if (units.size() < 3) return home;
  const Vec2 axis = horizontally ? Vec2{1, 0} : Vec2{0, 1};
  std::stable_sort(units.begin(), units.end(), [axis](const Unit& a, const Unit& b) {
    return spanOf(a, axis).middle() < spanOf(b, axis).middle();
  });
  double air = spanOf(units.back(), axis).low - spanOf(units.front(), axis).high;
  for (std::size_t i = 1; i + 1 < units.size(); ++i) air -= spanOf(units[i], axis).width();
  const double gap = air / static_cast<double>(units.size() - 1);
  Home next = home;
  double free = spanOf(units.front(), axis).high;
  for (std::size_t i = 1; i + 1 < units.size(); ++i) {
    const Span span = spanOf(units[i], axis);
    shift(next, units[i], axis, free + gap - span.low);
    free += gap + span.width();
  }
  return next;
}

Home resetElevations(const Home& home, const Elements& elements) {
  // The largest first: what stands on it finds it where it is then.
  std::vector<Unit> units = unitsOf(home, elements);
  struct Rest {
    Elements members;
    Piece foot;  // what stands: of a group, its lowest piece
  };
  std::vector<Rest> rests;
  for (const Unit& unit : units) {
    Rest rest;
    rest.members.furniture = withGroups(home, unit.elements).furniture;
    const Piece* lowest = nullptr;
    for (const FurnitureId id : rest.members.furniture) {
      const Piece* piece = home.furniture.find(id);
      if (!lowest || piece->position.z < lowest->position.z) lowest = piece;
    }
    if (!lowest) continue;
    rest.foot = *lowest;
    rests.push_back(std::move(rest));
  }
  std::stable_sort(rests.begin(), rests.end(),
                   [](const Rest& a, const Rest& b) { return footArea(a.foot) > footArea(b.foot); });
  Home next = home;
  for (const Rest& rest : rests) {
    double floor = 0;
    const std::set<FurnitureId> own = setOf(rest.members.furniture);
    for (const auto& [id, support] : next.furniture) {
      if (own.contains(id)) continue;
      const double top = support->position.z + support->dropOnTopHeight.value_or(support->size.z);
      if (top > floor && standsOver(*support, rest.foot)) floor = top;
    }
    const double rise = floor - rest.foot.position.z;
    if (rise != 0) next = moveElements(next, rest.members, {0, 0, rise});
  }
  return next;
}

Home mirrorElements(const Home& home, const Elements& elements) {
  const std::vector<Unit> units = unitsOf(home, elements);
  const bool others = !elements.walls.empty() || !elements.rooms.empty() || !elements.cameras.empty() ||
                      !elements.dimensions.empty() || !elements.labels.empty() || !elements.polylines.empty();
  const auto turnOver = [](Piece& piece) { piece.mirrored = !piece.mirrored; };
  Home next = home;
  // One piece changes its own hands where it stands; so do doors and windows, which their walls hold.
  if (!others && units.size() == 1 && elements.groups.empty()) {
    changeEach(next.openings, elements.openings, turnOver);
    changeEach(next.furniture, elements.furniture, turnOver);
    return next;
  }
  Elements all = withGroups(home, elements);
  const std::set<WallId> walls = setOf(all.walls);
  Elements held;
  std::erase_if(all.openings, [&](OpeningId id) {
    const Opening* opening = home.openings.find(id);
    if (!opening || !opening->wall || walls.contains(opening->wall)) return false;
    held.openings.push_back(id);
    return true;
  });
  const Box2 box = planBounds(home, all);
  if (!box.empty()) next = moved(home, all, Motion{.about = (box.min + box.max) / 2, .mirrored = true});
  changeEach(next.openings, held.openings, turnOver);
  return next;
}

Home flipPlan(const Home& home, bool horizontally) {
  const Elements all = allElements(home);
  // About the middle of the building, so that it stays where it is however its windows stick out.
  Elements building;
  building.walls = all.walls;
  building.rooms = all.rooms;
  Box2 box = planBounds(home, building);
  if (box.empty()) box = planBounds(home, all);
  if (box.empty()) return home;
  Motion motion{.about = (box.min + box.max) / 2, .mirrored = true};
  // Top and bottom exchanged: left and right, and half a turn.
  if (!horizontally) motion.angle = kPi;
  Home next = moved(home, all, motion);
  for (std::optional<Camera>* view : {&next.observer, &next.aerial})
    if (*view) motion(**view);
  next.site.compassPosition = motion(home.site.compassPosition);
  return next;
}

}  // namespace idap
