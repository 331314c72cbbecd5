// The distances from a piece to what is beside it, shown and typed while it is placed: a typed one moves the
// piece.
#pragma once

#include <array>
#include <vector>

#include "editor/tools/typed_fields.h"

namespace idap {

class SideFields {
 public:
  // The lines from the piece, about its middle on the plane. While something is typed the old ones stand.
  void show(const std::vector<MeasureLine>& measures, Vec2 middle);
  void clear();

  bool typing() const { return fields_.typing(); }
  TypedFields::Answer key(const KeyEvent& event, LengthUnit unit);
  // How far what was typed moves the piece from where the lines were measured.
  Vec2 shift() const;

  void into(Overlay& overlay, Vec2 at) const;

 private:
  enum Side { Left, Right, Bottom, Top };
  struct Measured {
    Side side;
    MeasureLine line;
    Vec2 outward;  // unit
  };
  std::vector<Measured> measured_;  // in the order of the fields
  TypedFields fields_;
};

}  // namespace idap
