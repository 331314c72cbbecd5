// Places that come into question for a piece in a room, each with how well it suits; what is in the way is
// looked at afterwards.
#pragma once

#include <optional>
#include <vector>

#include "editor/tools/arrange/manner.h"
#include "editor/tools/arrange/room_space.h"

namespace idap {

struct Spot {
  Vec2 middle;
  double angle = 0;
  double z = 0;      // m above the level
  double merit = 0;  // more is better; a metre off is worth about one
  FurnitureId on;    // what it stands on or is pushed under: that is not in its way
};

// Along the walls of the room, its back to them.
std::vector<Spot> spotsAlongWalls(const RoomSpace& room, const Furniture& piece, Manner manner);
// In the corners of the room.
std::vector<Spot> spotsInCorners(const RoomSpace& room, const Furniture& piece);
// All over the room, the middle before the sides.
std::vector<Spot> spotsAllOver(const RoomSpace& room, const Furniture& piece);
// Beside beds, on tables, around tables, before sofas, at windows: by the manner.
std::vector<Spot> spotsByOthers(const RoomSpace& room, const Furniture& piece, const CatalogPiece& catalog,
                                Manner manner);

}  // namespace idap
