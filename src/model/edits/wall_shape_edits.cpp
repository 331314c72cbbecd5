#include "model/edits/wall_shape_edits.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/error.h"
#include "model/edits/wall_ends.h"
#include "model/edits/wall_move.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kFarthestCorner = 100;  // m that a wall is prolonged at most
constexpr double kMostCutOff = 0.5;      // m of a wall that joining takes away at most

const Wall& existing(const Home& home, WallId id) {
  if (const Wall* wall = home.walls.find(id)) return *wall;
  throw InvalidHome("wall " + std::to_string(id.value) + " does not exist");
}

// The line or circle that a wall's centre line is part of.
struct Carrier {
  Vec2 point, direction;  // of a line
  Vec2 centre;            // of a circle
  double radius = 0;      // 0: a line
};
Carrier carrierOf(const Wall& wall) {
  const WallPath path(wall);
  Carrier carrier{wall.start, path.direction(0), {}, 0};
  if (wall.arcExtent == 0) return carrier;
  carrier.radius = path.length() / std::abs(wall.arcExtent);
  carrier.centre =
      wall.start + perpendicular(carrier.direction) * std::copysign(carrier.radius, wall.arcExtent);
  return carrier;
}

std::vector<Vec2> meetings(const Carrier& a, const Carrier& b) {
  if (a.radius == 0 && b.radius == 0) {
    const double turn = cross(a.direction, b.direction);
    if (std::abs(turn) < 1e-4) return {};
    return {a.point + a.direction * (cross(b.point - a.point, b.direction) / turn)};
  }
  if (b.radius == 0) return meetings(b, a);
  if (a.radius == 0) {
    const double along = dot(b.centre - a.point, a.direction);
    const Vec2 foot = a.point + a.direction * along;
    const double rest = b.radius * b.radius - dot(b.centre - foot, b.centre - foot);
    if (rest < 0) return {};
    return {foot + a.direction * std::sqrt(rest), foot - a.direction * std::sqrt(rest)};
  }
  const Vec2 between = b.centre - a.centre;
  const double distance = length(between);
  if (distance < 1e-9) return {};
  const double along = (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2 * distance);
  const double rest = a.radius * a.radius - along * along;
  if (rest < 0) return {};
  const Vec2 unit = between / distance, foot = a.centre + unit * along;
  return {foot + perpendicular(unit) * std::sqrt(rest), foot - perpendicular(unit) * std::sqrt(rest)};
}

// The middle of the gap between two ends of walls in one line.
std::optional<Vec2> inLine(const Carrier& a, const Carrier& b, Vec2 endOfA, Vec2 endOfB) {
  if (a.radius != 0 || b.radius != 0) return std::nullopt;
  if (std::abs(cross(a.direction, b.direction)) > 1e-3) return std::nullopt;
  if (std::abs(cross(endOfB - endOfA, a.direction)) > 5e-3) return std::nullopt;
  return (endOfA + endOfB) / 2;
}

// m from an end of a wall to a point of it; negative beyond the end.
double inside(const Wall& wall, WallEnd end, Vec2 p) {
  const WallPath path(wall);
  const double distance = path.nearest(p);
  if (length(path.point(distance) - p) > kSamePlace) return -1;
  return end == WallEnd::Start ? distance : path.length() - distance;
}

// A round wall stays on its circle when an end of it moves along that.
double sweepBetween(const Wall& wall, Vec2 start, Vec2 end) {
  const Carrier carrier = carrierOf(wall);
  const Vec2 a = start - carrier.centre, b = end - carrier.centre;
  double sweep = std::atan2(cross(a, b), dot(a, b));
  if (wall.arcExtent > 0 && sweep < 0) sweep += 2 * kPi;
  if (wall.arcExtent < 0 && sweep > 0) sweep -= 2 * kPi;
  return sweep;
}

Home endAt(const Home& home, WallId id, WallEnd end, Vec2 p) {
  const Wall before = existing(home, id);
  Home next = moveWallEnd(home, id, end, p);
  if (before.arcExtent == 0) return next;
  Wall wall = *next.walls.find(id);
  wall.arcExtent = sweepBetween(before, wall.start, wall.end);
  return replaceWall(next, id, wall, otherEnd(end));
}

