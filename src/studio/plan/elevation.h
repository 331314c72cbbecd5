// Walls seen from the side, as on an architect's section: the building is cut through its middle; walls that
// are cut are dark, those behind are pale areas, those in front are only outlines.
#pragma once

#include <vector>

#include "editor/plane.h"
#include "model/home.h"

namespace idap {

struct WallFace {
  Polygon polygon;  // on the plane
  enum class Kind { Front, Behind, Cut } kind = Kind::Behind;
  double near = 0;
};
// section: see sectionNearness(). The silhouette of a wall, and where it is cut the cut itself. Openings are
// not taken out.
std::vector<WallFace> wallFaces(const Home& home, WallId id, const Wall& wall, Plane plane, double section);

}  // namespace idap
