#include <algorithm>

#include "editor/commands/command_list.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/piece_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kStep = 0.2;  // m that a copy lies beside its original
constexpr double kGap = 0.1;   // m between a copied window and the first

bool anySelected(const Editor& editor) { return !empty(editor.selection()); }
bool anyChangeable(const Editor& editor) { return !empty(changeable(editor)); }

// While another tool is in hand the key is its own: it turns what is being placed.
bool canTurn(const Editor& editor) {
  return editor.selecting() && !editor.document().inTransaction() && anyChangeable(editor);
}

void deleteSelected(Editor& editor) {
  const Elements gone = changeable(editor);
  if (empty(gone)) return;
  const std::size_t kept = count(editor.selection()) - count(gone);
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Delete"), [&](const Home& home) {
    return followed(editor, home, deleteElements(home, gone));
  });
  if (done && kept > 0)
    editor.say({QT_TRANSLATE_NOOP("idap", "Locked, and therefore still there: %1"), {std::to_string(kept)}});
}

// A door copied alone goes aside in its wall, to where there is room; anything else towards the lower right.
Vec3 duplicateStep(const Home& home, const Elements& originals) {
  const Elements held = openingsInWalls(home, originals);
  if (held.openings.empty() || count(held) != count(originals)) return {kStep, -kStep, 0};
  const Opening& opening = *home.openings.find(held.openings.front());
  const WallPath path(*home.walls.find(opening.wall));
  const double at = path.nearest({opening.position.x, opening.position.y});
  const double step = opening.size.x + kGap;
  const bool forward = path.length() - at >= at;
  const double to = std::clamp(at + (forward ? step : -step), 0.0, path.length());
  const Vec2 by = path.point(to) - path.point(at);
  return {by.x, by.y, 0};
}

void duplicate(Editor& editor) {
  Elements copies;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Duplicate"), [&](const Home& home) {
    const Elements& originals = editor.selection();
    CopyEdit edit = duplicateElements(home, originals, duplicateStep(home, originals));
    copies = std::move(edit.copies);
    return followed(editor, home, std::move(edit.home));
  });
  if (done) editor.select(std::move(copies));
}

void rotate(Editor& editor, double angle) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Rotate"), [&](const Home& home) {
    Elements chosen = changeable(editor);
    const Elements held = openingsInWalls(home, chosen);
    std::erase_if(chosen.openings, [&](OpeningId id) { return contains(held, id); });
    const Home next = changePieces(
        home, held, [](Piece& piece) { piece.angle = std::remainder(piece.angle + kPi, 2 * kPi); });
    if (empty(chosen)) return next;
    const Vec3 middle = bounds(home, chosen).centre();
    return followed(editor, home, turnElements(next, chosen, {middle.x, middle.y}, angle));
  });
}

void mirror(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Mirror"), [&](const Home& home) {
    return followed(editor, home, mirrorElements(home, changeable(editor)));
  });
}

}  // namespace

std::vector<Command> editCommands() {
  return {
      {.id = "delete",
       .name = QT_TRANSLATE_NOOP("idap", "Delete"),
       .tip = QT_TRANSLATE_NOOP("idap", "Takes away what is selected. Undo brings it back"),
       .shortcut = "Del",
       .enabled = anyChangeable,
       .run = deleteSelected,
       .inContextMenu = true},
      {.id = "duplicate",
       .name = QT_TRANSLATE_NOOP("idap", "Duplicate"),
       .tip = QT_TRANSLATE_NOOP("idap", "Puts a copy of what is selected beside it, ready to be moved"),
       .shortcut = "Ctrl+D",
       .enabled = anySelected,
       .run = duplicate,
       .inContextMenu = true},
      {.id = "select-all",
       .name = QT_TRANSLATE_NOOP("idap", "Select all"),
       .tip = QT_TRANSLATE_NOOP("idap", "Selects all that can be selected on this level"),
       .shortcut = "Ctrl+A",
       .run = [](Editor& editor) { editor.select(selectable(editor, editor.level())); },
       .separatorBefore = true},
      {.id = "select-all-levels",
       .name = QT_TRANSLATE_NOOP("idap", "Select all on all levels"),
       .tip = QT_TRANSLATE_NOOP("idap", "Selects the whole home, to move or copy it as one"),
       .shortcut = "Ctrl+Shift+A",
       .enabled = [](const Editor& editor) { return editor.home().levels.size() > 1; },
       .run = [](Editor& editor) { editor.select(selectable(editor, std::nullopt)); }},
      {.id = "rotate-left",
       .name = QT_TRANSLATE_NOOP("idap", "Rotate left"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Turns what is selected by 90 degrees counter-clockwise about its middle; "
                                "a door or window in its wall to the other side"),
       .shortcut = "R",
       .enabled = canTurn,
       .run = [](Editor& editor) { rotate(editor, kPi / 2); },
       .inContextMenu = true,
       .separatorBefore = true},
      {.id = "rotate-right",
       .name = QT_TRANSLATE_NOOP("idap", "Rotate right"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Turns what is selected by 90 degrees clockwise about its middle; a door or "
                                "window in its wall to the other side"),
       .shortcut = "Shift+R",
       .enabled = canTurn,
       .run = [](Editor& editor) { rotate(editor, -kPi / 2); },
       .inContextMenu = true},
      {.id = "mirror",
       .name = QT_TRANSLATE_NOOP("idap", "Mirror"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Exchanges left and right: of one piece where it stands, of several about "
                                "their middle"),
       .shortcut = "Ctrl+M",
       .enabled = anyChangeable,
       .run = mirror,
       .inContextMenu = true},
  };
}

}  // namespace idap
