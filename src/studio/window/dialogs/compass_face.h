// A compass rose that shows which way north is on the plan, and is turned by dragging it.
#pragma once

#include <QWidget>

namespace idap {

class CompassFace : public QWidget {
  Q_OBJECT
 public:
  explicit CompassFace(QWidget* parent = nullptr);

  void setNorth(double degrees);  // clockwise from up the page
  QSize sizeHint() const override;

 signals:
  void turned(double degrees);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

 private:
  double north_ = 0;
};

}  // namespace idap
