#include "editor/tools/element_shape.h"

#include "model/wall_path.h"

namespace idap {

namespace {

PreviewShape boxOf(const Home& home, Plane plane, AnyId id) {
  const Box3 box = bounds(home, only(id));
  if (box.empty()) return {};
  const Vec2 low = project(plane, box.min), high = project(plane, box.max);
  return {{low, {high.x, low.y}, high, {low.x, high.y}}, true, true};
}

template <class T>
PreviewShape ofPiece(const Home& home, Plane plane, const T* piece) {
  if (!piece) return {};
  return {outline(plane, *piece, elevationOf(home, piece->level)), true, true};
}

}  // namespace

PreviewShape shapeOf(const Home& home, Plane plane, AnyId id) {
  if (const auto* furniture = std::get_if<FurnitureId>(&id))
    return ofPiece(home, plane, home.furniture.find(*furniture));
  if (const auto* opening = std::get_if<OpeningId>(&id))
    return ofPiece(home, plane, home.openings.find(*opening));
  if (plane == Plane::XY) {
    if (const auto* room = std::get_if<RoomId>(&id))
      if (const Room* found = home.rooms.find(*room)) return {found->points, true, true};
    if (const auto* line = std::get_if<PolylineId>(&id))
      if (const Polyline* found = home.polylines.find(*line)) return {found->points, found->closed, false};
    if (const auto* wall = std::get_if<WallId>(&id))
      if (const Wall* found = home.walls.find(*wall)) {
        const WallPath path(*found);
        std::vector<Vec2> points = path.face(found->thickness / 2);
        const std::vector<Vec2> right = path.face(-found->thickness / 2);
        points.insert(points.end(), right.rbegin(), right.rend());
        return {std::move(points), true, true};
      }
  }
  return boxOf(home, plane, id);
}

}  // namespace idap
