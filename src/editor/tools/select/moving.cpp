#include "editor/tools/select/moving.h"

#include <algorithm>

#include "model/edits/wall_shape_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

bool joined(const Home& home, const Wall& wall) {
  return home.walls.contains(wall.neighbourAtStart) || home.walls.contains(wall.neighbourAtEnd);
}

// Where the end of a wall that moved across itself meets the line of the neighbour there.
Vec2 newCorner(const Home& home, const Wall& wall, WallId id, WallId neighbour, Vec2 corner, Vec2 by) {
  const Wall* other = home.walls.find(neighbour);
  if (!other || neighbour == id || other->arcExtent != 0) return corner + by;
  const Vec2 along = wall.end - wall.start, its = other->end - other->start;
  const double sine = cross(along, its);
  if (std::abs(sine) < 0.1 * length(along) * length(its)) return corner + by;
  // corner + by + along * s lies on corner + its * t
  const double t = cross(along, by) / sine;
  return corner + its * t;
}

Home moveAcross(const Home& home, WallId id, const Wall& wall, Vec2 by) {
  const Vec2 start = newCorner(home, wall, id, wall.neighbourAtStart, wall.start, by);
  const Vec2 end = newCorner(home, wall, id, wall.neighbourAtEnd, wall.end, by);
  return moveWall(home, id, start, end);
}

Opening slid(const Opening& opening, const Wall& wall, Vec3 by) {
  const WallPath path(wall);
  const Vec2 at{opening.position.x, opening.position.y};
  const double from = path.nearest(at);
  const double half = std::min(opening.size.x, path.length()) / 2;
  const double to =
      std::clamp(from + dot(Vec2{by.x, by.y}, path.direction(from)), half, path.length() - half);
  const Vec2 before = path.direction(from), after = path.direction(to);
  const Vec2 off = at - path.point(from);
  const double turn = std::atan2(cross(before, after), dot(before, after));
  const Vec2 place = path.point(to) + rotated(off, turn);
  Opening next = opening;
  next.position = {place.x, place.y, opening.position.z + by.z};
  if (turn != 0) next.angle = std::remainder(opening.angle + turn, 2 * kPi);
  return next;
}

}  // namespace

Elements movable(const Home& home, const Elements& elements) {
  Elements free = elements;
  const auto dropLocked = [&](const auto& table, auto& ids) {
    std::erase_if(ids, [&table](auto id) {
      const auto* piece = table.find(id);
      return !piece || piece->locked;
    });
  };
  dropLocked(home.furniture, free.furniture);
  dropLocked(home.openings, free.openings);
  std::erase_if(free.groups, [&home](GroupId group) {
    const Elements members = withGroups(home, only(group));
    return std::any_of(members.furniture.begin(), members.furniture.end(),
                       [&](FurnitureId id) { return home.furniture.find(id)->locked; }) ||
           std::any_of(members.openings.begin(), members.openings.end(),
                       [&](OpeningId id) { return home.openings.find(id)->locked; });
  });
  return free;
}

std::optional<Vec2> wallNormal(const Home& home, const Elements& elements) {
  if (elements.walls.size() != 1 || count(elements) != 1) return {};
  const Wall* wall = home.walls.find(elements.walls.front());
  if (!wall || wall->arcExtent != 0 || !joined(home, *wall)) return {};
  return perpendicular(normalized(wall->end - wall->start));
}

Home moved(const Home& home, const Elements& elements, Vec3 by) {
  if (const auto normal = wallNormal(home, elements)) {
    const WallId id = elements.walls.front();
    return moveAcross(home, id, *home.walls.find(id), *normal * dot(*normal, Vec2{by.x, by.y}));
  }
  Elements rest = elements;
  Home next = home;
  std::erase_if(rest.openings, [&](OpeningId id) {
    const Opening* opening = home.openings.find(id);
    if (!opening) return true;
    const Wall* wall = home.walls.find(opening->wall);
    if (!wall || contains(elements, opening->wall)) return false;
    next.openings.set(id, slid(*opening, *wall, by));
    return true;
  });
  return moveElements(next, rest, by);
}

Piece boxPiece(const Home& home, const Elements& elements) {
  const Box3 box = bounds(home, elements);
  Piece piece;
  if (box.empty()) return piece;
  const Elements all = withGroups(home, elements);
  if (!all.furniture.empty())
    piece.level = home.furniture.find(all.furniture.front())->level;
  else if (!all.openings.empty())
    piece.level = home.openings.find(all.openings.front())->level;
  piece.position = {box.centre().x, box.centre().y, box.min.z - elevationOf(home, piece.level)};
  piece.size = {std::max(box.size().x, 1e-3), std::max(box.size().y, 1e-3), std::max(box.size().z, 1e-3)};
  return piece;
}

}  // namespace idap
