#include <algorithm>

#include "editor/commands/command_list.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/piece_edits.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

std::size_t groupable(const Elements& elements) {
  return elements.furniture.size() + elements.openings.size() + elements.groups.size();
}
bool canGroup(const Editor& editor) { return groupable(editor.selection()) >= 2; }
bool canUngroup(const Editor& editor) { return !editor.selection().groups.empty(); }
bool anyFurniture(const Editor& editor) {
  const Elements chosen = changeable(editor);
  return !chosen.furniture.empty() || !chosen.groups.empty();
}

void group(Editor& editor) {
  GroupId made;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Group"), [&](const Home& home) {
    GroupEdit edit = groupElements(home, editor.selection(), newName(editor, NewName::Group));
    made = edit.group;
    return std::move(edit.home);
  });
  if (!done) return;
  Elements chosen = editor.selection();
  chosen.furniture.clear();
  chosen.openings.clear();
  chosen.groups = {made};
  editor.select(std::move(chosen));
}

void ungroupSelected(Editor& editor) {
  Elements freed = editor.selection();
  const std::vector<GroupId> gone = freed.groups;
  freed.groups.clear();
  const auto members = [&gone](const auto& table, auto& ids, auto parent) {
    for (const auto& [id, element] : table)
      if (std::find(gone.begin(), gone.end(), (*element).*parent) != gone.end()) ids.push_back(id);
  };
  members(editor.home().furniture, freed.furniture, &Furniture::group);
  members(editor.home().openings, freed.openings, &Opening::group);
  members(editor.home().groups, freed.groups, &Group::parent);
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Ungroup"), [&gone](Home home) {
    for (const GroupId id : gone) home = ungroup(home, id);
    return home;
  });
  if (done) editor.select(std::move(freed));
}

void resetElevation(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Reset elevation"),
               [&](const Home& home) { return resetElevations(home, changeable(editor)); });
}

void toFloor(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Put on the floor"), [&](const Home& home) {
    Home next = home;
    const Elements chosen = changeable(editor);
    changeEach(next.furniture, chosen.furniture, [](Furniture& piece) { piece.position.z = 0; });
    for (const GroupId id : chosen.groups) {
      Elements one;
      one.groups = {id};
      const Elements members = withGroups(home, one);
      double lowest = kPi * 1e6;
      for (const FurnitureId member : members.furniture)
        lowest = std::min(lowest, home.furniture.find(member)->position.z);
      changeEach(next.furniture, members.furniture, [lowest](Furniture& p) { p.position.z -= lowest; });
    }
    return next;
  });
}

// The lamps of the selection, or all of the home where nothing is selected.
std::vector<FurnitureId> lamps(const Editor& editor, bool on) {
  std::vector<FurnitureId> found;
  const auto add = [&](FurnitureId id, const Furniture* piece) {
    if (piece && piece->lamp && piece->lamp->on != on) found.push_back(id);
  };
  if (empty(editor.selection())) {
    for (const auto& [id, piece] : editor.home().furniture) add(id, piece.get());
  } else {
    for (const FurnitureId id : withGroups(editor.home(), editor.selection()).furniture)
      add(id, editor.home().furniture.find(id));
  }
  return found;
}
void switchLamps(Editor& editor, bool on) {
  editor.apply(
      on ? QT_TRANSLATE_NOOP("idap", "Switch lamps on") : QT_TRANSLATE_NOOP("idap", "Switch lamps off"),
      [&](const Home& home) {
        Home next = home;
        changeEach(next.furniture, lamps(editor, on), [on](Furniture& p) { p.lamp->on = on; });
        return next;
      });
}

}  // namespace

std::vector<Command> furnitureCommands() {
  return {
      {.id = "group",
       .name = QT_TRANSLATE_NOOP("idap", "Group"),
       .tip = QT_TRANSLATE_NOOP("idap", "Makes one of the selected pieces, to be moved and turned together"),
       .shortcut = "Ctrl+G",
       .menu = Menu::Furniture,
       .enabled = canGroup,
       .run = group,
       .inContextMenu = true,
       .separatorBefore = true},
      {.id = "ungroup",
       .name = QT_TRANSLATE_NOOP("idap", "Ungroup"),
       .tip = QT_TRANSLATE_NOOP("idap", "Takes the selected groups apart; their pieces stay where they are"),
       .shortcut = "Ctrl+Shift+G",
       .menu = Menu::Furniture,
       .enabled = canUngroup,
       .run = ungroupSelected,
       .inContextMenu = true},
      {.id = "reset-elevation",
       .name = QT_TRANSLATE_NOOP("idap", "Reset elevation"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Lets the selected pieces stand on what is under them: a table or the floor"),
       .menu = Menu::Furniture,
       .enabled = anyFurniture,
       .run = resetElevation,
       .separatorBefore = true},
      {.id = "to-floor",
       .name = QT_TRANSLATE_NOOP("idap", "Put on the floor"),
       .tip = QT_TRANSLATE_NOOP("idap", "Lowers or raises the selected pieces to the floor of their level"),
       .menu = Menu::Furniture,
       .enabled = anyFurniture,
       .run = toFloor},
      {.id = "lamps-on",
       .name = QT_TRANSLATE_NOOP("idap", "Switch lamps on"),
       .tip = QT_TRANSLATE_NOOP(
           "idap", "Switches the selected lamps on, or all of the home when nothing is selected"),
       .menu = Menu::Furniture,
       .enabled = [](const Editor& editor) { return !lamps(editor, true).empty(); },
       .run = [](Editor& editor) { switchLamps(editor, true); },
       .separatorBefore = true},
      {.id = "lamps-off",
       .name = QT_TRANSLATE_NOOP("idap", "Switch lamps off"),
       .tip = QT_TRANSLATE_NOOP(
           "idap", "Switches the selected lamps off, or all of the home when nothing is selected"),
       .menu = Menu::Furniture,
       .enabled = [](const Editor& editor) { return !lamps(editor, false).empty(); },
       .run = [](Editor& editor) { switchLamps(editor, false); }},
  };
}

}  // namespace idap
