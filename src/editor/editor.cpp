#include "editor/editor.h"

#include <algorithm>

#include "base/error.h"
#include "editor/tools/tool_list.h"

namespace idap {

Editor::Editor(std::shared_ptr<const Catalog> catalog)
    : catalog_(std::move(catalog)), document_(std::make_unique<Document>()), tool_(selectTool().make()) {
  document_->subscribe([this](const Home& before, const Home& after) { onHome(before, after); });
  tool_->begin(*this);
}

Editor::~Editor() = default;

void Editor::open(std::unique_ptr<Document> document) {
  const std::unique_ptr<Document> old = std::move(document_);
  document_ = std::move(document);
  document_->subscribe([this](const Home& before, const Home& after) { onHome(before, after); });
  // What the tool had begun went with the old document.
  tool_ = selectTool().make();
  selection_ = {};
  level_ = {};
  for (const auto& [id, level] : home().levels) {
    const Level* chosen = home().levels.find(level_);
    // The lowest storey above the ground, where people look first.
    if (level->viewable && (!chosen || (chosen->elevation < -0.5 && level->elevation > chosen->elevation) ||
                            (level->elevation >= -0.5 && level->elevation < chosen->elevation)))
      level_ = id;
  }
  tool_->begin(*this);
  notify(Change::Document);
  notify(Change::Level);
  notify(Change::Selection);
  notify(Change::Tool);
  notify(Change::Overlay);
}

bool Editor::apply(const Edit& edit) {
  if (document_->inTransaction()) tool_->cancel(*this);
  document_->cancel();
  try {
    document_->apply(edit);
    return true;
  } catch (const InvalidHome& error) {
    say({QT_TRANSLATE_NOOP("idap", "That cannot be done: %1"), {error.what()}}, Severity::Warning);
    return false;
  }
}

bool Editor::preview(const std::function<Home(const Home&)>& change) {
  try {
    document_->preview(change);
    return true;
  } catch (const InvalidHome&) {
    return false;
  }
}

void Editor::undo() {
  if (tool_->cancel(*this)) return;
  document_->cancel();
  document_->undo();
}

void Editor::redo() {
  tool_->cancel(*this);
  document_->cancel();
  document_->redo();
}

void Editor::select(Elements elements) {
  elements = pruned(home(), std::move(elements));
  if (same(elements, selection_)) return;
  selection_ = std::move(elements);
  notify(Change::Selection);
  notify(Change::Overlay);
}

void Editor::setLevel(LevelId level) {
  if (level == level_ || (level ? !home().levels.contains(level) : !home().levels.empty())) return;
  tool_->cancel(*this);
  level_ = level;
  notify(Change::Level);
  notify(Change::Overlay);
}

double Editor::elevation() const { return elevationOf(home(), level_); }

void Editor::setSettings(EditorSettings settings) {
  if (settings == settings_) return;
  settings_ = std::move(settings);
  notify(Change::Settings);
}

void Editor::setTool(std::unique_ptr<Tool> tool) {
  tool_->end(*this);
  document_->cancel();
  tool_ = tool ? std::move(tool) : selectTool().make();
  tool_->begin(*this);
  notify(Change::Tool);
  notify(Change::Overlay);
}

void Editor::takeTool(const std::string& id) {
  const auto entry =
      std::find_if(tools().begin(), tools().end(), [&id](const ToolEntry& e) { return id == e.info->id; });
  if (entry != tools().end()) setTool(entry->make());
}

bool Editor::selecting() const { return tool_->info().id == std::string(selectTool().info->id); }

void Editor::pointer(const PointerEvent& event) {
  lastPointer_ = event;
  const Tool* before = tool_.get();
  const Response response = tool_->pointer(*this, event);
  if (response.finished && tool_.get() == before) setTool(nullptr);
  notify(Change::Overlay);
}

bool Editor::key(const KeyEvent& event) {
  const Tool* before = tool_.get();
  Response response = tool_->key(*this, event);
  if (tool_.get() != before) return true;
  if (!response.used && event.key == Key::Escape) {
    // First what is half done, then the tool, then the selection.
    if (tool_->cancel(*this)) {
      response.used = true;
    } else if (!selecting()) {
      response = {.used = true, .finished = true};
    } else if (!empty(selection_)) {
      select({});
      response.used = true;
    }
  }
  if (response.finished && tool_.get() == before) setTool(nullptr);
  if (response.used) notify(Change::Overlay);
  return response.used;
}

void Editor::say(Text text, Severity severity) {
  const auto listeners = listeners_;
  for (const auto& [handle, listener] : listeners)
    if (listener.said) listener.said(text, severity);
}

int Editor::subscribe(Listener listener) {
  listeners_.emplace_back(nextHandle_, std::move(listener));
  return nextHandle_++;
}

void Editor::unsubscribe(int handle) {
  std::erase_if(listeners_, [handle](const auto& entry) { return entry.first == handle; });
}

void Editor::notify(Change change) {
  const auto listeners = listeners_;  // a listener may come or go while it is told
  for (const auto& [handle, listener] : listeners)
    if (listener.changed) listener.changed(change);
}

void Editor::onHome(const Home& before, const Home& after) {
  const Home was = before, now = after;  // a listener may edit
  // Before anybody is told: who asks for the selection finds only what is there.
  const bool newLevel = level_ ? !now.levels.contains(level_) : !now.levels.empty();
  if (newLevel) level_ = now.levels.empty() ? LevelId{} : now.levels.begin()->first;
  Elements left = followed(was, now, selection_);
  const bool newSelection = !same(left, selection_);
  if (newSelection) selection_ = std::move(left);
  const auto listeners = listeners_;
  for (const auto& [handle, listener] : listeners)
    if (listener.homeChanged) listener.homeChanged(was, now);
  notify(Change::Home);
  if (newLevel) notify(Change::Level);
  if (newSelection) notify(Change::Selection);
  notify(Change::Overlay);
}

}  // namespace idap
