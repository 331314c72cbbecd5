// The place of the view in three dimensions: traces the chosen point of view in the background while the
// design goes on, and shows the last picture until then.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class PicturePanel : public QWidget {
  Q_OBJECT
 public:
  explicit PicturePanel(Editor& editor, QWidget* parent = nullptr);
  ~PicturePanel() override;  // cancels what is being traced

  // The camera to see from; CameraId{}: from above.
  void setCamera(CameraId camera);
  void rayTrace();  // begins a picture of the home as it is now, in place of one being made
  void stop();
  bool busy() const;

 signals:
  void started();
  void finished();
  void maximiseRequested();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
