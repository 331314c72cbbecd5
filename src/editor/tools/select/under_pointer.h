// What the pointer of the select tool means where it is: which element, which edge of what is being worked
// on.
#pragma once

#include <optional>
#include <vector>

#include "editor/editor.h"

namespace idap {

inline constexpr double kClickReach = 5;  // pixels

// Groups as one, but the pieces of the group that the user has gone into singly.
std::vector<AnyId> meantAt(const Editor& editor, const PointerEvent& event);

// The floor of a room, a wall that is looked at: a drag that begins there does not mean them.
bool isGround(const Editor& editor, Plane plane, AnyId id);

// The edge of the selected room or polyline under the pointer, by the index that a new point on it gets.
std::optional<std::size_t> ownEdge(const Editor& editor, const PointerEvent& event);
Home withPoint(const Home& home, AnyId id, std::size_t at, Vec2 point);

}  // namespace idap
