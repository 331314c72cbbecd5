#include "studio/window/room_sketch.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <numbers>

#include "studio/widgets/texts.h"

namespace idap {

namespace {

// A length written along a line, in the middle of it, on the colour behind.
void writeAlong(QPainter& painter, QPointF from, QPointF to, const QString& text) {
  const QFontMetricsF metrics(painter.font());
  QRectF box = metrics.boundingRect(text).adjusted(-3, -1, 3, 1);
  painter.save();
  painter.translate((from + to) / 2);
  double angle = std::atan2(to.y() - from.y(), to.x() - from.x()) * 180 / std::numbers::pi;
  if (angle > 90 || angle <= -90) angle += 180;
  painter.rotate(angle);
  box.moveCenter({0, 0});
  painter.fillRect(box, painter.background());
  painter.drawText(box, Qt::AlignCenter, text);
  painter.restore();
}

void dimension(QPainter& painter, QPointF from, QPointF to, const QString& text) {
  painter.drawLine(from, to);
  const QPointF along = (to - from) / std::max(1.0, std::hypot(to.x() - from.x(), to.y() - from.y()));
  const QPointF tick = QPointF(along.x() - along.y(), along.y() + along.x()) * 4;
  painter.drawLine(from - tick, from + tick);
  painter.drawLine(to - tick, to + tick);
  writeAlong(painter, from, to, text);
}

}  // namespace

RoomSketch::RoomSketch(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("roomSketch"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void RoomSketch::setRoom(double x, double y, double z, LengthUnit unit) {
  x_ = x, y_ = y, z_ = z, unit_ = unit;
  setAccessibleDescription(lengthText(x, unit) + QStringLiteral(" × ") + lengthText(y, unit) +
                           QStringLiteral(" × ") + lengthText(z, unit));
  update();
}

QSize RoomSketch::sizeHint() const {
  const int em = fontMetrics().height();
  return {30 * em, 17 * em};
}

void RoomSketch::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  update();
}

void RoomSketch::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBackground(palette().brush(QPalette::Base));
  painter.fillRect(rect(), palette().brush(QPalette::Base));
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  const double half = width() / 2.0, margin = fontMetrics().height() * 0.7;
  drawPlan(painter, QRectF(0, 0, half, height()).adjusted(margin, margin, -margin, -margin));
  drawBox(painter, QRectF(half, 0, half, height()).adjusted(margin, margin, -margin, -margin));
}

void RoomSketch::drawPlan(QPainter& painter, const QRectF& area) const {
  const double line = QFontMetricsF(font()).height(), wall = 0.12;
  const QRectF inner = area.adjusted(line * 1.6, 0, 0, -line * 1.6);
  const double scale = std::min(inner.width() / (x_ + 2 * wall), inner.height() / (y_ + 2 * wall));
  QRectF outside(0, 0, (x_ + 2 * wall) * scale, (y_ + 2 * wall) * scale);
  outside.moveCenter(inner.center());
  const double thick = std::max(2.5, wall * scale);
  const QRectF floor = outside.adjusted(thick, thick, -thick, -thick);
  QPainterPath walls;
  walls.addRect(outside);
  walls.addRect(floor);
  painter.fillPath(walls, palette().color(QPalette::Text));
  QColor tint = palette().color(QPalette::Highlight);
  tint.setAlphaF(0.16f);
  painter.fillRect(floor, tint);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(floor, Qt::AlignCenter, areaText(x_ * y_, unit_));
  const double below = outside.bottom() + line * 0.8, left = outside.left() - line * 0.8;
  dimension(painter, {floor.left(), below}, {floor.right(), below},
            QStringLiteral("X ") + lengthText(x_, unit_));
  dimension(painter, {left, floor.bottom()}, {left, floor.top()},
            QStringLiteral("Y ") + lengthText(y_, unit_));
}

void RoomSketch::drawBox(QPainter& painter, const QRectF& area) const {
  // An oblique view from the front, from above: y runs to the upper right at half its length.
  const double slope = 0.36;
  const double line = QFontMetricsF(font()).height();
  const QRectF inner = area.adjusted(line * 1.6, 0, 0, 0);
  const double width = x_ + slope * y_, height = z_ + slope * y_;
  const double scale = std::min(inner.width() / width, inner.height() / height);
  const QPointF origin(inner.center().x() - width * scale / 2, inner.center().y() + height * scale / 2);
  const auto at = [&](double x, double y, double z) {
    return origin + QPointF(x + slope * y, -z - slope * y) * scale;
  };
  QColor tint = palette().color(QPalette::Highlight);
  tint.setAlphaF(0.16f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(tint);
  painter.drawPolygon(QPolygonF{at(0, 0, 0), at(x_, 0, 0), at(x_, y_, 0), at(0, y_, 0)});
  tint.setAlphaF(0.08f);
  painter.setBrush(tint);
  painter.drawPolygon(QPolygonF{at(0, y_, 0), at(x_, y_, 0), at(x_, y_, z_), at(0, y_, z_)});
  painter.drawPolygon(QPolygonF{at(0, 0, 0), at(0, y_, 0), at(0, y_, z_), at(0, 0, z_)});
  painter.setBrush(Qt::NoBrush);
  QColor hidden = palette().color(QPalette::Text);
  hidden.setAlphaF(0.45f);
  painter.setPen(QPen(hidden, 1, Qt::DashLine));
  painter.drawLine(at(0, y_, 0), at(x_, y_, 0));
  painter.drawLine(at(0, y_, 0), at(0, 0, 0));
  painter.drawLine(at(0, y_, 0), at(0, y_, z_));
  painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
  painter.drawPolygon(QPolygonF{at(0, 0, 0), at(x_, 0, 0), at(x_, 0, z_), at(0, 0, z_)});
  painter.drawPolyline(QPolygonF{at(x_, 0, 0), at(x_, y_, 0), at(x_, y_, z_), at(0, y_, z_), at(0, 0, z_)});
  painter.drawLine(at(x_, 0, z_), at(x_, y_, z_));
  // A person, to see the size by.
  if (z_ > 1.8 && x_ > 0.8) {
    QColor person = palette().color(QPalette::Text);
    person.setAlphaF(0.3f);
    painter.setPen(Qt::NoPen);
    painter.setBrush(person);
    const QPointF feet = at(x_ * 0.72, y_ * 0.5, 0);
    painter.drawEllipse(feet + QPointF(0, -1.6 * scale), 0.11 * scale, 0.13 * scale);
    painter.drawRoundedRect(
        QRectF(feet.x() - 0.17 * scale, feet.y() - 1.44 * scale, 0.34 * scale, 1.44 * scale), 0.15 * scale,
        0.15 * scale);
  }
  painter.setPen(palette().color(QPalette::Text));
  const double left = origin.x() - line * 0.8;
  dimension(painter, {left, at(0, 0, 0).y()}, {left, at(0, 0, z_).y()},
            QStringLiteral("Z ") + lengthText(z_, unit_));
}

}  // namespace idap
