// A smooth curve through given points.
#pragma once

#include <vector>

#include "geometry/vec.h"

namespace idap {

// Cardinal spline (Catmull-Rom) as chords.
std::vector<Vec2> smoothLine(const std::vector<Vec2>& points, bool closed, int chords = 12);

}  // namespace idap
