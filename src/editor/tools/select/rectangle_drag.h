// Selects what lies in a rectangle; from right to left also what it touches.
#pragma once

#include "editor/tools/select/drag.h"

namespace idap {

class RectangleDrag final : public Drag {
 public:
  // Shift adds to what is selected, Ctrl takes out what was and adds what was not.
  RectangleDrag(const Editor& editor, const PointerEvent& press);
  void move(Editor& editor, const PointerEvent& event) override;
  void finish(Editor&) override {}
  void cancel(Editor& editor) override;
  Overlay overlay(const Editor& editor, Plane plane, double pixel) const override;
  Text hint() const override;
  Cursor cursor() const override { return Cursor::Cross; }

 private:
  PointerEvent press_;
  Vec2 to_;
  Elements before_;
};

}  // namespace idap
