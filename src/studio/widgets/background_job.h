// Work on a thread of its own, with progress and cancel, whose end comes back to the GUI thread. What reads,
// builds or saves in the studio runs as one of these.
#pragma once

#include <QObject>
#include <QString>
#include <exception>
#include <functional>
#include <memory>
#include <optional>

#include "base/progress.h"

namespace idap {

class BackgroundJob : public QObject {
  Q_OBJECT
 public:
  using Work = std::function<void(const Progress&)>;           // on the other thread; may throw
  using Done = std::function<void(std::exception_ptr error)>;  // on this one; null: it went well

  // Starts at once. Deletes itself after done; deleted before, it cancels the work, waits for it to stop, and
  // done is never called.
  BackgroundJob(QString what, Work work, Done done, QObject* owner);
  ~BackgroundJob() override;

  QString what() const;      // "Reading home.idap", for the user
  double fraction() const;   // 0..1
  bool cancellable() const;  // false after setCancellable(false): a save that must not be stopped half way
  void setCancellable(bool cancellable);
  std::optional<double> secondsLeft() const;  // by the pace so far; nothing while that cannot be told

 public Q_SLOTS:
  void cancel();

 signals:
  void progressed();  // at most ten times a second

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The same with a result: done takes it, failed takes what was thrown (Cancelled too).
template <class Result>
BackgroundJob* runInBackground(QObject* owner, QString what, std::function<Result(const Progress&)> work,
                               std::function<void(Result)> done,
                               std::function<void(std::exception_ptr)> failed) {
  auto result = std::make_shared<std::optional<Result>>();
  return new BackgroundJob(
      std::move(what), [result, work = std::move(work)](const Progress& p) { result->emplace(work(p)); },
      [result, done = std::move(done), failed = std::move(failed)](std::exception_ptr error) {
        if (error)
          failed(error);
        else
          done(std::move(**result));
      },
      owner);
}

// What an exception says to the user; empty for a cancelled job.
QString errorText(std::exception_ptr error);

}  // namespace idap
