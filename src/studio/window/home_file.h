// The file behind a window: read and written in the background, from snapshots, so that the design goes on
// meanwhile. Saves wait for one another; of several that wait for one file only the last is written.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>

#include "base/error.h"
#include "editor/editor.h"
#include "model/import_report.h"
#include "studio/widgets/background_job.h"

namespace idap {

// The file is not as it was when it was read or written last: somebody else changed it.
class ChangedOnDisk : public Error {
 public:
  using Error::Error;
};

class HomeFile : public QObject {
  Q_OBJECT
 public:
  explicit HomeFile(Editor& editor, QObject* parent = nullptr);
  ~HomeFile() override;

  // Opens the home in the editor when it is read. asTemplate: the home stands for no file.
  void open(const std::filesystem::path& file, bool asTemplate = false);
  // What was saved beside the original before the program stopped. The home is unsaved, and stands for the
  // original file.
  void restore(const std::filesystem::path& copy, const std::filesystem::path& original);
  // A new home, in no file yet.
  void start(Home home);

  // Writes what is there now. evenIfChanged: over what somebody else wrote since.
  void save(const std::filesystem::path& file, bool evenIfChanged = false);

  bool reading() const { return reading_ != nullptr; }
  bool saving() const { return saving_ != nullptr; }
  bool busy() const { return reading() || saving(); }

  // Whether homes can be written to this file, by its extension.
  static bool canWrite(const std::filesystem::path& file);

 signals:
  void jobStarted(idap::BackgroundJob* job);
  void opened(const QString& file, const idap::ImportReport& report);
  void openFailed(const QString& file, const QString& reason);  // an empty reason: cancelled
  void saved(const QString& file);
  void changedOnDisk(const QString& file);  // it was not written
  void saveFailed(const QString& file, const QString& reason);

 private:
  struct Opened {
    std::unique_ptr<Document> document;
    ImportReport report;
  };
  struct Save {
    std::filesystem::path file;
    Document::Snapshot snapshot;
    bool evenIfChanged = false;
  };
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  static std::optional<Stamp> stampOf(const std::filesystem::path& file);

  void read(const std::filesystem::path& file, std::function<void(Document&)> settle,
            const std::filesystem::path& documentFile);
  void write(Save save);
  void writeNext();

  Editor& editor_;
  BackgroundJob* reading_ = nullptr;
  BackgroundJob* saving_ = nullptr;
  std::vector<Save> waiting_;
  std::filesystem::path stamped_;  // the file that the stamp is of
  std::shared_ptr<std::optional<Stamp>> stamp_;
  std::uint64_t generation_ = 0;  // of the document: a save of one before does not mark this one saved
};

}  // namespace idap
