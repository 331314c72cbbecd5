#include "gui/window/window_fixture.h"

#include "editor/tools/place_tool.h"
#include "model/edits/piece_edits.h"

namespace idap::test {

FurnitureId WindowTest::put(const char* catalogId, Vec2 at) {
  FurnitureId id;
  const CatalogPiecePtr piece = editor().catalog().find(catalogId);
  EXPECT_TRUE(piece) << catalogId;
  if (!piece) return id;
  editor().apply("Add", [&](const Home& home) {
    FurnitureEdit edit = addFurniture(home, readyFurniture(editor(), *piece, at));
    id = edit.furniture;
    return edit.home;
  });
  return id;
}

}  // namespace idap::test
