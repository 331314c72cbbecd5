// A motion of the plan that keeps lengths: mirrored, turned, shifted; and what it does to elements.
#pragma once

#include "geometry/box.h"
#include "model/edits/element_edits.h"

namespace idap {

struct Motion {
  Vec2 by;
  double rise = 0;   // m
  double angle = 0;  // radians about the point, after mirroring
  Vec2 about;
  bool mirrored = false;  // left and right of the point exchanged

  Vec2 operator()(Vec2 p) const;
  Vec3 operator()(Vec3 p) const;
  Vec2 vector(Vec2 v) const;
  double turned(double direction) const { return (mirrored ? -direction : direction) + angle; }

  void operator()(Piece& piece) const;
  void operator()(Wall& wall) const;  // with its sides; not its neighbours
  void operator()(Room& room) const;
  void operator()(Camera& camera) const;
  void operator()(Dimension& dimension) const;
  void operator()(Label& label) const;
  void operator()(Polyline& line) const;
};

// What is listed, and nothing else of its groups; walls as WallMove moves them.
Home moved(const Home& home, const Elements& listed, const Motion& motion);

// The rectangle around what is listed, on the plan; walls by their centre lines.
Box2 planBounds(const Home& home, const Elements& listed);

}  // namespace idap
