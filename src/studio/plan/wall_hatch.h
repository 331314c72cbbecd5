// How walls are filled on the plan: solid, or hatched by the name of a pattern ("hatchUp", "crossHatch", …,
// the names that Sweet Home 3D's files use).
#pragma once

#include <QPainterPath>
#include <string>

#include "studio/plan/canvas.h"

namespace idap {

// Opaque, without an outline. One path for all walls that are filled alike: no seams where they meet. An
// empty or unknown name: solid poché.
void fillWall(Canvas& canvas, const QPainterPath& path, const std::string& pattern);

}  // namespace idap
