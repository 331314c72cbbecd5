// Locking, hiding and showing pieces.
#include <algorithm>

#include "editor/commands/command_list.h"
#include "model/edits/piece_edits.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

// Locked ones too: this is how they are unlocked.
template <class F>
bool anySelectedPiece(const Editor& editor, F question) {
  const Elements all = withGroups(editor.home(), editor.selection());
  return std::any_of(all.openings.begin(), all.openings.end(),
                     [&](OpeningId id) { return question(*editor.home().openings.find(id)); }) ||
         std::any_of(all.furniture.begin(), all.furniture.end(),
                     [&](FurnitureId id) { return question(*editor.home().furniture.find(id)); });
}
bool anyPieceSelected(const Editor& editor) {
  return anySelectedPiece(editor, [](const Piece&) { return true; });
}

bool allLocked(const Editor& editor) {
  return anyPieceSelected(editor) &&
         !anySelectedPiece(editor, [](const Piece& piece) { return !piece.locked; });
}
void toggleLock(Editor& editor) {
  const bool lock = !allLocked(editor);
  editor.apply(lock ? QT_TRANSLATE_NOOP("idap", "Lock") : QT_TRANSLATE_NOOP("idap", "Unlock"),
               [&](const Home& home) {
                 return changePieces(home, editor.selection(), [lock](Piece& p) { p.locked = lock; });
               });
}

// A group is hidden as one: its members keep what they were.
Home shown(const Home& home, const Elements& elements, bool visible) {
  Home next = home;
  changeEach(next.groups, elements.groups, [visible](Group& group) { group.visible = visible; });
  changeEach(next.openings, elements.openings, [visible](Opening& piece) { piece.visible = visible; });
  changeEach(next.furniture, elements.furniture, [visible](Furniture& piece) { piece.visible = visible; });
  return next;
}
bool anySelectedThatIs(const Editor& editor, bool visible) {
  const auto any = [visible](const auto& table, const auto& ids) {
    return std::any_of(ids.begin(), ids.end(), [&](auto id) {
      const auto* found = table.find(id);
      return found && found->visible == visible;
    });
  };
  const Elements& chosen = editor.selection();
  return any(editor.home().groups, chosen.groups) || any(editor.home().openings, chosen.openings) ||
         any(editor.home().furniture, chosen.furniture);
}

bool anyHidden(const Editor& editor) {
  const auto any = [](const auto& table) {
    return std::any_of(table.begin(), table.end(), [](const auto& entry) { return !entry.second->visible; });
  };
  return any(editor.home().groups) || any(editor.home().openings) || any(editor.home().furniture);
}
void showAll(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Show all"), [](const Home& home) {
    Home next = home;
    const auto show = [](auto& table) {
      changeWhere(
          table, [](const auto& element) { return !element.visible; },
          [](auto& element) { element.visible = true; });
    };
    show(next.groups);
    show(next.openings);
    show(next.furniture);
    return next;
  });
}

}  // namespace

std::vector<Command> visibilityCommands() {
  return {
      {.id = "lock",
       .name = QT_TRANSLATE_NOOP("idap", "Locked"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Keeps what is selected where it is: it can be selected, but neither moved "
                                "nor deleted until it is unlocked"),
       .shortcut = "Ctrl+L",
       .enabled = anyPieceSelected,
       .checked = allLocked,
       .run = toggleLock,
       .inContextMenu = true,
       .separatorBefore = true},
      {.id = "hide",
       .name = QT_TRANSLATE_NOOP("idap", "Hide"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Takes what is selected out of plans and pictures without deleting it; the "
                                "furniture list still has it"),
       .shortcut = "Ctrl+H",
       .enabled = [](const Editor& editor) { return anySelectedThatIs(editor, true); },
       .run =
           [](Editor& editor) {
             editor.apply(QT_TRANSLATE_NOOP("idap", "Hide"),
                          [&](const Home& home) { return shown(home, editor.selection(), false); });
           },
       .inContextMenu = true},
      {.id = "show",
       .name = QT_TRANSLATE_NOOP("idap", "Show"),
       .tip = QT_TRANSLATE_NOOP("idap", "Shows what is selected in the list but hidden in the plans"),
       .enabled = [](const Editor& editor) { return anySelectedThatIs(editor, false); },
       .run =
           [](Editor& editor) {
             editor.apply(QT_TRANSLATE_NOOP("idap", "Show"),
                          [&](const Home& home) { return shown(home, editor.selection(), true); });
           },
       .inContextMenu = true},
      {.id = "show-all",
       .name = QT_TRANSLATE_NOOP("idap", "Show all hidden"),
       .tip = QT_TRANSLATE_NOOP("idap", "Shows all pieces and groups that were hidden, on every level"),
       .shortcut = "Ctrl+Shift+H",
       .enabled = anyHidden,
       .run = showAll},
  };
}

}  // namespace idap
