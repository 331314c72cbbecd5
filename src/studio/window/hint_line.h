// One line under the planes: the tool in hand, what to do with it now, and its keys.
#pragma once

#include <QWidget>
#include <functional>

#include "editor/editor.h"

class QLabel;

namespace idap {

class HintLine : public QWidget {
  Q_OBJECT
 public:
  explicit HintLine(Editor& editor, QWidget* parent = nullptr);
  ~HintLine() override;

  QString text() const;  // as it is read, without markup

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show();

  Editor& editor_;
  QLabel *icon_, *words_;
  QTimer* soon_;  // a drag changes the overlay with every move of the pointer
  int subscription_;
};

}  // namespace idap
