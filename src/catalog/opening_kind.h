// Telling doors from windows where a file only says that something goes into a wall.
#pragma once

#include <string>

#include "model/opening.h"

namespace idap {

// By what it is called (an id and a name, in English or not) and by its sill and height in metres. A window
// that one can walk through counts as a door.
OpeningKind openingKindOf(const std::string& catalogId, const std::string& name, double sill, double height,
                          bool hasLeaves);

}  // namespace idap
