// Edits of any elements together: delete, move, turn, resize, group. Ids that do not exist are passed over.
#pragma once

#include <string>
#include <vector>

#include "model/home.h"

namespace idap {

// What is selected. A group stands for all that is in it.
struct Elements {
  std::vector<WallId> walls;
  std::vector<RoomId> rooms;
  std::vector<OpeningId> openings;
  std::vector<FurnitureId> furniture;
  std::vector<GroupId> groups;
  std::vector<CameraId> cameras;
  std::vector<DimensionId> dimensions;
  std::vector<LabelId> labels;
  std::vector<PolylineId> polylines;
};

// Without duplicates, and with the pieces, openings and groups of its groups, at any depth.
Elements withGroups(const Home& home, const Elements& elements);

// Without locked pieces and without groups that hold one: what may be moved, changed or deleted.
Elements unlocked(const Home& home, const Elements& elements);

// All there is in the home, on every level, hidden or not.
Elements allElements(const Home& home);

// What stood in a deleted wall goes with it; groups left empty go too; references to what is gone are
// cleared.
Home deleteElements(const Home& home, const Elements& elements);

// Walls take their doors and windows along, and the ends of walls joined to them. Up and down (z) only
// pieces, openings and cameras move.
Home moveElements(const Home& home, const Elements& elements, Vec3 by);

// About the vertical axis through a point, counter-clockwise, radians. Joined walls follow.
Home turnElements(const Home& home, const Elements& elements, Vec2 about, double angle);

struct GroupEdit {
  Home home;
  GroupId group;
};
// Puts pieces, openings and groups into a new group, inside the group that holds them all, if there is one.
GroupEdit groupElements(const Home& home, const Elements& elements, std::string name);
// Its members move up to the group above it.
Home ungroup(const Home& home, GroupId group);

struct RoomEdit {
  Home home;
  RoomId room;
};
RoomEdit addRoom(const Home& home, Room room);
// A room of the area that walls close around a point. Throws InvalidHome where none do.
RoomEdit addRoomAt(const Home& home, LevelId level, Vec2 point, std::string name = {});

}  // namespace idap
