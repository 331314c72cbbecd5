// Areas and centres of rooms, and rooms found in the plan: the areas that walls close off.
#pragma once

#include <optional>
#include <vector>

#include "model/home.h"

namespace idap {

double floorArea(const Room& room);  // m2, also of a ring that crosses itself
// The centre of area where it lies in the room, or else a point well inside (of an L or a ring).
Vec2 roomCentre(const Room& room);

// The areas between the walls of a level, by their inner faces, larger than 0.1 m2. Gaps up to twice
// the given one count as closed. What stands free inside (a pillar) is not cut out: a room is one ring.
std::vector<Polygon> closedAreas(const Home& home, LevelId level, double gap = 0.005);
// The one that holds the point.
std::optional<Polygon> closedAreaAt(const Home& home, LevelId level, Vec2 point, double gap = 0.005);

}  // namespace idap
