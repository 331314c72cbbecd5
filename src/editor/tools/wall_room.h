// How much room a wall has for doors and windows.
#pragma once

#include <vector>

#include "model/home.h"

namespace idap {

struct Stretch {  // of a wall, m from its start
  double from = 0, to = 0;
  double length() const { return to - from; }
};

// What of a wall is free between two heights above its level: not taken by other openings, nor by walls that
// meet it at its ends or on its way. In order; the given opening does not count.
std::vector<Stretch> freeStretches(const Home& home, WallId wall, double low, double high,
                                   OpeningId except = {});

}  // namespace idap
