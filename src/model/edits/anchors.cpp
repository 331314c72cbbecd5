#include "model/edits/anchors.h"

#include <set>

#include "model/edits/piece_edits.h"
#include "model/edits/wall_ends.h"
#include "model/wall_outline.h"
#include "model/wall_path.h"

namespace idap {

namespace {

// The corners of a piece, the middles of its sides, and its own.
std::vector<Vec2> pointsOf(const Piece& piece) {
  const auto corners = footprint(piece);
  std::vector<Vec2> points(corners.begin(), corners.end());
  for (std::size_t i = 0; i < 4; ++i) points.push_back((corners[i] + corners[(i + 1) % 4]) / 2);
  points.push_back({piece.position.x, piece.position.y});
  return points;
}

std::vector<Vec2> pointsOf(const Home& home, WallId id, const Wall& wall) {
  const WallOutline outline = wallOutline(home, id, wall);
  return {wall.start,          wall.end, outline.left.front(), outline.left.back(), outline.right.front(),
          outline.right.back()};
}

// Where a point on a wall's face or centre line is when the wall is another.
std::optional<Vec2> onFace(const Wall& before, const Wall& after, Vec2 point) {
  const WallPath from(before), to(after);
  const double distance = from.nearest(point);
  const double offset = dot(point - from.point(distance), perpendicular(from.direction(distance)));
  if (length(point - from.point(distance)) > std::abs(offset) + kSamePlace) return std::nullopt;
  const double half = before.thickness / 2;
  const bool onLine = std::abs(offset) <= kSamePlace;
  if (!onLine && std::abs(std::abs(offset) - half) > kSamePlace) return std::nullopt;
  const double side = onLine ? 0 : offset > 0 ? after.thickness / 2 : -after.thickness / 2;
  const Vec2 shift = after.start - before.start;
  const bool shifted = length((after.end - before.end) - shift) < 1e-9 && after.arcExtent == before.arcExtent;
  double at = distance / from.length() * to.length();
  // A wall that was only prolonged or pushed leaves the point where it stood along it.
  if (shifted)
    at = distance;
  else if (before.arcExtent == 0 && after.arcExtent == 0)
    at = to.nearest(point);
  return to.point(at) + perpendicular(to.direction(at)) * side;
}

}  // namespace

Anchors::Anchors(const Home& before, const Home& after) {
  const HomeDiff changed = diff(before, after);
  addWalls(before, after, changed.walls.changed);
  const auto add = [this](LevelId level, const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
    if (from.size() != to.size()) return;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (from[i] != to[i]) corners_.push_back({level, from[i], to[i]});
  };
  for (const FurnitureId id : changed.furniture.changed) {
    const Furniture& was = *before.furniture.find(id);
    add(was.level, pointsOf(was), pointsOf(*after.furniture.find(id)));
  }
  for (const OpeningId id : changed.openings.changed) {
    const Opening& was = *before.openings.find(id);
    add(was.level, pointsOf(was), pointsOf(*after.openings.find(id)));
  }
  for (const RoomId id : changed.rooms.changed) {
    const Room& was = *before.rooms.find(id);
    add(was.level, was.points, after.rooms.find(id)->points);
  }
}

void Anchors::addWalls(const Home& before, const Home& after, const std::vector<WallId>& changed) {
  // A wall that only got another neighbour or finish stands where it stood.
  std::vector<WallId> moved;
  for (const WallId id : changed) {
    const Wall &was = *before.walls.find(id), &is = *after.walls.find(id);
    if (was.start != is.start || was.end != is.end || was.arcExtent != is.arcExtent ||
        was.thickness != is.thickness)
      moved.push_back(id);
  }
  // The corners of a wall move with its neighbours too.
  std::set<WallId> touched(moved.begin(), moved.end());
  for (const WallId id : moved)
    for (const Wall* wall : {before.walls.find(id), after.walls.find(id)}) {
      touched.insert(wall->neighbourAtStart);
      touched.insert(wall->neighbourAtEnd);
    }
  for (const WallId id : touched) {
    const Wall *was = before.walls.find(id), *is = after.walls.find(id);
    if (!was || !is) continue;
    const std::vector<Vec2> from = pointsOf(before, id, *was), to = pointsOf(after, id, *is);
    for (std::size_t i = 0; i < from.size(); ++i)
      if (from[i] != to[i]) wallCorners_.push_back({was->level, from[i], to[i]});
  }
  for (const WallId id : moved) walls_.push_back({*before.walls.find(id), *after.walls.find(id)});
}

std::optional<Vec2> Anchors::nearest(const std::vector<Moved>& points, LevelId level, Vec2 point) {
  std::optional<Vec2> best;
  double reach = kSamePlace;
  for (const Moved& moved : points)
    if (const double distance = length(moved.from - point); moved.level == level && distance <= reach) {
      reach = distance;
      best = moved.to;
    }
  return best;
}

std::optional<Vec2> Anchors::wallCorner(LevelId level, Vec2 point) const {
  return nearest(wallCorners_, level, point);
}

std::optional<Vec2> Anchors::any(LevelId level, Vec2 point) const {
  if (const auto corner = nearest(corners_, level, point)) return corner;
  if (const auto corner = nearest(wallCorners_, level, point)) return corner;
  for (const MovedWall& wall : walls_)
    if (wall.before.level == level)
      if (const auto place = onFace(wall.before, wall.after, point)) return place;
  return std::nullopt;
}

Home dimensionsFollow(const Home& before, const Home& after) {
  if (after.dimensions.empty()) return after;
  const Anchors anchors(before, after);
  if (anchors.empty()) return after;
  Home next = after;
  for (const auto& [id, dimension] : after.dimensions) {
    // One that the edit moved itself is where it should be.
    const Dimension* was = before.dimensions.find(id);
    if (!was || was->start != dimension->start || was->end != dimension->end) continue;
    const auto start = anchors.any(dimension->level, dimension->start);
    const auto end = anchors.any(dimension->level, dimension->end);
    if (!start && !end) continue;
    Dimension moved = *dimension;
    if (start) moved.start = *start;
    if (end) moved.end = *end;
    next.dimensions.set(id, std::move(moved));
  }
  return next;
}

}  // namespace idap
