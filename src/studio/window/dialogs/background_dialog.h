// A scanned plan under the drawing of a level: chosen here, then put to its true size and place on the plan
// with two tools that this dialog takes in hand.
#pragma once

#include <QDialog>

#include "editor/editor.h"

class QCheckBox;
class QLabel;
class QPushButton;

namespace idap {

class BackgroundDialog : public QDialog {
  Q_OBJECT
 public:
  explicit BackgroundDialog(Editor& editor, QWidget* parent = nullptr);

  // Puts a picture file under the current level, as wide as what is drawn there, or 10 m. False, with words
  // in the dialog, where it cannot be.
  bool usePicture(const QString& file);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void choose();

  Editor& editor_;
  QLabel *explanation_, *picture_, *problem_;
  QPushButton *choose_, *calibrate_, *move_, *remove_, *close_;
  QCheckBox* visible_;
};

}  // namespace idap
