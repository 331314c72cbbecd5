#include "editor/tools/arrange/room_space.h"

#include <algorithm>
#include <cmath>

#include "model/room_geometry.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kSlack = 0.01;        // m that things may share: skirting boards, cushions
constexpr double kPassage = 0.7;       // m one needs before an opening without leaves
constexpr double kWindowDepth = 0.25;  // m before a window
constexpr double kFlat = 0.06;         // m: lower things are walked and stood on
constexpr double kOpenField = 8;       // m, side of the square that stands in for a room

bool separated(const Corners& a, const Corners& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 edge = a[(i + 1) % 4] - a[i];
    const double size = length(edge);
    if (size < 1e-9) continue;
    const Vec2 outward = -perpendicular(edge) / size;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2 p : b) nearest = std::min(nearest, dot(p - a[i], outward));
    if (nearest > -kSlack) return true;
  }
  return false;
}

bool crosses(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double ab1 = cross(b - a, c - a), ab2 = cross(b - a, d - a);
  const double cd1 = cross(d - c, a - c), cd2 = cross(d - c, b - c);
  return ab1 * ab2 < 0 && cd1 * cd2 < 0;
}

Box2 boxOf(const Corners& corners) {
  Box2 box;
  for (const Vec2 p : corners) box.add(p);
  return box;
}

RoomSpace::Standing standing(FurnitureId id, const Furniture& piece) {
  const Corners corners = footprint(piece);
  RoomSpace::Standing made{id, &piece, corners, boxOf(corners), mannerOf(piece), wordsOf(piece), {}};
  if (made.manner == Manner::Storage || made.manner == Manner::Desk || made.manner == Manner::Screen)
    made.before = placeBefore({piece.position.x, piece.position.y}, piece.size, piece.angle);
  return made;
}

RoomSpace::Hole hole(OpeningId id, const Opening& opening) {
  const bool way = opening.kind != OpeningKind::Window || opening.position.z < 0.2;
  double reach = way ? kPassage : kWindowDepth;
  if (way)
    for (const Sash& sash : opening.sashes) reach = std::max(reach, sash.width * opening.size.x);
  const Vec2 middle{opening.position.x, opening.position.y};
  const auto before = [&](double depth) {
    return rectangle(middle, {opening.size.x, opening.size.y + 2 * depth}, opening.angle);
  };
  return {id, &opening, way, before(reach), before(reach / 2)};
}

}  // namespace

Corners rectangle(Vec2 middle, Vec2 size, double angle) {
  const Vec2 right = rotated(Vec2{size.x / 2, 0}, angle), back = rotated(Vec2{0, size.y / 2}, angle);
  return {middle - right - back, middle + right - back, middle + right + back, middle - right + back};
}

Corners placeBefore(Vec2 middle, Vec3 size, double angle) {
  const Vec2 front = rotated(Vec2{0, -1}, angle);
  return rectangle(middle + front * ((size.y + kBeforeIt) / 2), {size.x * 0.9, kBeforeIt}, angle);
}

bool overlaps(const Corners& a, const Corners& b) { return !separated(a, b) && !separated(b, a); }

bool RoomSpace::holds(const Corners& corners) const {
  // Drawn in a little, so that what touches the walls is inside.
  const Vec2 middle = (corners[0] + corners[2]) / 2;
  Corners inner;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 by = corners[i] - middle;
    const double size = length(by);
    inner[i] = size > 2 * kSlack ? middle + by * ((size - kSlack / 2) / size) : middle;
    if (!contains(area, inner[i])) return false;
  }
  for (std::size_t i = 0; i < area.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      if (crosses(area[i], area[(i + 1) % area.size()], inner[k], inner[(k + 1) % 4])) return false;
  return true;
}

