// Moves what is selected, in any plane: pieces snap as pieces do, doors and windows jump between walls,
// points of all else snap as points. Ctrl copies, Shift keeps to one axis, the distances around can be typed.
#pragma once

#include "editor/tools/select/drag.h"

namespace idap {

class MoveDrag final : public EditDrag {
 public:
  // lead: the element under the pointer, which snaps for all.
  MoveDrag(Editor& editor, const PointerEvent& press, Elements elements, AnyId lead);
  void finish(Editor& editor) override;
  Answer key(Editor& editor, const KeyEvent& event) override;
  Text hint() const override;

 protected:
  void aim(const Editor& editor, const PointerEvent& event) override;
  Home change(const Home& before) override;
  Home settle(const Editor& editor, const Home& before, Home after) override;
  void show(const Editor& editor, Overlay& overlay, double pixel) const override;

 private:
  enum class Kind { Piece, Opening, Points };
  void study(const Editor& editor, AnyId lead);
  void aimPiece(const Editor& editor, Vec3 by, bool off);
  void aimOpening(const Editor& editor, const PointerEvent& event, Vec3 by);
  void centreOpening(const Editor& editor, const Elements& itself);
  void aimPoints(const Editor& editor, Vec3 by);
  void measure(const Editor& editor);
  void typeDistance();
  void choose(std::size_t measure);

  Kind kind_ = Kind::Points;
  Elements elements_;
  bool copies_ = false;
  Elements copied_;
  Piece piece_;  // of Kind::Piece: the lead, or the box of its group
  bool mayTurn_ = false, hangs_ = true, alone_ = false;
  OpeningId opening_;
  std::optional<Opening> placed_;  // of Kind::Opening
  std::optional<Vec2> across_;     // a wall that moves parallel
  std::vector<Vec3> points_;       // of Kind::Points: what may snap, world
  bool base_ = false;              // walls are among what moves
  Vec3 by_;
  double turn_ = 0;
  std::vector<MeasureLine> measures_;
  Vec2 chosen_;  // direction of the measure to be typed; zero: the shortest
};

}  // namespace idap
