// Finding the wall that a door or window sits in, and telling doors from windows, where a file says neither.
#pragma once

#include <string>

#include "model/home.h"

namespace idap {

// The wall of the opening's level that its in-wall part lies in: the nearest centre line, the most parallel
// one among equals. None when it touches no wall.
WallId hostOf(const Home& home, const Opening& opening);

// By what it is called (an id and a name in whatever language) and by its sill and height.
OpeningKind openingKindOf(const std::string& catalogId, const std::string& name, double sill, double height,
                          bool hasLeaves);

}  // namespace idap