// Corners of the outline moved outwards; empty where that is not simply done.
Polygon widened(const Polygon& ring, double distance) {
  Polygon wide;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = normalized(ring[i] - ring[(i + n - 1) % n]),
               out = normalized(ring[(i + 1) % n] - ring[i]);
    const double half = 1 + dot(in, out);
    if (half < 0.1) return {};
    wide.push_back(ring[i] - perpendicular(in + out) * (distance / half));
  }
  for (std::size_t i = 0; i < n; ++i)
    if (dot(wide[(i + 1) % n] - wide[i], ring[(i + 1) % n] - ring[i]) <= 0) return {};
  return wide;
}

// Counter-clockwise, without points that make no corner.
Polygon cleanRing(const Polygon& points) {
  Polygon ring;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 before = points[(i + n - 1) % n], p = points[i];
    if (length(p - before) > kSamePlace) ring.push_back(p);
  }
  Polygon corners;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[(i + ring.size() - 1) % ring.size()], p = ring[i], b = ring[(i + 1) % ring.size()];
    if (std::abs(cross(normalized(p - a), normalized(b - p))) > 1e-6 || dot(p - a, b - p) < 0)
      corners.push_back(p);
  }
  if (signedArea(corners) < 0) std::reverse(corners.begin(), corners.end());
  return corners;
}

// A wall stands all along this line already.
bool standsThere(const Home& home, const Wall& wall) {
  return std::any_of(home.walls.begin(), home.walls.end(), [&wall](const auto& entry) {
    const Wall& other = *entry.second;
    if (other.level != wall.level) return false;
    const WallPath path(other);
    const double reach = (other.thickness + wall.thickness) / 2;
    const auto near = [&](Vec2 p) { return length(path.point(path.nearest(p)) - p) < reach; };
    const double inner = std::min(0.25, wall.thickness / length(wall.end - wall.start));
    const Vec2 along = wall.end - wall.start;
    return near(wall.start + along * inner) && near((wall.start + wall.end) / 2) &&
           near(wall.end - along * inner);
  });
}

}  // namespace

Home joinWalls(const Home& home, WallId firstId, WallId secondId) {
  const Wall first = existing(home, firstId), second = existing(home, secondId);
  if (firstId == secondId) throw InvalidHome("a wall cannot be joined to itself");
  if (first.level != second.level) throw InvalidHome("these walls stand on different levels");
  if ((first.neighbourAtStart == secondId || first.neighbourAtEnd == secondId) &&
      (second.neighbourAtStart == firstId || second.neighbourAtEnd == firstId))
    return home;
  using Choice = std::tuple<bool, double, WallEnd, WallEnd>;
  std::vector<Choice> choices;
  for (const WallEnd a : {WallEnd::Start, WallEnd::End})
    for (const WallEnd b : {WallEnd::Start, WallEnd::End})
      choices.emplace_back(neighbour(first, a) || neighbour(second, b),
                           length(endPoint(first, a) - endPoint(second, b)), a, b);
  const auto [taken, gap, a, b] = *std::min_element(choices.begin(), choices.end());
  const Vec2 endA = endPoint(first, a), endB = endPoint(second, b);
  const Carrier lineA = carrierOf(first), lineB = carrierOf(second);
  std::optional<Vec2> corner = inLine(lineA, lineB, endA, endB);
  for (const Vec2 p : meetings(lineA, lineB))
    if (!corner || length(p - (endA + endB) / 2) < length(*corner - (endA + endB) / 2)) corner = p;
  if (!corner || std::min(length(*corner - endA), length(*corner - endB)) > kFarthestCorner)
    throw InvalidHome("these walls run beside each other and cannot meet");
  const bool firstStays = inside(first, a, *corner) > kMostCutOff;
  const bool secondStays = inside(second, b, *corner) > kMostCutOff;
  if (firstStays && secondStays) throw InvalidHome("these walls cross each other: split one of them first");
  Home next = home;
  if (!firstStays) next = endAt(next, firstId, a, *corner);
  if (!secondStays) next = endAt(next, secondId, b, *corner);
  if (firstStays || secondStays) return next;
  Wall joinedFirst = *next.walls.find(firstId), joinedSecond = *next.walls.find(secondId);
  if (neighbour(joinedFirst, a) || neighbour(joinedSecond, b)) return next;
  neighbour(joinedFirst, a) = secondId;
  neighbour(joinedSecond, b) = firstId;
  next.walls.set(firstId, joinedFirst);
  next.walls.set(secondId, joinedSecond);
  return next;
}

