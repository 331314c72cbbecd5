// The little plate in the corner of a view that says which plane it shows; a double click on it, or its
// button, asks for the view to be maximised.
#pragma once

#include <QFrame>

#include "editor/plane.h"

class QLabel;
class QToolButton;

namespace idap {

class PlanCaption : public QFrame {
  Q_OBJECT
 public:
  PlanCaption(Plane plane, QWidget* parent);
  void setLevelName(const QString& name);

 signals:
  void maximiseRequested();

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();

  Plane plane_;
  QString levelName_;
  QLabel* label_;
  QToolButton* button_;
};

}  // namespace idap
