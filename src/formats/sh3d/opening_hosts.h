// Finding the wall that a door or window sits in, where a file does not say.
#pragma once

#include "model/home.h"

namespace idap {

// The wall of the opening's level that its in-wall part lies in: the nearest centre line, the most parallel
// one among equals. None when it touches no wall.
WallId hostOf(const Home& home, const Opening& opening);

}  // namespace idap