Home reverseWall(const Home& home, WallId id) {
  Wall wall = existing(home, id);
  std::swap(wall.start, wall.end);
  std::swap(wall.heightAtStart, wall.heightAtEnd);
  std::swap(wall.left, wall.right);
  std::swap(wall.neighbourAtStart, wall.neighbourAtEnd);
  wall.arcExtent = -wall.arcExtent;
  Home next = home;
  next.walls.set(id, std::move(wall));
  return next;
}

Home bendWall(const Home& home, WallId id, Vec2 through) {
  const Wall& straight = existing(home, id);
  Wall wall = straight;
  const Vec2 chord = wall.end - wall.start;
  const double c = length(chord);
  const double sagitta = dot(through - (wall.start + wall.end) / 2, perpendicular(chord / c));
  // The half chord is seen from the far end of the diameter under a quarter of the sweep.
  wall.arcExtent = std::abs(sagitta) <= kSamePlace
                       ? 0
                       : std::clamp(-4 * std::atan2(2 * sagitta, c), -1.9 * kPi, 1.9 * kPi);
  const WallPath from(straight), to(wall);
  // Doors and windows keep their share of the length.
  Home next = home;
  next.walls.set(id, wall);
  for (const auto& [openingId, opening] : home.openings)
    if (opening->wall == id) {
      const double at = from.nearest({opening->position.x, opening->position.y});
      next.openings.set(openingId, carried(*opening, from, to, at / from.length() * to.length()));
    }
  return next;
}

Home moveCorner(const Home& home, LevelId level, Vec2 corner, Vec2 to) {
  WallMove move(home);
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != level) continue;
    for (const WallEnd end : {WallEnd::Start, WallEnd::End})
      if (samePlace(endPoint(*wall, end), corner)) move.set(id, end, to);
  }
  return followWalls(home, move.applied(), level, false);
}

Home moveWall(const Home& home, WallId id, Vec2 start, Vec2 end) {
  WallMove move(home);
  move.set(id, WallEnd::Start, start);
  move.set(id, WallEnd::End, end);
  return followWalls(home, move.applied(), existing(home, id).level, false);
}

Home wallsAroundRoom(const Home& home, RoomId id, double thickness, double height) {
  const Room* room = home.rooms.find(id);
  if (!room) throw InvalidHome("room " + std::to_string(id.value) + " does not exist");
  Polygon ring = widened(cleanRing(room->points), thickness / 2);
  if (ring.size() < 3)
    if (const Regions wide = buffer(repair(room->points), thickness / 2); !wide.empty())
      ring = cleanRing(wide.front().outer);
  if (ring.size() < 3) throw InvalidHome("this room has no outline to put walls along");
  Home next = home;
  const std::size_t n = ring.size();
  std::vector<WallId> ids(n);
  std::vector<Wall> walls(n);
  for (std::size_t i = 0; i < n; ++i) {
    walls[i].level = room->level;
    walls[i].start = ring[i];
    walls[i].end = ring[(i + 1) % n];
    walls[i].thickness = thickness;
    walls[i].heightAtStart = walls[i].heightAtEnd = height;
    if (!standsThere(home, walls[i])) ids[i] = next.newId<WallId>();
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!ids[i]) continue;
    walls[i].neighbourAtStart = ids[(i + n - 1) % n];
    walls[i].neighbourAtEnd = ids[(i + 1) % n];
    next.walls.set(ids[i], walls[i]);
  }
  return next;
}

}  // namespace idap
