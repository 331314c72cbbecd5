#include <algorithm>

#include "editor/commands/command_list.h"
#include "model/edits/level_edits.h"

namespace idap {

namespace {

const Level* current(const Editor& editor) { return editor.home().levels.find(editor.level()); }

bool hasLevels(const Editor& editor) { return current(editor) != nullptr; }
bool hasMoreLevels(const Editor& editor) { return hasLevels(editor) && editor.home().levels.size() > 1; }
bool canMove(const Editor& editor, bool up) {
  if (!hasLevels(editor)) return false;
  const std::vector<LevelId> order = levelsInOrder(editor.home());
  return editor.level() != (up ? order.back() : order.front());
}

// A number that no level has yet, so that names stay apart when levels were deleted in between.
std::string freeName(const Editor& editor, const Home& home) {
  for (int number = static_cast<int>(home.levels.size());; ++number) {
    std::string name = newName(editor, NewName::Level, number);
    const bool taken = std::any_of(home.levels.begin(), home.levels.end(),
                                   [&name](const auto& entry) { return entry.second->name == name; });
    if (!taken) return name;
  }
}

void add(Editor& editor, bool sameElevation) {
  LevelId added;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Add level"), [&](const Home& home) {
    const LevelEdit ground = withLevels(home, newName(editor, NewName::Level, 0));
    const LevelId above = home.levels.contains(editor.level()) ? editor.level() : ground.level;
    LevelEdit edit = addLevel(ground.home, above, freeName(editor, ground.home), sameElevation);
    added = edit.level;
    return std::move(edit.home);
  });
  if (done) editor.setLevel(added);
}

void remove(Editor& editor) {
  const LevelId gone = editor.level();
  const std::vector<LevelId> order = levelsInOrder(editor.home());
  const auto at = std::find(order.begin(), order.end(), gone);
  if (at == order.end()) return;
  // The one below comes up, as the floor one falls to.
  const LevelId next = at != order.begin() ? *(at - 1) : order.size() > 1 ? *(at + 1) : LevelId{};
  if (editor.apply(QT_TRANSLATE_NOOP("idap", "Delete level"),
                   [gone](const Home& home) { return deleteLevel(home, gone); }))
    editor.setLevel(next);
}

void reorder(Editor& editor, bool up) {
  editor.apply(up ? QT_TRANSLATE_NOOP("idap", "Move level up") : QT_TRANSLATE_NOOP("idap", "Move level down"),
               [&](const Home& home) { return reorderLevel(home, editor.level(), up); });
}

Home withVisible(const Home& home, LevelId id, bool visible) {
  Level level = *home.levels.find(id);
  level.visible = visible;
  return setLevel(home, id, level);
}

bool isVisible(const Editor& editor) { return hasLevels(editor) && current(editor)->visible; }
void toggleVisible(Editor& editor) {
  if (!hasLevels(editor)) return;
  const bool visible = !isVisible(editor);
  editor.apply(visible ? QT_TRANSLATE_NOOP("idap", "Show level") : QT_TRANSLATE_NOOP("idap", "Hide level"),
               [&](const Home& home) { return withVisible(home, editor.level(), visible); });
}

bool isAlone(const Editor& editor) {
  return hasMoreLevels(editor) &&
         std::all_of(editor.home().levels.begin(), editor.home().levels.end(), [&](const auto& entry) {
           return entry.second->visible == (entry.first == editor.level());
         });
}
void toggleAlone(Editor& editor) {
  if (!hasLevels(editor)) return;
  const bool alone = !isAlone(editor);
  editor.apply(alone ? QT_TRANSLATE_NOOP("idap", "Show only this level")
                     : QT_TRANSLATE_NOOP("idap", "Show all levels"),
               [&](Home home) {
                 for (const auto& [id, level] : home.levels)
                   home = withVisible(home, id, !alone || id == editor.level());
                 return home;
               });
}

}  // namespace

std::vector<Command> levelCommands() {
  return {
      {.id = "add-level",
       .name = QT_TRANSLATE_NOOP("idap", "Add level above"),
       .tip = QT_TRANSLATE_NOOP("idap", "Adds a storey on top of the current one; what is above moves up"),
       .menu = Menu::Levels,
       .run = [](Editor& editor) { add(editor, false); }},
      {.id = "add-level-same",
       .name = QT_TRANSLATE_NOOP("idap", "Add level at same elevation"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Adds a level at the height of the current one, for a variant or another "
                                "part of the house"),
       .menu = Menu::Levels,
       .run = [](Editor& editor) { add(editor, true); }},
      {.id = "level-up",
       .name = QT_TRANSLATE_NOOP("idap", "Move level up"),
       .tip = QT_TRANSLATE_NOOP("idap", "Exchanges the current level with the one above it"),
       .menu = Menu::Levels,
       .enabled = [](const Editor& editor) { return canMove(editor, true); },
       .run = [](Editor& editor) { reorder(editor, true); },
       .separatorBefore = true},
      {.id = "level-down",
       .name = QT_TRANSLATE_NOOP("idap", "Move level down"),
       .tip = QT_TRANSLATE_NOOP("idap", "Exchanges the current level with the one below it"),
       .menu = Menu::Levels,
       .enabled = [](const Editor& editor) { return canMove(editor, false); },
       .run = [](Editor& editor) { reorder(editor, false); }},
      {.id = "level-visible",
       .name = QT_TRANSLATE_NOOP("idap", "Level visible"),
       .tip = QT_TRANSLATE_NOOP("idap", "Shows or hides the current level in pictures"),
       .menu = Menu::Levels,
       .enabled = hasLevels,
       .checked = isVisible,
       .run = toggleVisible,
       .separatorBefore = true},
      {.id = "level-alone",
       .name = QT_TRANSLATE_NOOP("idap", "Only this level"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Hides all other levels in pictures, to see into this one from above; once "
                                "more shows them all"),
       .menu = Menu::Levels,
       .enabled = hasMoreLevels,
       .checked = isAlone,
       .run = toggleAlone},
      {.id = "delete-level",
       .name = QT_TRANSLATE_NOOP("idap", "Delete level"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Takes away the current level with all that stands on it. Undo brings it "
                                "back"),
       .menu = Menu::Levels,
       .enabled = hasMoreLevels,
       .run = remove,
       .separatorBefore = true},
  };
}

}  // namespace idap
