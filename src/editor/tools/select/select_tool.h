// The tool in hand when no other is: it selects, moves, turns and resizes what is there. Every other tool
// gives way to it.
#pragma once

#include "editor/tools/select/handles.h"

namespace idap {

class SelectTool final : public Tool {
 public:
  const ToolInfo& info() const override;
  Text hint() const override;
  bool cancel(Editor& editor) override;
  Response pointer(Editor& editor, const PointerEvent& event) override;
  Response key(Editor& editor, const KeyEvent& event) override;
  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override;
  Cursor cursor(const Editor& editor, Plane plane) const override;

 private:
  Response press(Editor& editor, const PointerEvent& event);
  Response move(Editor& editor, const PointerEvent& event);
  Response release(Editor& editor, const PointerEvent& event);
  Response doubleClick(Editor& editor, const PointerEvent& event);
  void click(Editor& editor);
  void startDrag(Editor& editor);
  void hover(const Editor& editor, const PointerEvent& event);
  bool sameSpot(const PointerEvent& event) const;
  bool nudge(Editor& editor, const KeyEvent& event);
  bool deleteSelected(Editor& editor);

  std::unique_ptr<Drag> drag_;
  std::optional<PointerEvent> pressed_;    // the left button is down, and not dragged yet
  std::optional<SelectHandle> handle_;     // that was pressed
  std::vector<AnyId> hits_;                // under the press
  std::optional<AnyId> grabbed_;           // what a drag would move
  std::optional<PointerEvent> lastClick_;  // for choosing what lies under it by a second click
  std::optional<Elements> beforeCycle_;    // in case that click was the first of a double click

  // Under the pointer.
  Plane plane_ = Plane::XY;
  std::optional<SelectHandle> hovered_;
  bool overSelected_ = false;
};

}  // namespace idap
