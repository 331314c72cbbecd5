// The place of the view in three dimensions: traces the chosen point of view in the background while the
// design goes on, and shows the last picture until then.
#pragma once

#include <QImage>
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
  // Where the live view stands: sees from there, unless a camera was chosen since that was said the last
  // time.
  void setPlace(const Camera& place);
  void rayTrace();  // begins a picture of the home as it is now, in place of one being made
  void stop();
  bool busy() const;

  QImage picture() const;  // the last one; null before the first
  bool outdated() const;   // the home has changed since the picture was begun
  // PNG or JPEG by the name, written in the background; the editor says how it went.
  void savePicture(const QString& file);
  // How good a picture becomes before tracing ends: samples a pixel or seconds, whichever comes first.
  void setQuality(int samples, double seconds);

 signals:
  void started();
  void finished();
  void maximiseRequested();
  void closed();  // back to the live view

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void askWhereToSave();

  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
