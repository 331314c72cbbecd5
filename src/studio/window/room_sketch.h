// A small drawing of a rectangular room: its plan with the lengths along X and Y, and its box with the height
// Z. Follows the numbers while they are typed.
#pragma once

#include <QWidget>

#include "base/units.h"

namespace idap {

class RoomSketch : public QWidget {
  Q_OBJECT
 public:
  explicit RoomSketch(QWidget* parent = nullptr);

  void setRoom(double x, double y, double z, LengthUnit unit);  // m
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void drawPlan(QPainter& painter, const QRectF& area) const;
  void drawBox(QPainter& painter, const QRectF& area) const;

  double x_ = 5, y_ = 4, z_ = 2.5;
  LengthUnit unit_ = LengthUnit::Metre;
};

}  // namespace idap
