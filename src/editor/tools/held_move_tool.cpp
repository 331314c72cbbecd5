#include "editor/tools/held_move_tool.h"

#include <utility>

#include "editor/tools/select/move_drag.h"

namespace idap {

namespace {

class HeldMoveTool final : public Tool {
 public:
  HeldMoveTool(Elements elements, AnyId lead) : elements_(std::move(elements)), lead_(lead) {}

  const ToolInfo& info() const override {
    static const ToolInfo info{"move",
                               QT_TRANSLATE_NOOP("idap", "Move"),
                               QT_TRANSLATE_NOOP("idap", "Moves what is held"),
                               QT_TRANSLATE_NOOP("idap", "Let it go where it shall be; Escape takes it back"),
                               "",
                               {}};
    return info;
  }
  Text hint() const override { return drag_ ? drag_->hint() : Text(info().hint); }

  Response pointer(Editor& editor, const PointerEvent& event) override {
    switch (event.kind) {
      case PointerEvent::Kind::Press:
        drag_ = std::make_unique<MoveDrag>(editor, event, elements_, lead_);
        return {};
      case PointerEvent::Kind::Move:
        if (drag_) drag_->move(editor, event);
        return {};
      case PointerEvent::Kind::Release:
        if (drag_) {
          const std::unique_ptr<MoveDrag> drag = std::move(drag_);
          drag->move(editor, event);
          drag->finish(editor);
        }
        return {.finished = true};
      default:
        return {};
    }
  }
  Response key(Editor& editor, const KeyEvent& event) override {
    if (!drag_ || event.key == Key::Escape) return {.used = false};
    switch (drag_->key(editor, event)) {
      case Drag::Answer::Unused:
        return {.used = false};
      case Drag::Answer::Used:
        return {};
      case Drag::Answer::Done:
        drag_.reset();
        return {.finished = true};
    }
    return {.used = false};
  }
  bool cancel(Editor& editor) override {
    if (!drag_) return false;
    const std::unique_ptr<MoveDrag> drag = std::move(drag_);
    drag->cancel(editor);
    return true;
  }
  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override {
    return drag_ ? drag_->overlay(editor, plane, pixel) : Overlay{};
  }
  Cursor cursor(const Editor&, Plane) const override { return Cursor::Move; }

 private:
  Elements elements_;
  AnyId lead_;
  std::unique_ptr<MoveDrag> drag_;
};

}  // namespace

std::unique_ptr<Tool> makeHeldMoveTool(Elements elements, AnyId lead) {
  return std::make_unique<HeldMoveTool>(std::move(elements), lead);
}

}  // namespace idap
