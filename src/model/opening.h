// A door, a window or a bare opening. It cuts every wall that its box runs into; wall is the one it follows.
#pragma once

#include <string>
#include <vector>

#include "model/piece.h"

namespace idap {

enum class OpeningKind { Door, Window, Bare };

// A leaf's swing as drawn on the plan: axis in fractions of the opening's width and depth (y from its back to
// its front), width as a fraction of the opening's, angles in radians counter-clockwise.
struct Sash {
  Vec2 axis;
  double width = 1;
  double startAngle = 0, endAngle = 0;
  friend bool operator==(const Sash&, const Sash&) = default;
};

struct Opening : Piece {  // position.z is the sill height
  OpeningKind kind = OpeningKind::Door;
  WallId wall;  // none: stands free
  std::string cutOut =
      "M0,0 v1 h1 v-1 z";  // SVG path in the unit square, seen from the front, y down from the top
  bool cutsWalls = true;
  bool cutsBothSides = false;  // cuts straight through even where the wall is thicker than the model
  double wallThickness = 1;    // of the model's part that sits in the wall, as a fraction of its depth
  double wallDistance = 0;     // from the model's back to that part, as a fraction of its depth
  std::vector<Sash> sashes;
  friend bool operator==(const Opening&, const Opening&) = default;
};

}  // namespace idap
