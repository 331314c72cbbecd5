#include "studio/picture/compare_view.h"

#include <QKeyEvent>

namespace idap {

namespace {

constexpr double kStep = 0.02;  // of the width, a key press
constexpr int kGrip = 12;       // pixels, half of the divider's handle

}  // namespace

CompareView::CompareView(QWidget* parent) : QWidget(parent) {
  setMinimumSize(160, 120);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

void CompareView::show(const QImage& picture, const QString& name) {
  picture_ = picture;
  name_ = name;
  other_ = {};
  update();
}

void CompareView::compare(const QImage& left, const QString& leftName, const QImage& right,
                          const QString& rightName) {
  picture_ = left;
  name_ = leftName;
  other_ = right;
  otherName_ = rightName;
  divider_ = 0.5;
  update();
}

void CompareView::setDivider(double at) {
  divider_ = std::clamp(at, 0.0, 1.0);
  update();
}

QRectF CompareView::place(const QImage& picture) const {
  const QSizeF size = QSizeF(picture.size()).scaled(this->size(), Qt::KeepAspectRatio);
  return {QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size};
}

void CompareView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window).darker(115));
  if (picture_.isNull()) {
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(
        rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
        tr("Tick a point of view and press Ray Trace. Every picture is kept below, with the home."));
    return;
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(place(picture_), picture_);
  if (other_.isNull()) return;
  const QRectF frame = place(picture_);
  const double x = frame.left() + divider_ * frame.width();
  painter.save();
  painter.setClipRect(QRectF(x, 0, width() - x, height()));
  painter.fillRect(rect(), palette().color(QPalette::Window).darker(115));
  painter.drawImage(place(other_), other_);
  painter.restore();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(QColor(0, 0, 0, 120), 4));
  painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
  painter.setPen(QPen(Qt::white, 2));
  painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()));
  painter.setBrush(QColor(0, 0, 0, 140));
  painter.drawEllipse(QPointF(x, frame.center().y()), kGrip, kGrip);
  painter.drawText(QRectF(x - kGrip, frame.center().y() - kGrip, 2 * kGrip, 2 * kGrip), Qt::AlignCenter,
                   QStringLiteral("↔"));
  const auto label = [&](const QString& words, bool left) {
    const int most = int(frame.width() / 2) - 24;
    const QString shown = fontMetrics().elidedText(words, Qt::ElideRight, std::max(20, most));
    QRectF box(0, frame.top() + 8, fontMetrics().horizontalAdvance(shown) + 16, fontMetrics().height() + 8);
    box.moveLeft(left ? frame.left() + 8 : frame.right() - box.width() - 8);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 140));
    painter.drawRoundedRect(box, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, shown);
  };
  label(name_, true);
  label(otherName_, false);
}

void CompareView::mousePressEvent(QMouseEvent* event) {
  if (comparing() && event->button() == Qt::LeftButton) {
    const QRectF frame = place(picture_);
    setDivider((event->position().x() - frame.left()) / std::max(1.0, frame.width()));
  }
}

void CompareView::mouseMoveEvent(QMouseEvent* event) {
  setCursor(comparing() ? Qt::SplitHCursor : Qt::ArrowCursor);
  if (!comparing() || !event->buttons().testFlag(Qt::LeftButton)) return;
  const QRectF frame = place(picture_);
  setDivider((event->position().x() - frame.left()) / std::max(1.0, frame.width()));
}

void CompareView::keyPressEvent(QKeyEvent* event) {
  if (comparing() && (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right))
    setDivider(divider_ + (event->key() == Qt::Key_Left ? -kStep : kStep));
  else
    QWidget::keyPressEvent(event);
}

}  // namespace idap