bool RoomSpace::free(const Corners& corners, double low, double high, FurnitureId except) const {
  const Box2 box = boxOf(corners);
  for (const Standing& other : furniture) {
    if (!box.overlaps(other.box) || other.id == except || other.piece->size.z < kFlat) continue;
    const double z = other.piece->position.z;
    if (z >= high - 1e-6 || z + other.piece->size.z <= low + 1e-6) continue;
    if (overlaps(corners, other.corners)) return false;
  }
  return std::none_of(walls.begin(), walls.end(),
                      [&](const Corners& wall) { return overlaps(corners, wall); });
}

bool RoomSpace::freeOnTop(const Corners& corners, double low, double high, FurnitureId table) const {
  const Box2 box = boxOf(corners);
  return std::none_of(furniture.begin(), furniture.end(), [&](const Standing& other) {
    if (!box.overlaps(other.box)) return false;
    const double z = other.piece->position.z;
    return other.id != table && z > low - 0.1 && z < high && z + other.piece->size.z > low + 1e-6 &&
           overlaps(corners, other.corners);
  });
}

bool RoomSpace::blocksWay(const Corners& corners, double low, double high) const {
  return std::any_of(openings.begin(), openings.end(), [&](const Hole& hole) {
    const double z = hole.opening->position.z;
    return hole.way && low < z + hole.opening->size.z && high > z && overlaps(corners, hole.swing);
  });
}

bool RoomSpace::blocksDoorstep(const Corners& corners, double low, double high) const {
  return std::any_of(openings.begin(), openings.end(), [&](const Hole& hole) {
    const double z = hole.opening->position.z;
    return hole.way && low < z + hole.opening->size.z && high > z && overlaps(corners, hole.step);
  });
}

bool RoomSpace::coversWindow(const Corners& corners, double low, double high) const {
  return std::any_of(openings.begin(), openings.end(), [&](const Hole& hole) {
    const double z = hole.opening->position.z;
    return low < z + hole.opening->size.z && high > z + 0.05 && overlaps(corners, hole.swing);
  });
}

RoomSpace roomSpace(const Home& home, LevelId level, std::optional<Vec2> near) {
  RoomSpace space;
  space.level = level;
  std::vector<Polygon> areas = closedAreas(home, level);
  for (const auto& [id, room] : home.rooms)
    if (room->level == level) areas.push_back(room->points);
  // What walls close goes before rooms drawn over them, the smaller before the larger around a point.
  for (const bool around : {true, false}) {
    double best = around ? std::numeric_limits<double>::infinity() : 0;
    for (const Polygon& area : areas) {
      const double size = std::abs(signedArea(area));
      if (around ? !near || !contains(area, *near) || size >= best * (1 - 1e-3) : size <= best * (1 + 1e-3))
        continue;
      best = size;
      space.area = area;
    }
    if (!space.area.empty()) break;
  }
  if (space.area.empty()) {
    space.closed = false;
    const Box3 all = bounds(home, everything(home, level));
    const Vec2 middle = near ? *near : all.empty() ? Vec2{} : Vec2{all.centre().x, all.centre().y};
    const Corners field = rectangle(middle, {kOpenField, kOpenField}, 0);
    space.area.assign(field.begin(), field.end());
  }
  if (signedArea(space.area) < 0) std::reverse(space.area.begin(), space.area.end());

  constexpr double kAround = 1;  // m
  Box2 surroundings = bounds(space.area);
  surroundings.add(surroundings.min - Vec2{kAround, kAround});
  surroundings.add(surroundings.max + Vec2{kAround, kAround});
  for (const auto& [id, piece] : home.furniture)
    if (piece->level == level && surroundings.overlaps(boxOf(footprint(*piece))) && isShown(home, *piece))
      space.furniture.push_back(standing(id, *piece));
  for (const auto& [id, opening] : home.openings)
    if (opening->level == level) space.openings.push_back(hole(id, *opening));
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != level || wall->arcExtent != 0) continue;
    const Vec2 along = wall->end - wall->start;
    space.walls.push_back(rectangle((wall->start + wall->end) / 2, {length(along), wall->thickness},
                                    std::atan2(along.y, along.x)));
  }
  return space;
}

}  // namespace idap
