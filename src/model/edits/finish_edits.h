// Giving a finish to one part of something: the side of a wall, the floor of a room, the seat of a chair.
// Parts go by name, as a picture of the home knows them.
#pragma once

#include <string>

#include "model/edits/element_edits.h"
#include "model/finish.h"

namespace idap {

inline constexpr const char* kPartLeft = "left";  // of a wall, going from its start to its end
inline constexpr const char* kPartRight = "right";
inline constexpr const char* kPartTop = "top";
inline constexpr const char* kPartBaseboardLeft = "baseboard left";
inline constexpr const char* kPartBaseboardRight = "baseboard right";
inline constexpr const char* kPartFloor = "floor";  // of a room
inline constexpr const char* kPartCeiling = "ceiling";

// The elements with the finish on that part: of walls and rooms one of those above, of pieces the name of a
// material slot. Without a name: both sides of walls, the floors of rooms, pieces as a whole, whose parts
// then lose what they had. Names that an element has no part of change nothing of it.
Home withFinish(const Home& home, const Elements& elements, const std::string& part, const Finish& finish);

}  // namespace idap
