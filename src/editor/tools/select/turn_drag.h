// Turning: anything on the plan about a point, and a piece's tilt in the plane it is seen from the side.
#pragma once

#include "editor/tools/select/drag.h"

namespace idap {

class TurnDrag final : public EditDrag {
 public:
  // angle: what the elements stand at now, which is brought to steps of 15 degrees; 0 for several.
  TurnDrag(Editor& editor, const PointerEvent& press, Elements elements, Vec2 about, double angle);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  Elements elements_;
  Vec2 about_;
  double from_, to_;
};

class TiltDrag final : public EditDrag {
 public:
  enum class Tilt { Pitch, Roll };
  TiltDrag(Editor& editor, const PointerEvent& press, AnyId piece, Tilt tilt);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  AnyId piece_;
  double Piece::*angle_;
  Vec2 centre_;
  double sign_ = 1;  // of the plane's counter-clockwise turn
  double from_, to_;
};

// A piece lifted or lowered on the plan, by dragging up and down.
class RaiseDrag final : public EditDrag {
 public:
  RaiseDrag(Editor& editor, const PointerEvent& press, AnyId piece);
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;

 private:
  AnyId id_;
  Piece piece_;
  double to_;
};

}  // namespace idap
