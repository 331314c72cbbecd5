// The outline of any element on a plane, to point it out.
#pragma once

#include "editor/overlay.h"
#include "editor/plane.h"
#include "editor/selection.h"

namespace idap {

// No points for what does not exist.
PreviewShape shapeOf(const Home& home, Plane plane, AnyId id);

}  // namespace idap
