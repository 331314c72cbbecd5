// A tool: what the pointer and the keys do while it is in hand. It sees the home through the Editor, changes
// it by edits and transactions of the document, and never touches a widget.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "editor/input.h"
#include "editor/overlay.h"

namespace idap {

class Editor;

struct ToolKey {          // a key that the tool understands, for the hint line and the help
  const char* keys = "";  // "Tab", "Shift", "Enter"
  const char* what = "";  // marked for translation
};

struct ToolInfo {
  const char* id = "";        // "wall"; also the name of its icon
  const char* name = "";      // marked for translation: "Wall"
  const char* tip = "";       // what it does and why one would want it
  const char* hint = "";      // the hint line: what to do now
  const char* shortcut = "";  // of the action that takes it in hand, as Qt writes keys
  std::vector<ToolKey> keys;
};

struct Response {
  bool used = true;       // false: the event meant nothing to the tool and goes on to others
  bool finished = false;  // the tool has done its work: back to selecting
};

class Tool {
 public:
  virtual ~Tool() = default;
  virtual const ToolInfo& info() const = 0;
  // What to do now; changes as the work goes on.
  virtual Text hint() const { return info().hint; }

  // Taken in hand; put away, with all that is half done taken back.
  virtual void begin(Editor&) {}
  virtual void end(Editor& editor) { cancel(editor); }
  // Escape: takes back what is half done. True when there was something.
  virtual bool cancel(Editor&) { return false; }

  virtual Response pointer(Editor& editor, const PointerEvent& event) = 0;
  virtual Response key(Editor&, const KeyEvent&) { return {.used = false}; }

  // pixel: m that one pixel covers in the view.
  virtual Overlay overlay(const Editor&, Plane, double pixel) const {
    (void)pixel;
    return {};
  }
  virtual Cursor cursor(const Editor&, Plane) const { return Cursor::Cross; }
};

using ToolFactory = std::function<std::unique_ptr<Tool>()>;

struct ToolEntry {
  const ToolInfo* info;
  ToolFactory make;
};

// Every tool that has a button, in the order of the toolbar: to add one, write its file and add one line in
// tool_registry.cpp.
const std::vector<ToolEntry>& tools();

}  // namespace idap
