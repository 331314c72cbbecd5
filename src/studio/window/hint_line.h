// One line under the planes: the tool in hand, what to do with it now, and its keys.
#pragma once

#include <QStringList>
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
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show();
  void fit();

  Editor& editor_;
  QLabel *icon_, *words_;
  QString hint_;
  QStringList keys_;  // as many as there is room for are shown, the rest in the tooltip
  QTimer* soon_;      // a drag changes the overlay with every move of the pointer
  int subscription_;
};

}  // namespace idap
