// The place of the view in three dimensions: the live view with where to see from, the hour, the weather, the
// lamps and the exposure around it.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class View3d;

class LivePanel : public QWidget {
  Q_OBJECT
 public:
  explicit LivePanel(Editor& editor, QWidget* parent = nullptr);
  ~LivePanel() override;

  View3d& view() const;
  void setCamera(CameraId camera);  // sees from there; CameraId{}: the whole home from above
  void storeView();                 // adds the present point of view to the home

 signals:
  void maximiseRequested();
  void contextMenuRequested(QPoint global);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
