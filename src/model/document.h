// A home being worked on: the current value, its history, and the file it came from. apply() is the only way
// in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/home.h"

namespace idap {

// An edit is a function from a home to a home, with a name for the undo menu.
struct Edit {
  std::string name;
  std::function<Home(const Home&)> change;
};

// Not thread-safe: belongs to one thread; hand snapshots (home()) to others.
class Document {
 public:
  // Throws InvalidHome: what comes from a file goes through validated() first.
  explicit Document(Home home = {}, std::filesystem::path file = {});

  const Home& home() const { return current_; }
  const std::filesystem::path& file() const { return file_; }

  // Validates and makes the change one undo step. Throws InvalidHome and changes nothing when the edit breaks
  // the home; throws InvalidHome while a transaction is open. An edit that changes nothing leaves no step.
  void apply(const Edit& edit);

  // Changes the home in every state of its history, without a step of its own: for what is no part of the
  // design, such as the pictures that were made of it. Not while it would break one of those: throws
  // InvalidHome and changes nothing. In a transaction it goes on.
  void amend(const std::function<Home(const Home&)>& change);
  // A number that no element has in any state of the history.
  std::uint64_t freeId() const;

  // A drag: begin, any number of previews (each applied to the home as it was at begin), then commit or
  // cancel. A preview that breaks the home throws InvalidHome and leaves the last good one standing. begin in
  // a transaction, preview and commit outside one throw InvalidHome; cancel outside one does nothing.
  void begin(std::string name);
  void preview(const std::function<Home(const Home&)>& change);
  void commit();
  void cancel();
  bool inTransaction() const { return transaction_.has_value(); }

  bool canUndo() const { return !undo_.empty() && !transaction_; }
  bool canRedo() const { return !redo_.empty() && !transaction_; }
  std::string undoName() const;  // empty when there is nothing to undo
  std::string redoName() const;
  void undo();  // nothing happens when there is nothing to undo
  void redo();

  // What is saved while work goes on: the home without what a transaction has half done, and its number.
  struct Snapshot {
    Home home;
    std::uint64_t revision = 0;
  };
  Snapshot snapshot() const;

  bool modified() const;  // differs from what was last saved
  void markSaved(std::filesystem::path file);
  void markSaved(std::filesystem::path file, std::uint64_t revision);  // of the snapshot that was written
  void markUnsaved();  // what is open is in no file: restored after a crash

  // Called after every change of home(), with the home before. Returns a handle for unsubscribe.
  using Listener = std::function<void(const Home& before, const Home& after)>;
  int subscribe(Listener listener);
  void unsubscribe(int handle);

 private:
  struct Step {
    std::string name;
    Home home;  // undo: the home before the step; redo: the home after it
    std::uint64_t revision;
  };
  struct Transaction {
    std::string name;
    Home before;
    std::uint64_t revision;
  };
  void pushUndo(Step step);
  void swapTo(Home home, std::uint64_t revision);

  Home current_;
  // Every home of the history has a number of its own, so that undoing back to what was saved is seen.
  std::uint64_t revision_ = 0, savedRevision_ = 0, lastRevision_ = 0;
  std::filesystem::path file_;
  std::vector<Step> undo_, redo_;
  std::optional<Transaction> transaction_;
  std::vector<std::pair<int, Listener>> listeners_;
  int nextHandle_ = 1;
};

}  // namespace idap
