#include "editor/tools/select/handles.h"
#include "editor/tools/select/wall_drags.h"
#include "model/wall_path.h"

namespace idap {

SelectHandles wallHandles(const Editor& editor, Plane plane, WallId id) {
  const Wall* wall = editor.home().walls.find(id);
  SelectHandles handles;
  if (!wall) return handles;
  if (plane == Plane::XY) {
    for (const WallEnd end : {WallEnd::Start, WallEnd::End})
      handles.push_back({{HandleKind::WallEnd, end == WallEnd::Start ? wall->start : wall->end, 0, false},
                         Cursor::Move,
                         QT_TRANSLATE_NOOP("idap", "Drag to move the corner with all walls that meet there."),
                         [id, end](Editor& e, const PointerEvent& press) -> std::unique_ptr<Drag> {
                           return std::make_unique<WallEndDrag>(e, press, id, end);
                         }});
    const WallPath path(*wall);
    const Vec2 along = path.direction(path.length() / 2);
    handles.push_back(
        {{HandleKind::WallArc, path.point(path.length() / 2), std::atan2(along.x, -along.y), false},
         Cursor::Move,
         QT_TRANSLATE_NOOP("idap", "Drag to bend the wall."),
         [id](Editor& e, const PointerEvent& press) -> std::unique_ptr<Drag> {
           return std::make_unique<WallArcDrag>(e, press, id);
         }});
    return handles;
  }
  const double floor = elevationOf(editor.home(), wall->level);
  const Vec2 start = project(plane, {wall->start.x, wall->start.y, floor + wall->heightAtStart});
  const Vec2 end = project(plane, {wall->end.x, wall->end.y, floor + wall->heightAtEnd});
  const auto add = [&](Vec2 at, bool atStart, bool atEnd) {
    handles.push_back({{HandleKind::Height, at, kPi / 2, false},
                       Cursor::SizeVertical,
                       QT_TRANSLATE_NOOP("idap", "Drag to change the height; with Shift at both ends."),
                       [id, atStart, atEnd](Editor& e, const PointerEvent& press) -> std::unique_ptr<Drag> {
                         return std::make_unique<WallHeightDrag>(e, press, id, atStart, atEnd);
                       }});
  };
  // Seen end on, both ends are one.
  if (length(start - end) < 0.05) {
    add((start + end) / 2, true, true);
  } else {
    add(start, true, false);
    add(end, false, true);
  }
  return handles;
}

}  // namespace idap
