#include "editor/tools/select/under_pointer.h"

#include <algorithm>

#include "editor/hit_test.h"
#include "model/edits/piece_edits.h"

namespace idap {

namespace {

// The group around the pieces that are selected singly, when the user has gone into one.
GroupId enteredGroup(const Editor& editor) {
  const Elements& selection = editor.selection();
  for (const FurnitureId id : selection.furniture)
    if (const Furniture* piece = editor.home().furniture.find(id); piece && piece->group)
      return outermost(editor.home(), piece->group);
  for (const OpeningId id : selection.openings)
    if (const Opening* piece = editor.home().openings.find(id); piece && piece->group)
      return outermost(editor.home(), piece->group);
  return {};
}

}  // namespace

std::vector<AnyId> meantAt(const Editor& editor, const PointerEvent& event) {
  const GroupId entered = enteredGroup(editor);
  std::vector<AnyId> ids;
  for (const AnyId id : membersAt(editor, event.plane, event.at, kClickReach * event.pixel)) {
    const AnyId whole = byGroup(editor.home(), id);
    const AnyId meant = entered && whole == AnyId(entered) ? id : whole;
    if (std::find(ids.begin(), ids.end(), meant) == ids.end()) ids.push_back(meant);
  }
  return ids;
}

std::optional<std::size_t> ownEdge(const Editor& editor, const PointerEvent& event) {
  const std::optional<AnyId> one = single(editor.selection());
  if (!one || event.plane != Plane::XY) return {};
  const std::vector<Vec2>* points = nullptr;
  bool closed = true;
  if (const auto* room = std::get_if<RoomId>(&*one)) {
    if (const Room* found = editor.home().rooms.find(*room)) points = &found->points;
  } else if (const auto* line = std::get_if<PolylineId>(&*one)) {
    if (const Polyline* found = editor.home().polylines.find(*line)) {
      points = &found->points;
      closed = found->closed;
    }
  }
  if (!points) return {};
  const std::size_t n = points->size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i)
    if (distanceToSegment(event.at, (*points)[i], (*points)[(i + 1) % n]) <= kClickReach * event.pixel)
      return i + 1;
  return {};
}

Home withPoint(const Home& home, AnyId id, std::size_t at, Vec2 point) {
  if (const auto* room = std::get_if<RoomId>(&id)) return addRoomPoint(home, *room, at, point);
  Home next = home;
  const PolylineId lineId = std::get<PolylineId>(id);
  Polyline line = *home.polylines.find(lineId);
  line.points.insert(line.points.begin() + static_cast<std::ptrdiff_t>(at), point);
  next.polylines.set(lineId, std::move(line));
  return next;
}

bool isGround(const Editor& editor, Plane plane, AnyId id) {
  if (std::holds_alternative<RoomId>(id)) return true;
  const auto* wallId = std::get_if<WallId>(&id);
  const Wall* wall = wallId ? editor.home().walls.find(*wallId) : nullptr;
  if (!wall || plane == Plane::XY) return false;
  const Vec2 along = wall->end - wall->start;
  return std::abs(plane == Plane::XZ ? along.x : along.y) > 2 * wall->thickness;
}

}  // namespace idap
