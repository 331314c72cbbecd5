// Moving what is selected, whatever it is: what may move at all, and how each kind moves best.
#pragma once

#include <optional>

#include "editor/editor.h"

namespace idap {

// Without pieces that are locked, and groups that hold one.
Elements movable(const Home& home, const Elements& elements);

// Doors and windows slide along the wall they are in; a single wall that is joined to others moves parallel,
// and its neighbours grow or shrink; all else moves as it is.
Home moved(const Home& home, const Elements& elements, Vec3 by);

// The way that a single wall with neighbours can go: across itself. Nothing for other elements.
std::optional<Vec2> wallNormal(const Home& home, const Elements& elements);

// A piece with the size and place of the box around several.
Piece boxPiece(const Home& home, const Elements& elements);

}  // namespace idap
