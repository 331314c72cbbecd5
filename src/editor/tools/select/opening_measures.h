// How far a door or window is from what is beside it in its wall, and from the floor.
#pragma once

#include <vector>

#include "editor/overlay.h"
#include "editor/plane.h"
#include "model/edits/element_edits.h"

namespace idap {

// To the next opening or the corner on both sides; from the side also the height of its sill.
std::vector<MeasureLine> openingMeasures(const Home& home, Plane plane, const Opening& opening,
                                         const Elements& ignored);

}  // namespace idap
