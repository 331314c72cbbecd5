// What is under the pointer, and in a rectangle, in each of the planes.
#pragma once

#include <vector>

#include "editor/editor.h"

namespace idap {

// All that can be selected at a point, the one that is meant first: what is small and in front goes before
// what is large and behind. tolerance in metres. Pieces in a group are given by their outermost group; what
// is hidden or locked away (EditorSettings::baseLocked) is not there.
std::vector<AnyId> hitsAt(const Editor& editor, Plane plane, Vec2 at, double tolerance);

// All that lies in the rectangle between two corners; dragged from right to left (to.x < from.x) also what it
// only touches, as in CAD programs.
Elements hitsIn(const Editor& editor, Plane plane, Vec2 from, Vec2 to);

}  // namespace idap
