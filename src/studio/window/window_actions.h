// Every action of a window by its id: those of the tables of tools and commands, and the window's own.
// Written in English once, put into the user's language as often as that changes.
#pragma once

#include <QAction>
#include <QObject>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "editor/editor.h"

class QWidget;

namespace idap {

struct Command;

struct ActionText {
  const char* id = "";        // also the name of its icon
  const char* name = "";      // marked for translation, in menus
  const char* tip = "";       // what it does and why one would want it
  const char* shortcut = "";  // as Qt writes keys, several separated by "; "; empty: none
  const char* word = "";      // under its icon in the toolbar, where the name is too long
};

class WindowActions : public QObject {
  Q_OBJECT
 public:
  // Makes the actions of all tools ("tool-wall") and commands (by their ids).
  WindowActions(Editor& editor, QWidget* window);

  QAction* add(const ActionText& text, std::function<void()> run);
  // A switch: run gets the new state.
  QAction* addSwitch(const ActionText& text, std::function<void(bool)> run);
  // Enabled as the function says whenever something changes.
  void enableBy(QAction* action, std::function<bool()> enabled);
  void checkBy(QAction* action, std::function<bool()> checked);
  void restWithoutHome(QAction* action);

  QAction* get(const std::string& id) const;  // null for an unknown one
  const std::map<std::string, QAction*>& all() const { return actions_; }

  void refresh();      // enabled and checked
  void retranslate();  // and the icons, which follow the theme
  // Without a home the actions of tools, of commands and of restWithoutHome() are disabled.
  void setHomeOpen(bool open);

 private:
  struct Entry {
    QAction* action;
    ActionText text;
    std::function<bool()> enabled, checked;
    bool ofHome = false;
  };
  Entry& entry(QAction* action);
  QAction* make(const ActionText& text, const std::string& id);

  Editor& editor_;
  QWidget* window_;
  std::vector<Entry> entries_;
  std::map<std::string, QAction*> actions_;
  bool homeOpen_ = false;
};

}  // namespace idap
