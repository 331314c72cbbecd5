// The window in which films are made: a walk through points of view, or a day of sunlight in one of them,
// traced into an MP4 file while the design goes on.
#pragma once

#include <QWidget>
#include <filesystem>
#include <memory>

#include "editor/editor.h"
#include "film/film_job.h"

namespace idap {

class FilmWindow : public QWidget {
  Q_OBJECT
 public:
  explicit FilmWindow(Editor& editor, QWidget* parent = nullptr);
  ~FilmWindow() override;  // gives up the film being made

  void make(const std::filesystem::path& file);
  void stop();  // the film so far is kept where it is long enough
  bool busy() const;

 signals:
  void finished(bool made);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
