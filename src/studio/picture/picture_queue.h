// The pictures that are being made, one after another, while the design goes on. What is finished, or stopped
// and kept, goes into the home's gallery.
#pragma once

#include <QImage>
#include <QObject>
#include <memory>
#include <vector>

#include "editor/editor.h"
#include "studio/picture/picture_worker.h"

namespace idap {

class PictureQueue : public QObject {
  Q_OBJECT
 public:
  explicit PictureQueue(Editor& editor, QObject* parent = nullptr);
  ~PictureQueue() override;  // gives up what is being made

  struct Job {
    int id = 0;
    std::string name;
    PictureSettings settings;
    enum class State { Waiting, Tracing, Paused, Keeping } state = State::Waiting;
    double fraction = 0, secondsLeft = -1;  // < 0: not known yet
    QImage preview;                         // null before the first look
  };
  const std::vector<Job>& jobs() const { return jobs_; }
  const Job* find(int id) const;

  int add(std::string name, const PictureSettings& settings);  // of the home as it is now
  void pause(int id, bool paused);
  void stopAndKeep(int id);  // one that has not begun just goes
  void remove(int id);

  // The light of a picture that was made since the program started; null otherwise.
  std::shared_ptr<const PictureFilm> filmOf(PictureId picture) const;

 signals:
  void changed();  // jobs came, went or moved on
  void previewed(int id);
  void kept(int id, idap::PictureId picture);
  void failed(const QString& why);

 private:
  void next();
  void keep();
  Job* current() { return jobs_.empty() ? nullptr : &jobs_.front(); }

  Editor& editor_;
  int subscription_ = 0;
  PictureWorker worker_;
  std::vector<Job> jobs_;
  std::map<int, Home> homes_;  // by job
  std::map<PictureId, std::shared_ptr<const PictureFilm>> films_;
  int lastId_ = 0;
  bool removing_ = false;  // the current one is not to be kept
};

}  // namespace idap
