// From a plane back into space: the coordinate along the line of sight, which the pointer does not give.
#pragma once

#include "editor/editor.h"

namespace idap {

// A point of a plane at a coordinate along its line of sight: z of XY, y of XZ, x of YZ. World, metres.
constexpr Vec3 inSpace(Plane plane, Vec2 at, double unseen) {
  switch (plane) {
    case Plane::XZ:
      return {at.x, unseen, at.y};
    case Plane::YZ:
      return {unseen, at.x, at.y};
    default:
      return {at.x, at.y, unseen};
  }
}

// What it most likely is in an upright plane: the middle of what is selected, else of the largest room of the
// level that is seen there, else of all that stands on the level. In XY the level's floor.
double unseenCoordinate(const Editor& editor, Plane plane, Vec2 at);

}  // namespace idap
