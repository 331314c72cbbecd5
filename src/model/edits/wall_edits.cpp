#include "model/edits/wall_edits.h"

#include <algorithm>

#include "base/error.h"
#include "model/edits/wall_ends.h"
#include "model/edits/wall_move.h"
#include "model/wall_path.h"

namespace idap {

namespace {

const Wall& existing(const Home& home, WallId id) {
  if (const Wall* wall = home.walls.find(id)) return *wall;
  throw InvalidHome("wall " + std::to_string(id.value) + " does not exist");
}

double angleOf(Vec2 direction) { return std::atan2(direction.y, direction.x); }

Opening moved(const Opening& opening, const WallPath& from, const WallPath& to, WallEnd anchor) {
  const double distance = from.nearest({opening.position.x, opening.position.y});
  return carried(opening, from, to,
                 anchor == WallEnd::Start ? distance : to.length() - (from.length() - distance));
}

}  // namespace

Opening carried(const Opening& opening, const WallPath& from, const WallPath& to, double distance) {
  const Vec2 at{opening.position.x, opening.position.y};
  const double was = from.nearest(at);
  const Vec2 before = from.direction(was);
  const double offset = dot(at - from.point(was), perpendicular(before));
  const double half = std::min(opening.size.x / 2, to.length() / 2);
  distance = std::clamp(distance, half, to.length() - half);
  const Vec2 after = to.direction(distance);
  const Vec2 place = to.point(distance) + perpendicular(after) * offset;
  Opening result = opening;
  result.position = {place.x, place.y, opening.position.z};
  const double turn = angleOf(after) - angleOf(before);
  if (turn != 0) result.angle = std::remainder(opening.angle + turn, 2 * kPi);
  return result;
}

Home replaceWall(const Home& home, WallId id, const Wall& wall, WallEnd anchor) {
  const WallPath from(existing(home, id)), to(wall);
  Home next = home;
  next.walls.set(id, wall);
  for (const auto& [openingId, opening] : home.openings)
    if (opening->wall == id) next.openings.set(openingId, moved(*opening, from, to, anchor));
  return next;
}

WallEdit addWall(const Home& home, Wall wall) {
  Home next = home;
  const auto id = next.newId<WallId>();
  for (const auto& [otherId, found] : home.walls) {
    if (found->level != wall.level) continue;
    Wall other = *found;
    bool joined = false;
    for (const WallEnd mine : {WallEnd::Start, WallEnd::End})
      for (const WallEnd its : {WallEnd::Start, WallEnd::End}) {
        if (neighbour(wall, mine) || neighbour(other, its)) continue;
        if (length(endPoint(wall, mine) - endPoint(other, its)) > kSamePlace) continue;
        neighbour(wall, mine) = otherId;
        neighbour(other, its) = id;
        joined = true;
      }
    if (joined) next.walls.set(otherId, other);
  }
  next.walls.set(id, std::move(wall));
  return {std::move(next), id};
}

Home moveWallEnd(const Home& home, WallId id, WallEnd end, Vec2 to) {
  WallMove move(home);
  move.set(id, end, to);
  return move.applied();
}

WallEdit splitWall(const Home& home, WallId id, double distance) {
  const Wall& whole = existing(home, id);
  const WallPath path(whole);
  if (!(distance > kSamePlace && distance < path.length() - kSamePlace))
    throw InvalidHome("wall " + std::to_string(id.value) + " cannot be cut at its end");
  const double share = distance / path.length();
  const double height = whole.heightAtStart + (whole.heightAtEnd - whole.heightAtStart) * share;
  Home next = home;
  const auto secondId = next.newId<WallId>();
  Wall first = whole, second = whole;
  first.end = second.start = path.point(distance);
  first.arcExtent = whole.arcExtent * share;
  second.arcExtent = whole.arcExtent * (1 - share);
  first.heightAtEnd = second.heightAtStart = height;
  first.neighbourAtEnd = secondId;
  second.neighbourAtStart = id;
  next.walls.set(id, first);
  next.walls.set(secondId, second);
  if (const Wall* far = home.walls.find(whole.neighbourAtEnd)) {
    Wall changed = *far;
    // Only its end at the far end of the whole wall: the two may meet at both ends.
    const bool atStart = length(changed.start - whole.end) <= length(changed.end - whole.end);
    if (WallId& link = atStart ? changed.neighbourAtStart : changed.neighbourAtEnd; link == id)
      link = secondId;
    next.walls.set(whole.neighbourAtEnd, changed);
  }
  for (const auto& [openingId, opening] : home.openings) {
    if (opening->wall != id || path.nearest({opening->position.x, opening->position.y}) <= distance) continue;
    Opening changed = *opening;
    changed.wall = secondId;
    next.openings.set(openingId, std::move(changed));
  }
  return {std::move(next), secondId};
}

}  // namespace idap
