#include "editor/finish_drag.h"

#include "editor/hit_test.h"
#include "model/edits/finish_edits.h"

namespace idap {

namespace {

std::string sideOf(const Wall& wall, Plane plane, Vec2 at) {
  const Vec2 left = perpendicular(wall.end - wall.start);
  const Vec2 towards = plane == Plane::XY ? at - wall.start : plane == Plane::XZ ? Vec2{0, -1} : Vec2{1, 0};
  return dot(left, towards) >= 0 ? kPartLeft : kPartRight;
}

}  // namespace

std::optional<ElementPart> partAt(const Editor& editor, Plane plane, Vec2 at, double tolerance) {
  for (const AnyId id : membersAt(editor, plane, at, tolerance)) {
    if (pieceOf(editor.home(), id)) return ElementPart{id, {}};
    if (const auto* wall = std::get_if<WallId>(&id))
      return ElementPart{id, sideOf(*editor.home().walls.find(*wall), plane, at)};
    if (std::holds_alternative<RoomId>(id)) return ElementPart{id, kPartFloor};
  }
  return std::nullopt;
}

FinishDrag::FinishDrag(Editor& editor, Finish finish) : editor_(editor), finish_(std::move(finish)) {
  editor_.setTool(nullptr);  // which takes back what a tool has half done
}

FinishDrag::~FinishDrag() { over(std::nullopt); }

void FinishDrag::over(const std::optional<ElementPart>& part) {
  if (part == shown_) return;
  if (shown_) editor_.document().cancel();
  shown_ = part;
  if (!part) return;
  editor_.document().begin(QT_TRANSLATE_NOOP("idap", "Change finish"));
  editor_.preview(
      [&](const Home& home) { return withFinish(home, only(part->first), part->second, finish_); });
}

void FinishDrag::drop() {
  if (shown_) editor_.document().commit();
  shown_.reset();
}

}  // namespace idap
