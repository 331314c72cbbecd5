#include "studio/window/dialogs/compass_face.h"

#include <QMouseEvent>
#include <QPainter>
#include <cmath>
#include <numbers>

namespace idap {

CompassFace::CompassFace(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("compassFace"));
  setCursor(Qt::PointingHandCursor);
}

void CompassFace::setNorth(double degrees) {
  north_ = degrees;
  update();
}

QSize CompassFace::sizeHint() const {
  const int side = 8 * fontMetrics().height();
  return {side, side};
}

void CompassFace::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double radius = std::min(width(), height()) / 2.0 - fontMetrics().height();
  painter.translate(QRectF(rect()).center());
  painter.rotate(north_);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1.5));
  painter.drawEllipse(QPointF(0, 0), radius, radius);
  for (int i = 0; i < 12; ++i) {
    painter.drawLine(QPointF(0, -radius), QPointF(0, -radius * (i % 3 == 0 ? 0.86 : 0.93)));
    painter.rotate(30);
  }
  const double half = radius * 0.16;
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawPolygon(QPolygonF{{0, -radius * 0.84}, {half, 0}, {-half, 0}});
  painter.setBrush(palette().color(QPalette::Mid));
  painter.drawPolygon(QPolygonF{{0, radius * 0.84}, {half, 0}, {-half, 0}});
  // The letter stays upright.
  painter.translate(0, -radius - fontMetrics().height() * 0.55);
  painter.rotate(-north_);
  painter.setPen(palette().color(QPalette::WindowText));
  painter.drawText(QRectF(-20, -20, 40, 40), Qt::AlignCenter, tr("N"));
}

void CompassFace::mousePressEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) mouseMoveEvent(event);
}

void CompassFace::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const QPointF from = event->position() - QRectF(rect()).center();
  double degrees = std::atan2(from.x(), -from.y()) * 180 / std::numbers::pi;
  // Whole degrees; the Alt key is for none at all, as on the plan.
  if (!(event->modifiers() & Qt::AltModifier)) degrees = std::round(degrees);
  if (degrees < 0) degrees += 360;
  setNorth(degrees);
  emit turned(degrees);
}

}  // namespace idap
