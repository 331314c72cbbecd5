// Outlines given as SVG path data (the cut-out shapes of doors, windows and stairs), flattened to polygons.
#pragma once

#include <string_view>
#include <vector>

#include "geometry/polygon.h"

namespace idap {

// Reads the commands M L H V C S Q T A Z, absolute and relative; curves become chords with an error under
// tolerance (in the path's units). Throws ParseError ("path", position) for anything else. Rings under three
// points are dropped. Bounded: at most 100 000 points.
std::vector<Polygon> parseSvgPath(std::string_view path, double tolerance = 0.002);

}  // namespace idap
