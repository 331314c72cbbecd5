// What can be done to the selection or the home at once, without a tool: delete, align, group, … Menus,
// shortcuts and context menus are made from this one table.
#pragma once

#include <vector>

#include "editor/editor.h"

namespace idap {

enum class Menu { Edit, Furniture, Plan, Walls, Levels, View };

struct Command {
  const char* id = "";        // "align-left"; also the name of its icon, where there is one
  const char* name = "";      // marked for translation, in the menu
  const char* tip = "";       // what it does and why one would want it
  const char* shortcut = "";  // as Qt writes keys; empty: none
  Menu menu = Menu::Edit;
  const char* submenu = "";                  // marked for translation: "Align"; empty: none
  bool (*enabled)(const Editor&) = nullptr;  // null: always
  bool (*checked)(const Editor&) = nullptr;  // null: not a switch
  void (*run)(Editor&) = nullptr;
  bool inContextMenu = false;
  bool separatorBefore = false;
};

// To add one: a function in a file of this folder and a line in its table, which commands() joins.
const std::vector<Command>& commands();
const Command* findCommand(const std::string& id);

}  // namespace idap
