// The window in which pictures are made and looked at: what to make on the left, what is being made, and the
// home's gallery below. It stays open beside the design.
#pragma once

#include <QWidget>
#include <memory>

#include "editor/editor.h"

namespace idap {

class PictureForm;
class PictureQueue;

class PictureWindow : public QWidget {
  Q_OBJECT
 public:
  explicit PictureWindow(Editor& editor, QWidget* parent = nullptr);
  ~PictureWindow() override;

  PictureForm& form();
  PictureQueue& queue();
  void lookAt(PictureId picture);
  // Written in the background, as the name's end says; the editor says how it went.
  void savePicture(PictureId picture, const QString& file);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
