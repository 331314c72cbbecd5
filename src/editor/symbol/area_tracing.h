// Areas of a raster as polygons: their borders followed and smoothed to within a cell.
#pragma once

#include "editor/symbol/depth_raster.h"
#include "editor/symbol/symbol.h"

namespace idap {

struct TracedArea {
  std::uint32_t label = 0;
  std::vector<SymbolRing> rings;  // m, even-odd
};

// Of every label, the largest first; specks are left out.
std::vector<TracedArea> traceAreas(const DepthRaster& raster);
// Of all that is not empty.
std::vector<SymbolRing> traceOutline(const DepthRaster& raster);

// Fewer points, none further than tolerance from the line (Douglas and Peucker 1973).
std::vector<Vec2f> simplified(const std::vector<Vec2f>& line, float tolerance);
std::vector<Vec2f> simplifiedRing(const std::vector<Vec2f>& ring, float tolerance);

}  // namespace idap
