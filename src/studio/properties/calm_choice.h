// A choice that the wheel scrolls past, and that may be narrower than its longest entry: for long panels.
#pragma once

#include <QComboBox>
#include <QWheelEvent>

namespace idap {

class CalmChoice : public QComboBox {
 public:
  explicit CalmChoice(QWidget* parent) : QComboBox(parent) {
    setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(6);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFocusPolicy(Qt::StrongFocus);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace idap
