// Puts a piece of the catalog into the home: it follows the pointer, snaps, and is there after a click. The
// piece is previewed in a transaction of the document, so that all planes show it as it will be.
#pragma once

#include <memory>
#include <optional>

#include "catalog/catalog.h"
#include "editor/tool.h"

namespace idap {

// once: back to selecting after one piece (a drag from the catalog); otherwise more of the same follow until
// Escape.
std::unique_ptr<Tool> makePlaceTool(CatalogPiecePtr piece, bool once);

// A passage with no door in it: what the "opening" tool of the registry does.
std::unique_ptr<Tool> makeBareOpeningTool();

// Puts a piece where it fits without a pointer (Enter in the catalog): a door or window into the longest free
// stretch of wall, furniture as people put it (beds with the head to a wall, night tables beside them, chairs
// at tables, lamps on them or at the ceiling), free of others and of doors: beside what is selected, else in
// the room around near. Selects it. False when it had to refuse (no wall for a door), with words to the user.
bool placeAutomatically(Editor& editor, const CatalogPiece& piece, std::optional<Vec2> near = {});

// The catalog piece ready to be placed: named in the user's language, hung from the ceiling of the current
// level where it hangs, its price in the home's currency.
Furniture readyFurniture(const Editor& editor, const CatalogPiece& piece, Vec2 at);
Opening readyOpening(const Editor& editor, const CatalogPiece& piece, Vec2 at);

}  // namespace idap
