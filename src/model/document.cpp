#include "model/document.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "model/validate.h"

namespace idap {

Document::Document(Home home, std::filesystem::path file)
    : current_(std::move(home)), file_(std::move(file)) {
  requireValid(current_);
}

void Document::apply(const Edit& edit) {
  if (transaction_)
    throw InvalidHome("'" + edit.name + "' cannot be done while '" + transaction_->name + "' is under way");
  Home next = edit.change(current_);
  requireValid(next, current_);
  if (next == current_) return;
  pushUndo({edit.name, current_, revision_});
  swapTo(std::move(next), ++lastRevision_);
}

void Document::amend(const std::function<Home(const Home&)>& change) {
  const auto amended = [&](const Home& home) {
    Home next = change(home);
    requireValid(next, home);
    return next;
  };
  Home next = amended(current_);
  if (next == current_) return;
  std::vector<Home> others;
  for (const std::vector<Step>* steps : {&undo_, &redo_})
    for (const Step& step : *steps) others.push_back(amended(step.home));
  std::optional<Home> before;
  if (transaction_) before = amended(transaction_->before);
  auto other = others.begin();
  for (std::vector<Step>* steps : {&undo_, &redo_})
    for (Step& step : *steps) step.home = std::move(*other++);
  if (transaction_) {
    transaction_->before = std::move(*before);
    transaction_->revision = ++lastRevision_;
  }
  markUnsaved();
  swapTo(std::move(next), ++lastRevision_);
}

std::uint64_t Document::freeId() const {
  std::uint64_t id = current_.nextId;
  for (const std::vector<Step>* steps : {&undo_, &redo_})
    for (const Step& step : *steps) id = std::max(id, step.home.nextId);
  return transaction_ ? std::max(id, transaction_->before.nextId) : id;
}

void Document::begin(std::string name) {
  if (transaction_)
    throw InvalidHome("'" + name + "' cannot begin while '" + transaction_->name + "' is under way");
  transaction_ = Transaction{std::move(name), current_, revision_};
}

void Document::preview(const std::function<Home(const Home&)>& change) {
  if (!transaction_) throw InvalidHome("a preview needs a transaction");
  Home next = change(transaction_->before);
  requireValid(next, transaction_->before);
  swapTo(std::move(next), ++lastRevision_);
}

void Document::commit() {
  if (!transaction_) throw InvalidHome("there is nothing to commit");
  Transaction done = std::move(*transaction_);
  transaction_.reset();
  if (current_ == done.before) {
    revision_ = done.revision;
    return;
  }
  pushUndo({std::move(done.name), std::move(done.before), done.revision});
}

void Document::cancel() {
  if (!transaction_) return;
  Transaction dropped = std::move(*transaction_);
  transaction_.reset();
  swapTo(std::move(dropped.before), dropped.revision);
}

std::string Document::undoName() const { return canUndo() ? undo_.back().name : std::string(); }
std::string Document::redoName() const { return canRedo() ? redo_.back().name : std::string(); }

void Document::undo() {
  if (!canUndo()) return;
  Step step = std::move(undo_.back());
  undo_.pop_back();
  redo_.push_back({std::move(step.name), current_, revision_});
  swapTo(std::move(step.home), step.revision);
}

void Document::redo() {
  if (!canRedo()) return;
  Step step = std::move(redo_.back());
  redo_.pop_back();
  undo_.push_back({std::move(step.name), current_, revision_});
  swapTo(std::move(step.home), step.revision);
}

bool Document::modified() const { return revision_ != savedRevision_; }

Document::Snapshot Document::snapshot() const {
  if (transaction_) return {transaction_->before, transaction_->revision};
  return {current_, revision_};
}

void Document::markSaved(std::filesystem::path file) { markSaved(std::move(file), revision_); }

void Document::markSaved(std::filesystem::path file, std::uint64_t revision) {
  file_ = std::move(file);
  savedRevision_ = revision;
}

void Document::markUnsaved() { savedRevision_ = std::numeric_limits<std::uint64_t>::max(); }

int Document::subscribe(Listener listener) {
  listeners_.emplace_back(nextHandle_, std::move(listener));
  return nextHandle_++;
}

void Document::unsubscribe(int handle) {
  std::erase_if(listeners_, [handle](const auto& entry) { return entry.first == handle; });
}

void Document::pushUndo(Step step) {
  undo_.push_back(std::move(step));
  redo_.clear();
}

void Document::swapTo(Home home, std::uint64_t revision) {
  const Home before = std::exchange(current_, std::move(home));
  revision_ = revision;
  const Home after = current_;
  // A copy, because a listener may unsubscribe itself or others, or change the home in its turn.
  const auto listeners = listeners_;
  for (const auto& [handle, listener] : listeners) {
    const bool subscribed = std::any_of(listeners_.begin(), listeners_.end(),
                                        [h = handle](const auto& entry) { return entry.first == h; });
    if (subscribed) listener(before, after);
  }
}

}  // namespace idap
