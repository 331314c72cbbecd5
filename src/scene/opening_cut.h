// The hole that a door, a window or a bare opening needs in the walls. An opening has its own frame on the
// plan: u along its width to its right, v towards its back; heights are the world's. Metres.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "scene/wall_solid.h"

namespace idap {

struct OpeningCut {
  OpeningId id;
  Vec2 origin, uAxis, vAxis;
  double v0 = 0, v1 = 0;  // the part of its box that sits in the wall
  bool bothSides = false;
  Regions shape;  // in (u, world z)
  Box2 box;       // of the shape
  double sill = 0;
  std::size_t storey = 0;
  bool atFloor = false;  // its threshold is the floor's

  Vec2 plan(double u, double v) const { return origin + uAxis * u + vAxis * v; }
  double uOf(Vec2 p) const { return dot(p - origin, uAxis); }
  double vOf(Vec2 p) const { return dot(p - origin, vAxis); }
};

// What a cut takes out of one wall.
struct WallCut {
  const OpeningCut* opening = nullptr;
  bool throughLow = true, throughHigh = true;  // reaches the wall's face at its low and its high v
  bool leftIsHigh = true;                      // the wall's left side is at high v
};

// Lowest and highest v of the wall's plan at u, in the piece that lies nearest the opening; false where it is
// not there.
bool wallSpanAt(const WallSolid& wall, const OpeningCut& cut, double u, double& low, double& high);

std::vector<OpeningCut> openingCuts(const Home& home, const std::vector<Storey>& storeys);

// The openings that cut this wall.
std::vector<WallCut> cutsOf(const WallSolid& wall, const std::vector<OpeningCut>& openings);
// Of each wall.
std::vector<std::vector<WallCut>> cutsOf(const std::vector<WallSolid>& walls,
                                         const std::vector<OpeningCut>& openings);

}  // namespace idap
