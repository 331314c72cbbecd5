// Edits of the shape of walls beyond moving an end: joining, reversing, bending, walls around a room.
// All throw InvalidHome for ids that do not exist.
#pragma once

#include <vector>

#include "model/edits/wall_edits.h"

namespace idap {

// Joins the nearest ends of two walls of one level, prolonging or shortening both to where their lines meet;
// parallel ones in line meet in the middle of the gap. Throws InvalidHome where they cannot meet.
Home joinWalls(const Home& home, WallId first, WallId second);

// Start becomes end, left becomes right: the wall looks as before.
Home reverseWall(const Home& home, WallId id);

// Bends a wall so that the middle of its centre line passes through the point; straight again within a
// millimetre.
Home bendWall(const Home& home, WallId id, Vec2 through);

// Moves the corner of all walls of a level that have an end there (within 1 mm), with what is joined and the
// rooms whose outline has a point at that corner's faces.
Home moveCorner(const Home& home, LevelId level, Vec2 corner, Vec2 to);

// Walls along the outline of a room, outside of it, all joined.
Home wallsAroundRoom(const Home& home, RoomId room, double thickness, double height);

// Rooms follow the walls they were found in: gives every area that walls newly close a room (named by name),
// and gives the rooms that filled such an area before its new outline. What the user drew by hand elsewhere
// stays.
Home followWalls(const Home& before, const Home& after, LevelId level, bool newRooms);

}  // namespace idap
