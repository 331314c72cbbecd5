// What is under the pointer, and in a rectangle, in each of the planes.
#pragma once

#include <vector>

#include "editor/editor.h"

namespace idap {

// All that can be selected at a point, the one that is meant first: what is small and in front goes before
// what is large and behind. tolerance in metres. Pieces in a group are given by their outermost group; what
// is hidden, on other levels or locked away (EditorSettings::baseLocked) is not there.
std::vector<AnyId> hitsAt(const Editor& editor, Plane plane, Vec2 at, double tolerance);
// The same with the pieces themselves instead of their groups.
std::vector<AnyId> membersAt(const Editor& editor, Plane plane, Vec2 at, double tolerance);

// All that lies in the rectangle between two corners; dragged from right to left (to.x < from.x) also what it
// only touches, as in CAD programs. A group counts when one of its pieces does.
Elements hitsIn(const Editor& editor, Plane plane, Vec2 from, Vec2 to);

}  // namespace idap
