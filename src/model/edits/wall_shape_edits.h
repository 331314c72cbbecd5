// Edits of the shape of walls beyond moving an end: joining, reversing, bending, walls around a room.
// All throw InvalidHome for ids that do not exist.
#pragma once

#include <string>
#include <vector>

#include "model/edits/wall_edits.h"

namespace idap {

// Joins the nearest ends of two walls of one level, free ones first, prolonging or shortening both to where
// their lines meet; parallel ones in line meet in the middle of the gap. A wall that would lose more than
// half a metre stays as it is, and the other ends on it. Throws InvalidHome where they cannot meet.
Home joinWalls(const Home& home, WallId first, WallId second);

// Start becomes end, left becomes right: the wall looks as before.
Home reverseWall(const Home& home, WallId id);

// Bends a wall so that the middle of its centre line passes through the point; straight again within a
// millimetre.
Home bendWall(const Home& home, WallId id, Vec2 through);

// Moves the corner of all walls of a level that have an end there (within 1 mm), with what is joined and the
// rooms (as followWalls has it).
Home moveCorner(const Home& home, LevelId level, Vec2 corner, Vec2 to);

// The same for both ends of a wall at once.
Home moveWall(const Home& home, WallId id, Vec2 start, Vec2 end);

// Walls along the outline of a room, outside of it, all joined; none where one stands already.
Home wallsAroundRoom(const Home& home, RoomId room, double thickness, double height);

// Rooms follow the walls they were found in. A room that filled an area between the walls of before fills
// what became of that area after, and keeps all else; of an area cut in two it keeps the larger part (at
// equal parts, the one its name stands in). Where two such rooms became one area both stay as they are. Of
// other rooms the points at corners of walls (within 1 mm) go with these; what the user drew elsewhere stays.
// newRooms: every area that walls newly close gets a room of that name, with
// the finishes of the room it was cut off from.
Home followWalls(const Home& before, const Home& after, LevelId level, bool newRooms,
                 const std::string& name = {});

struct RoomsEdit {
  Home home;
  std::vector<RoomId> rooms;  // the new ones
};
// A room for every area that walls close on a level and that no room covers yet.
RoomsEdit roomsOfClosedAreas(const Home& home, LevelId level, const std::string& name = {});

}  // namespace idap
