#include "editor/tools/place_tool.h"

#include "editor/editor.h"
#include "editor/tools/place_furniture_tool.h"
#include "editor/tools/place_opening_tool.h"
#include "editor/tools/tool_list.h"

namespace idap {

namespace {

std::vector<ToolKey> openingKeys() {
  return {{"R", QT_TRANSLATE_NOOP("idap", "the next way it opens")},
          {"0-9", QT_TRANSLATE_NOOP("idap", "type a distance")},
          {"Tab", QT_TRANSLATE_NOOP("idap", "the other end, the sill")},
          {"Enter", QT_TRANSLATE_NOOP("idap", "place it")},
          {"Esc", QT_TRANSLATE_NOOP("idap", "stop")}};
}

const ToolInfo kPlaceOpening{"place",
                             QT_TRANSLATE_NOOP("idap", "Place"),
                             QT_TRANSLATE_NOOP("idap", "Put a piece of the catalog into the home"),
                             QT_TRANSLATE_NOOP("idap", "Click the wall where it is to be"),
                             "",
                             openingKeys()};
const ToolInfo kDoor{
    "door",
    QT_TRANSLATE_NOOP("idap", "Door"),
    QT_TRANSLATE_NOOP("idap", "Put doors into walls; other kinds of doors are in the catalog"),
    QT_TRANSLATE_NOOP("idap", "Click the wall where the door is to be, on the side it opens to"),
    "D",
    openingKeys()};
const ToolInfo kWindow{"window",
                       QT_TRANSLATE_NOOP("idap", "Window"),
                       QT_TRANSLATE_NOOP("idap", "Put windows into walls; other kinds are in the catalog"),
                       QT_TRANSLATE_NOOP("idap", "Click the wall where the window is to be"),
                       "N",
                       openingKeys()};
const ToolInfo kBare{"opening",
                     QT_TRANSLATE_NOOP("idap", "Opening"),
                     QT_TRANSLATE_NOOP("idap", "Cut passages into walls, with no door in them"),
                     QT_TRANSLATE_NOOP("idap", "Click the wall where the opening is to be"),
                     "Shift+D",
                     openingKeys()};

const char* editName(OpeningKind kind) {
  switch (kind) {
    case OpeningKind::Door:
      return QT_TRANSLATE_NOOP("idap", "Add door");
    case OpeningKind::Window:
      return QT_TRANSLATE_NOOP("idap", "Add window");
    default:
      return QT_TRANSLATE_NOOP("idap", "Add opening");
  }
}

OpeningKind kindOf(const CatalogPiece& piece) {
  return piece.kind == PieceKind::Door ? OpeningKind::Door : OpeningKind::Window;
}

// The catalog's plainest, or the first of its kind.
std::optional<Opening> plainest(const Editor& editor, const char* id, PieceKind kind) {
  CatalogPiecePtr piece = editor.catalog().find(id);
  if (!piece)
    for (const CatalogPiecePtr& other : editor.catalog().pieces())
      if (other->kind == kind) {
        piece = other;
        break;
      }
  if (!piece) return std::nullopt;
  return readyOpening(editor, *piece, {});
}

Opening bareOpening(const Editor& editor) {
  Opening opening;
  opening.kind = OpeningKind::Bare;
  opening.level = editor.level();
  opening.size = {0.9, editor.settings().wallThickness, 2.1};
  opening.cutsBothSides = true;
  return opening;
}

}  // namespace

std::unique_ptr<Tool> makePlaceTool(CatalogPiecePtr piece, bool once) {
  if (piece->kind != PieceKind::Door && piece->kind != PieceKind::Window)
    return makePlaceFurnitureTool(std::move(piece), once);
  const char* name = editName(kindOf(*piece));
  return makePlaceOpeningTool({&kPlaceOpening, name,
                               [piece = std::move(piece)](const Editor& editor) -> std::optional<Opening> {
                                 return readyOpening(editor, *piece, {});
                               },
                               once});
}

ToolEntry doorTool() {
  return {&kDoor, [] {
            return makePlaceOpeningTool({&kDoor, editName(OpeningKind::Door), [](const Editor& e) {
                                           return plainest(e, "idap/door-flush", PieceKind::Door);
                                         }});
          }};
}

ToolEntry windowTool() {
  return {&kWindow, [] {
            return makePlaceOpeningTool({&kWindow, editName(OpeningKind::Window), [](const Editor& e) {
                                           return plainest(e, "idap/window-double", PieceKind::Window);
                                         }});
          }};
}

ToolEntry openingTool() {
  return {&kBare, [] {
            return makePlaceOpeningTool({&kBare, editName(OpeningKind::Bare),
                                         [](const Editor& e) { return std::optional(bareOpening(e)); }});
          }};
}

std::unique_ptr<Tool> makeBareOpeningTool() { return openingTool().make(); }

}  // namespace idap
