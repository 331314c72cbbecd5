// Doors and windows as architects draw them: the hole in the wall, the leaves and their swings. Plan, metres.
#pragma once

#include <array>
#include <vector>

#include "model/home.h"

namespace idap {

struct OpeningShape {
  std::array<Vec2, 4> hole;   // through the wall, counter-clockwise from its front left
  std::array<Vec2, 4> frame;  // the part of the opening that sits in the wall
  struct Leaf {
    Vec2 axis;
    double width = 0;
    double from = 0, to = 0;  // radians on the plan, closed and open
  };
  std::vector<Leaf> leaves;
  Vec2 along;  // unit, to its right
};

// The leaves of a door that says nothing of them: one, or two of a wide one.
OpeningShape openingShape(const Home& home, const Opening& opening);
Box2 openingBox(const Home& home, const Opening& opening);  // of all that is drawn

}  // namespace idap
