// What tools that place something out of the catalog share: it follows the pointer, a click sets it, a drag
// out of the catalog sets it where it is dropped, a right click or leaving the plan drops it.
#pragma once

#include <utility>

#include "editor/editor.h"
#include "editor/tool.h"

namespace idap {

class PlacingTool : public Tool {
 public:
  Response pointer(Editor& editor, const PointerEvent& event) override {
    switch (event.kind) {
      case PointerEvent::Kind::Move:
        follow(editor, event);
        return {};
      case PointerEvent::Kind::Press:
        if (event.button == PointerEvent::Button::Right) {
          release(editor);
          return {.finished = true};
        }
        pressed_ = true;
        follow(editor, event);
        return place(editor);
      case PointerEvent::Kind::Release:
        // Dropped, dragged here from the catalog.
        if (!std::exchange(pressed_, false) && once_ && event.button == PointerEvent::Button::Left) {
          follow(editor, event);
          return place(editor);
        }
        return {};
      case PointerEvent::Kind::Leave:
        release(editor);
        return {};
      default:
        return {};
    }
  }

 protected:
  explicit PlacingTool(bool once) : once_(once) {}

  virtual void follow(Editor& editor, const PointerEvent& event) = 0;
  virtual Response place(Editor& editor) = 0;
  virtual void drop(Editor& editor) = 0;  // takes back what is in the air
  void release(Editor& editor) {
    drop(editor);
    pressed_ = false;
  }

  const bool once_;  // back to selecting after one

 private:
  bool pressed_ = false;
};

}  // namespace idap
