#include "editor/hit_test_shapes.h"
#include "editor/tools/select/handles.h"
#include "editor/tools/select/point_drags.h"
#include "model/edits/piece_edits.h"

namespace idap {

namespace {

SelectHandle pointHandle(PointDrag::Source source, const char* tip, std::function<Home(const Home&)> remove) {
  const Vec2 at = source.point;
  return {{HandleKind::Point, at, 0, false},
          Cursor::Move,
          tip,
          [source = std::move(source)](Editor& editor, const PointerEvent& press) -> std::unique_ptr<Drag> {
            return std::make_unique<PointDrag>(editor, press, source);
          },
          std::move(remove)};
}

std::vector<Vec2> others(std::vector<Vec2> points, std::size_t without) {
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(without));
  return points;
}

constexpr const char* kPointTip = QT_TRANSLATE_NOOP("idap", "Drag to move the point; Delete removes it.");
constexpr const char* kMovePoint = QT_TRANSLATE_NOOP("idap", "Move point");

}  // namespace

SelectHandles roomHandles(const Editor& editor, Plane plane, RoomId id) {
  const Room* room = editor.home().rooms.find(id);
  SelectHandles handles;
  if (!room || plane != Plane::XY) return handles;
  const std::size_t n = room->points.size();
  for (std::size_t i = 0; i < n; ++i) {
    std::function<Home(const Home&)> remove;
    if (n > 3) remove = [id, i](const Home& home) { return removeRoomPoint(home, id, i); };
    handles.push_back(pointHandle(
        {kMovePoint, room->points[i], room->points[(i + n - 1) % n], false, others(room->points, i), only(id),
         true, [id, i](const Home& home, Vec2 to) { return moveRoomPoint(home, id, i, to); }},
        kPointTip, std::move(remove)));
  }
  return handles;
}

SelectHandles polylineHandles(const Editor& editor, Plane plane, PolylineId id) {
  const Polyline* line = editor.home().polylines.find(id);
  SelectHandles handles;
  if (!line || plane != Plane::XY) return handles;
  const std::size_t n = line->points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto change = [id](const Home& home, auto&& edit) {
      Home next = home;
      Polyline changed = *home.polylines.find(id);
      edit(changed.points);
      next.polylines.set(id, std::move(changed));
      return next;
    };
    std::optional<Vec2> from;
    if (i > 0)
      from = line->points[i - 1];
    else if (n > 1)
      from = line->points[1];
    std::function<Home(const Home&)> remove;
    if (n > 2)
      remove = [change, i](const Home& home) {
        return change(home, [i](std::vector<Vec2>& points) {
          points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
        });
      };
    handles.push_back(
        pointHandle({kMovePoint, line->points[i], from, true, others(line->points, i), only(id), true,
                     [change, i](const Home& home, Vec2 to) {
                       return change(home, [i, to](std::vector<Vec2>& points) { points[i] = to; });
                     }},
                    kPointTip, std::move(remove)));
  }
  return handles;
}

SelectHandles dimensionHandles(const Editor& editor, Plane plane, DimensionId id) {
  const Dimension* dimension = editor.home().dimensions.find(id);
  if (!dimension) return {};
  const double floor = elevationOf(editor.home(), dimension->level);
  const auto line = dimensionLine(plane, *dimension, floor);
  if (!line) return {};
  SelectHandles handles;
  for (const bool atEnd : {false, true})
    handles.push_back(pointHandle({QT_TRANSLATE_NOOP("idap", "Move dimension"),
                                   atEnd ? line->end : line->start,
                                   atEnd ? line->start : line->end,
                                   true,
                                   {},
                                   only(id),
                                   true,
                                   [id, atEnd, plane, floor](const Home& home, Vec2 to) {
                                     Home next = home;
                                     Dimension moved = *home.dimensions.find(id);
                                     Vec2& point = atEnd ? moved.end : moved.start;
                                     double& height = atEnd ? moved.endElevation : moved.startElevation;
                                     if (plane == Plane::XY) {
                                       point = to;
                                     } else {
                                       (plane == Plane::XZ ? point.x : point.y) = to.x;
                                       height = to.y - floor;
                                     }
                                     next.dimensions.set(id, moved);
                                     return next;
                                   }},
                                  QT_TRANSLATE_NOOP("idap", "Drag to measure from another point."), nullptr));
  const Vec2 across = perpendicular(line->end - line->start);
  handles.push_back({{HandleKind::Offset, (line->from + line->to) / 2, std::atan2(across.y, across.x), false},
                     sizeCursor(std::atan2(across.y, across.x)),
                     QT_TRANSLATE_NOOP("idap", "Drag to move the line away from what it measures."),
                     [id](Editor& e, const PointerEvent& press) -> std::unique_ptr<Drag> {
                       return std::make_unique<OffsetDrag>(e, press, id);
                     }});
  return handles;
}

}  // namespace idap
