// Edits of single pieces, rooms and openings that panels and tools share.
#pragma once

#include <functional>

#include "model/edits/element_edits.h"

namespace idap {

// Adds a piece on a level and gives its id.
struct FurnitureEdit {
  Home home;
  FurnitureId furniture;
};
FurnitureEdit addFurniture(const Home& home, Furniture furniture);
struct OpeningEdit {
  Home home;
  OpeningId opening;
};
OpeningEdit addOpening(const Home& home, Opening opening);

// Applies a change to every selected piece of furniture and opening, groups' members included.
Home changePieces(const Home& home, const Elements& elements, const std::function<void(Piece&)>& change);
Home changeFurniture(const Home& home, const Elements& elements,
                     const std::function<void(Furniture&)>& change);

// One corner of a room's outline; at: index of the new point. removeRoomPoint throws InvalidHome for the
// third last.
Home moveRoomPoint(const Home& home, RoomId id, std::size_t index, Vec2 to);
Home addRoomPoint(const Home& home, RoomId id, std::size_t at, Vec2 point);
Home removeRoomPoint(const Home& home, RoomId id, std::size_t index);

// Dimensions whose ends lay on what was moved (corners of pieces, ends and faces of walls, corners of rooms,
// within 1 mm) follow it: gives after with those ends moved. Called by tools at the end of a drag and by
// panels after an edit.
Home dimensionsFollow(const Home& before, const Home& after);

// A rectangular room of clear sizes x, y and height z with four walls around it, its inner front left corner
// at the origin: what "New" makes. Names are given by the caller in the user's language.
Home makeRoomHome(double x, double y, double z, double wallThickness, std::string roomName);

}  // namespace idap
