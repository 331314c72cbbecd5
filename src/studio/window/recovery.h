// Copies of unsaved homes for the case that the program, or the machine, stops: written every minute into the
// user's data folder, taken away when the home is saved or closed. Each window has a copy of its own, under a
// lock that says whether its program still runs.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "editor/editor.h"

class QLockFile;
class QTimer;

namespace idap {

class BackgroundJob;

class Recovery : public QObject {
  Q_OBJECT
 public:
  explicit Recovery(Editor& editor, QObject* parent = nullptr);
  ~Recovery() override;  // a window that closes in order leaves nothing behind

  static constexpr int kSeconds = 60;

  void keep();  // writes a copy now, where there is something unsaved; in the background
  void drop();  // the copy is not needed any more: saved, or thrown away by the user
  bool busy() const { return writing_ != nullptr; }

  struct Found {
    std::filesystem::path copy, original;  // original: empty for a home that was never saved
    QString time;                          // when it was kept, for the user
  };
  // What programs that no longer run have left. Those found are claimed: no other window finds them.
  std::vector<Found> findLeft();
  static void remove(const Found& found);

  static std::filesystem::path folder();

 signals:
  void kept();  // a copy was written
  void failed(const QString& reason);

 private:
  Editor& editor_;
  QTimer* timer_;
  std::unique_ptr<QLockFile> lock_;
  std::filesystem::path base_;  // without extension
  std::vector<std::unique_ptr<QLockFile>> claimed_;
  BackgroundJob* writing_ = nullptr;
  std::uint64_t keptRevision_ = 0;
  bool kept_ = false, told_ = false;
};

}  // namespace idap
