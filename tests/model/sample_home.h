// Homes for tests: one that uses every field with a value of its own, and big regular ones.
#pragma once

#include <cstddef>

#include "model/home.h"

namespace idap::test {

// At least one element of each kind, every field different from its default. Valid.
Home fullHome();

// A two-room flat of 6 m by 4 m with a door, a window and a table in a group. Valid.
Home smallFlat();

// A grid of pieces.
Home manyPieces(std::size_t count);

}  // namespace idap::test
