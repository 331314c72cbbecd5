// The points of view of the home: named, renamed, deleted, chosen for the next picture.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class CameraList : public QWidget {
  Q_OBJECT
 public:
  explicit CameraList(Editor& editor, QWidget* parent = nullptr);
  ~CameraList() override;

  CameraId current() const;  // CameraId{}: the view from above

 signals:
  void currentChanged();
  void pictureRequested();  // a double click

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
