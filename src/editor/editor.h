// One window's work: the document, what is selected, the level and the tool in hand. Views and panels listen
// to it; it knows none of them. Belongs to one thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "catalog/catalog.h"
#include "editor/selection.h"
#include "editor/settings.h"
#include "editor/tool.h"
#include "model/document.h"

namespace idap {

class Editor {
 public:
  explicit Editor(std::shared_ptr<const Catalog> catalog);
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  // The document; another home is opened by putting another document in its place.
  const Document& document() const { return *document_; }
  Document& document() { return *document_; }
  void open(std::unique_ptr<Document> document);
  const Home& home() const { return document_->home(); }
  const Catalog& catalog() const { return *catalog_; }
  std::shared_ptr<const Catalog> sharedCatalog() const { return catalog_; }

  // One undo step. Takes back what the tool has half done first. An edit that would break the home is refused
  // with a message to the user, and false.
  bool apply(const Edit& edit);
  bool apply(const char* name, const std::function<Home(const Home&)>& change) {
    return apply(Edit{name, change});
  }
  // The same for a drag: false (and a note for the user at commit) where a preview breaks the home; the last
  // good one stays.
  bool preview(const std::function<Home(const Home&)>& change);
  void undo();
  void redo();

  // Elements that are gone or not on the plan drop out of the selection by themselves.
  const Elements& selection() const { return selection_; }
  void select(Elements elements);

  // The level that is drawn on; LevelId{} for a home without levels.
  LevelId level() const { return level_; }
  void setLevel(LevelId level);
  double elevation() const;  // m, of the current level

  const EditorSettings& settings() const { return settings_; }
  void setSettings(EditorSettings settings);

  // Never null; a null one takes the select tool in hand.
  Tool& tool() const { return *tool_; }
  void setTool(std::unique_ptr<Tool> tool);
  void takeTool(const std::string& id);  // of the registry; unknown ones are passed over
  bool selecting() const;                // the select tool is in hand

  // From the views. A finished tool gives way to the select tool. key: false when nobody used it.
  void pointer(const PointerEvent& event);
  bool key(const KeyEvent& event);
  const PointerEvent& lastPointer() const { return lastPointer_; }

  // Words for the user: the status line shows the last, the messages panel keeps all.
  enum class Severity { Note, Warning, Error };
  void say(Text text, Severity severity = Severity::Note);

  // What changed; several in one call of a listener never happen.
  enum class Change { Home, Selection, Level, Tool, Overlay, Settings, Document };
  struct Listener {
    std::function<void(Change)> changed;
    // Home only, before changed(Change::Home): what diff() needs.
    std::function<void(const Home& before, const Home& after)> homeChanged;
    std::function<void(const Text&, Severity)> said;
  };
  int subscribe(Listener listener);
  void unsubscribe(int handle);

 private:
  void notify(Change change);
  void onHome(const Home& before, const Home& after);

  std::shared_ptr<const Catalog> catalog_;
  std::unique_ptr<Document> document_;
  std::unique_ptr<Tool> tool_;
  Elements selection_;
  LevelId level_;
  EditorSettings settings_;
  PointerEvent lastPointer_;
  std::vector<std::pair<int, Listener>> listeners_;
  int nextHandle_ = 1;
};

}  // namespace idap
