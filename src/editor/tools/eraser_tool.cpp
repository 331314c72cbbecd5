// The eraser of 1993: a click takes away what is under the pointer, a drag all that it passes over.
#include <algorithm>

#include "editor/hit_test.h"
#include "editor/tools/element_shape.h"
#include "editor/tools/tool_list.h"

namespace idap {

namespace {

constexpr double kReachPixels = 4;

const ToolInfo kInfo{"eraser",
                     QT_TRANSLATE_NOOP("idap", "Eraser"),
                     QT_TRANSLATE_NOOP("idap", "Take away what you click; undo brings it back"),
                     QT_TRANSLATE_NOOP("idap", "Click what is to go, or drag over it"),
                     "E",
                     {{"Esc", QT_TRANSLATE_NOOP("idap", "stop")}}};

class EraserTool : public Tool {
 public:
  const ToolInfo& info() const override { return kInfo; }

  bool cancel(Editor& editor) override {
    under_.reset();
    if (!erasing_) return false;
    erasing_ = false;
    gone_ = {};
    editor.document().cancel();
    return true;
  }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    switch (event.kind) {
      case PointerEvent::Kind::Press:
      case PointerEvent::Kind::DoubleClick:
        if (event.button == PointerEvent::Button::Right) return {.used = cancel(editor)};
        if (erasing_) return {};
        erasing_ = true;
        gone_ = {};
        last_ = event.at;
        editor.document().begin(QT_TRANSLATE_NOOP("idap", "Erase"));
        erase(editor, event, event.at);
        return {};
      case PointerEvent::Kind::Move:
        plane_ = event.plane;
        if (erasing_) {
          sweep(editor, event);
        } else {
          under_ = hit(editor, event, event.at);
        }
        return {};
      case PointerEvent::Kind::Release:
        if (!erasing_ || event.button != PointerEvent::Button::Left) return {};
        erasing_ = false;
        gone_ = {};
        editor.document().commit();
        under_ = hit(editor, event, event.at);
        return {};
      case PointerEvent::Kind::Leave:
        under_.reset();
        return {};
    }
    return {};
  }

  Overlay overlay(const Editor& editor, Plane plane, double) const override {
    Overlay overlay;
    if (!under_ || plane != plane_) return overlay;
    overlay.shapes.push_back(shapeOf(editor.home(), plane, *under_));
    if (overlay.shapes.back().points.empty()) return {};
    overlay.note = QT_TRANSLATE_NOOP("idap", "A click takes this away");
    return overlay;
  }

  Cursor cursor(const Editor&, Plane) const override { return Cursor::Eraser; }

 private:
  static std::optional<AnyId> hit(const Editor& editor, const PointerEvent& event, Vec2 at) {
    const std::vector<AnyId> hits = hitsAt(editor, event.plane, at, kReachPixels * event.pixel);
    return hits.empty() ? std::nullopt : std::optional(hits.front());
  }

  // Fast drags leave out pixels: what lies between counts as well.
  void sweep(Editor& editor, const PointerEvent& event) {
    const Vec2 by = event.at - last_;
    const double step = std::max(2 * kReachPixels * event.pixel, length(by) / 50);
    const int steps = std::max(1, static_cast<int>(length(by) / step));
    for (int i = 1; i <= steps; ++i) erase(editor, event, last_ + by * (double(i) / steps));
    last_ = event.at;
  }

  void erase(Editor& editor, const PointerEvent& event, Vec2 at) {
    const std::optional<AnyId> id = hit(editor, event, at);
    under_.reset();
    if (!id) return;
    // One thing in a place: not all that lies under it, the room and the walls behind.
    if (!empty(gone_) && std::holds_alternative<RoomId>(*id)) return;
    add(gone_, *id);
    editor.preview([this](const Home& home) { return deleteElements(home, gone_); });
  }

  bool erasing_ = false;
  Elements gone_;
  Vec2 last_;
  Plane plane_ = Plane::XY;
  std::optional<AnyId> under_;
};

}  // namespace

ToolEntry eraserTool() {
  return {&kInfo, [] { return std::make_unique<EraserTool>(); }};
}

}  // namespace idap
