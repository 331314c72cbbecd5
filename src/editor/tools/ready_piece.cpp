// Catalog pieces as they come to hand: named, at their height, on the level that is drawn on.
#include <algorithm>

#include "editor/editor.h"
#include "editor/tools/place_tool.h"
#include "model/edits/level_edits.h"

namespace idap {

Furniture readyFurniture(const Editor& editor, const CatalogPiece& piece, Vec2 at) {
  Furniture furniture = makeFurniture(piece, {at.x, at.y, 0});
  furniture.level = editor.level();
  furniture.name = piece.nameIn(editor.settings().language);
  if (piece.ceilingMounted)
    furniture.position.z = std::max(0.0, ceilingHeight(editor.home(), editor.level()) - furniture.size.z);
  return furniture;
}

Opening readyOpening(const Editor& editor, const CatalogPiece& piece, Vec2 at) {
  Opening opening = makeOpening(piece, {at.x, at.y, 0});
  opening.level = editor.level();
  opening.name = piece.nameIn(editor.settings().language);
  return opening;
}

}  // namespace idap
