// The model of a piece, from the catalog or from the files that came with the home.
#pragma once

#include "catalog/catalog.h"
#include "model/home.h"

namespace idap {

// Null when the piece names none or it is gone. Throws ParseError for a damaged file. Any thread.
SurfaceModelPtr pieceModel(const Piece& piece, const Assets& assets, const Catalog& catalog);

}  // namespace idap
