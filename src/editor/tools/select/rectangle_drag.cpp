#include "editor/tools/select/rectangle_drag.h"

#include "editor/hit_test.h"

namespace idap {

RectangleDrag::RectangleDrag(const Editor& editor, const PointerEvent& press)
    : press_(press), to_(press.at), before_(editor.selection()) {}

void RectangleDrag::move(Editor& editor, const PointerEvent& event) {
  to_ = event.at;
  const Elements found = hitsIn(editor, press_.plane, press_.at, to_);
  if (!press_.modifiers.shift && !press_.modifiers.control) {
    editor.select(found);
    return;
  }
  Elements all = before_;
  for (const AnyId id : list(found)) {
    if (press_.modifiers.control && contains(before_, id))
      remove(all, id);
    else
      add(all, id);
  }
  editor.select(std::move(all));
}

void RectangleDrag::cancel(Editor& editor) { editor.select(before_); }

Overlay RectangleDrag::overlay(const Editor&, Plane plane, double) const {
  Overlay overlay;
  if (plane != press_.plane) return overlay;
  const Vec2 a = press_.at, b = to_;
  overlay.shapes.push_back({{a, {b.x, a.y}, b, {a.x, b.y}}, true, true});
  return overlay;
}

Text RectangleDrag::hint() const {
  return QT_TRANSLATE_NOOP(
      "idap", "To the right: selects what lies wholly inside. To the left: also what it touches.");
}

}  // namespace idap
