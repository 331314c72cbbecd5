// Edits of walls. Neighbours and the doors and windows in a wall follow it. All throw InvalidHome for ids
// that do not exist.
#pragma once

#include "model/home.h"

namespace idap {

enum class WallEnd { Start, End };

struct WallEdit {
  Home home;
  WallId wall;  // the new one
};

// Adds a wall and joins it to walls of its level with a free end at the same place (within 1 mm).
WallEdit addWall(const Home& home, Wall wall);

// All walls with an end there move it along; walls that end on one that moves stay on it, along their own
// line where they can.
Home moveWallEnd(const Home& home, WallId id, WallEnd end, Vec2 to);

// Cuts a wall in two at a distance from its start, which must leave both over a millimetre. The first part
// keeps the id; doors and windows go with the part that holds their middle.
WallEdit splitWall(const Home& home, WallId id, double distance);

// Puts a changed wall in the place of the old one, and its doors and windows with it: each keeps its
// distance from the anchored end, as far as the new length allows, and its offset from the centre line.
Home replaceWall(const Home& home, WallId id, const Wall& wall, WallEnd anchor = WallEnd::Start);

}  // namespace idap
