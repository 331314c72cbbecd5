// The wall and the place in it for a door or window that nobody points out.
#pragma once

#include <optional>

#include "editor/editor.h"

namespace idap {

// Windows in the middle of the longest free stretch of an outer wall, doors near a corner; in the selected
// wall, if one is selected, and near the given point. None where no wall has room.
std::optional<Opening> openingSpot(const Editor& editor, const Opening& ready, const CatalogPiece& piece,
                                   std::optional<Vec2> near);

}  // namespace idap
