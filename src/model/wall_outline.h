// What a wall covers on the plan: its two side lines, joined to its neighbours by mitres. Metres, plan space.
#pragma once

#include <vector>

#include "model/home.h"

namespace idap {

struct WallOutline {
  // Side lines from start to end; two points for a straight wall, chords of an arc otherwise.
  std::vector<Vec2> left, right;
  // Points between the right and the left line at the end, and between the left and the right at the start:
  // where a sharp corner is cut off.
  std::vector<Vec2> endCap, startCap;
  bool round = false;

  Polygon polygon() const;  // counter-clockwise: right line, end, left line back, start
};

// The outline of a wall of the home. widening is added on both sides of it and of its neighbours
// (baseboards). Corners sharper than about 29 degrees are bevelled.
WallOutline wallOutline(const Home& home, WallId id, const Wall& wall, double widening = 0);

// The centre line: two points, or chords that stay within a millimetre of the arc's sides.
std::vector<Vec2> wallCentreLine(const Wall& wall);

// How far along the wall a point lies, 0 at its start, 1 at its end; beyond them for straight walls.
double alongWall(const Wall& wall, Vec2 point);

// Height of the wall's top above its level over a point of the plan.
inline double wallHeightAt(const Wall& wall, Vec2 point) {
  return wall.heightAtStart == wall.heightAtEnd
             ? wall.heightAtStart
             : wall.heightAtStart + (wall.heightAtEnd - wall.heightAtStart) * alongWall(wall, point);
}

}  // namespace idap
