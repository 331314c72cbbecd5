#include "model/edits/motion.h"

#include <algorithm>
#include <set>
#include <utility>

#include "model/edits/table_edits.h"
#include "model/edits/wall_move.h"
#include "model/wall_outline.h"

namespace idap {

namespace {

// Text is never mirrored, and never ends on its head: it goes on from the other side of its place.
double turnedText(const Motion& motion, double angle) {
  const double turned = motion.turned(angle);
  if (!motion.mirrored || std::cos(turned) * std::cos(angle) >= 0) return turned;
  return std::remainder(turned + kPi, 2 * kPi);
}
void turnText(const Motion& motion, double& angle, TextStyle& style) {
  const Vec2 before{std::cos(angle), std::sin(angle)};
  angle = turnedText(motion, angle);
  const Vec2 after{std::cos(angle), std::sin(angle)};
  if (!motion.mirrored || dot(motion.vector(before), after) >= 0) return;
  if (style.alignment == TextAlignment::Left)
    style.alignment = TextAlignment::Right;
  else if (style.alignment == TextAlignment::Right)
    style.alignment = TextAlignment::Left;
}

}  // namespace

Vec2 Motion::vector(Vec2 v) const {
  if (mirrored) v.x = -v.x;
  return angle == 0 ? v : rotated(v, angle);
}

Vec2 Motion::operator()(Vec2 p) const {
  // A plain shift stays exact.
  if (angle == 0 && !mirrored) return p + by;
  return about + vector(p - about) + by;
}

Vec3 Motion::operator()(Vec3 p) const {
  const Vec2 q = (*this)(Vec2{p.x, p.y});
  return {q.x, q.y, p.z + rise};
}

void Motion::operator()(Piece& piece) const {
  piece.position = (*this)(piece.position);
  piece.angle = turned(piece.angle);
  if (!mirrored) return;
  piece.roll = -piece.roll;
  piece.mirrored = !piece.mirrored;
}

void Motion::operator()(Wall& wall) const {
  wall.start = (*this)(wall.start);
  wall.end = (*this)(wall.end);
  if (!mirrored) return;
  wall.arcExtent = -wall.arcExtent;
  std::swap(wall.left, wall.right);
}

void Motion::operator()(Room& room) const {
  for (Vec2& p : room.points) p = (*this)(p);
  if (mirrored) std::reverse(room.points.begin(), room.points.end());
  if (angle == 0 && !mirrored) return;
  room.nameOffset = vector(room.nameOffset);
  room.areaOffset = vector(room.areaOffset);
  if (!mirrored) return;
  turnText(*this, room.nameAngle, room.nameStyle);
  turnText(*this, room.areaAngle, room.areaStyle);
}

void Motion::operator()(Camera& camera) const {
  camera.eye = (*this)(camera.eye);
  camera.yaw = turned(camera.yaw);
}

void Motion::operator()(Dimension& dimension) const {
  dimension.start = (*this)(dimension.start);
  dimension.end = (*this)(dimension.end);
  if (mirrored) dimension.offset = -dimension.offset;
}

void Motion::operator()(Label& label) const {
  label.position = (*this)(label.position);
  turnText(*this, label.angle, label.style);
}

void Motion::operator()(Polyline& line) const {
  for (Vec2& p : line.points) p = (*this)(p);
}

Home moved(const Home& home, const Elements& listed, const Motion& motion) {
  Home next = home;
  if (!listed.walls.empty()) {
    WallMove walls(home);
    walls.move(listed.walls, motion);
    next = walls.applied();
  }
  const std::set<WallId> walls = setOf(listed.walls);
  changeEach(next.openings, listed.openings, [&](Opening& opening) {
    // One in a wall that moves has moved with it already.
    if (opening.wall && walls.contains(opening.wall))
      opening.position.z += motion.rise;
    else
      motion(opening);
  });
  changeEach(next.furniture, listed.furniture, motion);
  changeEach(next.rooms, listed.rooms, motion);
  changeEach(next.cameras, listed.cameras, motion);
  changeEach(next.dimensions, listed.dimensions, motion);
  changeEach(next.labels, listed.labels, motion);
  changeEach(next.polylines, listed.polylines, motion);
  return next;
}

Box2 planBounds(const Home& home, const Elements& listed) {
  Box2 box;
  const auto each = [](const auto& table, const auto& ids, auto add) {
    for (const auto id : ids)
      if (const auto* found = table.find(id)) add(*found);
  };
  const auto addAll = [&box](const auto& points) {
    for (const Vec2 p : points) box.add(p);
  };
  const auto addPiece = [&](const Piece& piece) { addAll(footprint(piece)); };
  each(home.walls, listed.walls, [&](const Wall& wall) { addAll(wallCentreLine(wall)); });
  each(home.rooms, listed.rooms, [&](const Room& room) { addAll(room.points); });
  each(home.openings, listed.openings, addPiece);
  each(home.furniture, listed.furniture, addPiece);
  each(home.cameras, listed.cameras, [&](const Camera& c) { box.add(Vec2{c.eye.x, c.eye.y}); });
  each(home.dimensions, listed.dimensions, [&](const Dimension& d) {
    box.add(d.start);
    box.add(d.end);
  });
  each(home.labels, listed.labels, [&](const Label& label) { box.add(label.position); });
  each(home.polylines, listed.polylines, [&](const Polyline& line) { addAll(line.points); });
  return box;
}

}  // namespace idap
