// The place tool for what stands, hangs or lies in a room.
#pragma once

#include <memory>

#include "catalog/catalog.h"
#include "editor/tool.h"

namespace idap {

std::unique_ptr<Tool> makePlaceFurnitureTool(CatalogPiecePtr piece, bool once);

// What the undo menu calls putting it there.
const char* addingName(const CatalogPiece& piece);

}  // namespace idap
