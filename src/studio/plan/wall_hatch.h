// How walls are filled on the plan: solid, or hatched by the name of a pattern ("hatchUp", "crossHatch", …,
// the names that Sweet Home 3D's files use).
#pragma once

#include <QPolygonF>
#include <string>

#include "studio/plan/canvas.h"

namespace idap {

// Opaque, without an outline. An empty or unknown name: solid poché.
void fillWall(Canvas& canvas, const QPolygonF& polygon, const std::string& pattern);

}  // namespace idap
