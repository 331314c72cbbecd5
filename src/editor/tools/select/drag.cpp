#include "editor/tools/select/drag.h"

#include "base/error.h"
#include "model/edits/piece_edits.h"
#include "model/edits/wall_shape_edits.h"

namespace idap {

namespace {
// Finding the rooms between so many walls takes a few milliseconds.
constexpr std::size_t kWallsFollowed = 24;
}  // namespace

EditDrag::EditDrag(Editor& editor, std::string name, const PointerEvent& press, Cursor cursor)
    : name_(std::move(name)),
      before_(editor.home()),
      press_(press),
      last_(press),
      cursor_(cursor),
      settlesAlong_(before_.walls.size() <= kWallsFollowed) {
  editor.document().begin(name_);
}

void EditDrag::update(Editor& editor) {
  guides_.clear();
  aim(editor, last_);
  editor.preview([&](const Home& before) {
    Home next = change(before);
    return settlesAlong_ ? settle(editor, before, std::move(next)) : next;
  });
}

void EditDrag::move(Editor& editor, const PointerEvent& event) {
  last_ = event;
  update(editor);
}

void EditDrag::finish(Editor& editor) {
  if (!editor.document().inTransaction()) return;
  const Home moved = editor.home();
  editor.preview([&](const Home& before) {
    if (moved == before) return moved;
    return dimensionsFollow(before, settlesAlong_ ? moved : settle(editor, before, moved));
  });
  editor.document().commit();
}

void EditDrag::cancel(Editor& editor) { editor.document().cancel(); }

Drag::Answer EditDrag::key(Editor& editor, const KeyEvent& event) {
  if (fields_.fields().empty()) return Answer::Unused;
  switch (fields_.key(event, editor.settings().unit)) {
    case TypedFields::Answer::Unused:
      return Answer::Unused;
    case TypedFields::Answer::Apply:
      update(editor);
      return Answer::Done;
    case TypedFields::Answer::Changed:
      update(editor);
      return Answer::Used;
    case TypedFields::Answer::Wrong:
      break;
  }
  return Answer::Used;
}

Overlay EditDrag::overlay(const Editor& editor, Plane plane, double pixel) const {
  Overlay overlay;
  if (plane != press_.plane) return overlay;
  overlay.guides = guides_;
  show(editor, overlay, pixel);
  if (!fields_.fields().empty()) fields_.into(overlay, last_.at);
  return overlay;
}

SnappedPoint EditDrag::snapped(const Editor& editor, Vec2 at, const Elements& ignored, bool faces,
                               std::optional<Vec2> from, std::optional<double> along,
                               std::vector<Vec2> marks) {
  SnapRequest request;
  request.plane = plane();
  request.at = at;
  request.tolerance = tolerance(last_);
  request.from = from;
  request.along = along;
  request.marks = std::move(marks);
  request.ignored = ignored;
  request.wallFaces = faces;
  SnappedPoint point = snapPoint(editor, request, last_.modifiers.alt);
  guides_.insert(guides_.end(), point.guides.begin(), point.guides.end());
  return point;
}

Home withRooms(const Editor& editor, const Home& before, Home after) {
  return editor.settings().roomAreas ? followWalls(before, after, editor.level(), false) : after;
}

double stepped(double angle, bool free) {
  constexpr double kStep = kPi / 12;
  return free ? angle : std::round(angle / kStep) * kStep;
}

}  // namespace idap
