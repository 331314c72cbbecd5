#include "editor/editor.h"
#include "editor/tools/place_tool.h"
#include "model/edits/piece_edits.h"

namespace idap {

bool placeAutomatically(Editor& editor, const CatalogPiece& piece, std::optional<Vec2> near) {
  const Furniture ready = readyFurniture(editor, piece, near.value_or(Vec2{}));
  FurnitureId id;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Add furniture"), [&](const Home& home) {
    FurnitureEdit edit = addFurniture(home, ready);
    id = edit.furniture;
    return std::move(edit.home);
  });
  if (done) editor.select(only(id));
  return done;
}

}  // namespace idap
