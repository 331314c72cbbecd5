#include "editor/commands/command_list.h"
#include "model/edits/arrange_edits.h"

namespace idap {

namespace {

bool anything(const Editor& editor) { return !empty(everything(editor.home(), std::nullopt)); }

void flip(Editor& editor, bool horizontally) {
  editor.apply(horizontally ? QT_TRANSLATE_NOOP("idap", "Flip plan horizontally")
                            : QT_TRANSLATE_NOOP("idap", "Flip plan vertically"),
               [horizontally](const Home& home) { return flipPlan(home, horizontally); });
}

template <bool EditorSettings::*setting>
bool isOn(const Editor& editor) {
  return editor.settings().*setting;
}
template <bool EditorSettings::*setting>
void toggle(Editor& editor) {
  EditorSettings settings = editor.settings();
  settings.*setting = !(settings.*setting);
  editor.setSettings(std::move(settings));
}

void toggleBase(Editor& editor) {
  toggle<&EditorSettings::baseLocked>(editor);
  if (editor.settings().baseLocked) editor.select(withoutBase(editor.selection()));
}

}  // namespace

std::vector<Command> planCommands() {
  return {
      {.id = "lock-base",
       .name = QT_TRANSLATE_NOOP("idap", "Lock base plan"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Walls, rooms, doors, windows, dimensions and labels cannot be selected "
                                "then: furniture is arranged without moving them by mistake"),
       .shortcut = "Ctrl+Shift+L",
       .menu = Menu::Plan,
       .checked = isOn<&EditorSettings::baseLocked>,
       .run = toggleBase},
      {.id = "flip-horizontally",
       .name = QT_TRANSLATE_NOOP("idap", "Flip horizontally"),
       .tip = QT_TRANSLATE_NOOP("idap", "Exchanges left and right of the whole plan, on all levels"),
       .menu = Menu::Plan,
       .enabled = anything,
       .run = [](Editor& editor) { flip(editor, true); },
       .separatorBefore = true},
      {.id = "flip-vertically",
       .name = QT_TRANSLATE_NOOP("idap", "Flip vertically"),
       .tip = QT_TRANSLATE_NOOP("idap", "Exchanges top and bottom of the whole plan, on all levels"),
       .menu = Menu::Plan,
       .enabled = anything,
       .run = [](Editor& editor) { flip(editor, false); }},
      {.id = "snapping",
       .name = QT_TRANSLATE_NOOP("idap", "Snapping"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "What is drawn or moved jumps to ends, lines, walls, right angles and other "
                                "pieces; hold Alt to suspend it"),
       .shortcut = "F3",
       .menu = Menu::Plan,
       .checked = isOn<&EditorSettings::snapping>,
       .run = toggle<&EditorSettings::snapping>,
       .separatorBefore = true},
      {.id = "grid-snapping",
       .name = QT_TRANSLATE_NOOP("idap", "Snap to grid"),
       .tip = QT_TRANSLATE_NOOP("idap", "What is drawn or moved keeps to the lines of the grid"),
       .shortcut = "Shift+F7",
       .menu = Menu::Plan,
       .checked = isOn<&EditorSettings::gridSnapping>,
       .run = toggle<&EditorSettings::gridSnapping>},
      {.id = "room-areas",
       .name = QT_TRANSLATE_NOOP("idap", "Rooms by themselves"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Walls that close an area get a room with a floor and a ceiling at once"),
       .menu = Menu::Plan,
       .checked = isOn<&EditorSettings::roomAreas>,
       .run = toggle<&EditorSettings::roomAreas>},
      {.id = "show-grid",
       .name = QT_TRANSLATE_NOOP("idap", "Grid"),
       .tip = QT_TRANSLATE_NOOP("idap", "Shows the grid under the plans, to judge sizes by"),
       .shortcut = "F7",
       .menu = Menu::View,
       .checked = isOn<&EditorSettings::gridShown>,
       .run = toggle<&EditorSettings::gridShown>},
      {.id = "show-rulers",
       .name = QT_TRANSLATE_NOOP("idap", "Rulers"),
       .tip = QT_TRANSLATE_NOOP("idap", "Shows rulers at the top and left of the plans"),
       .menu = Menu::View,
       .checked = isOn<&EditorSettings::rulersShown>,
       .run = toggle<&EditorSettings::rulersShown>},
      {.id = "show-level-below",
       .name = QT_TRANSLATE_NOOP("idap", "Level below"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Shows the level below faintly under the current one, to draw walls above "
                                "walls"),
       .menu = Menu::View,
       .checked = isOn<&EditorSettings::levelBelowShown>,
       .run = toggle<&EditorSettings::levelBelowShown>},
  };
}

}  // namespace idap
