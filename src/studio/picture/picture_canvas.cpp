#include "studio/picture/picture_canvas.h"

#include <cmath>

namespace idap {

namespace {

constexpr double kMostPixels = 500'000;  // more would be traced too slowly to be worth it
constexpr double kNarrowest = 0.6, kWidest = 2.4;

}  // namespace

PictureCanvas::PictureCanvas(QWidget* parent) : QWidget(parent) {
  setMinimumSize(80, 60);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PictureCanvas::setPicture(const QImage& picture) {
  picture_ = picture;
  update();
}

QSize PictureCanvas::pixels() const {
  const double ratio = devicePixelRatioF();
  double w = std::max(160.0, width() * ratio), h = std::max(120.0, height() * ratio);
  w = std::min(w, h * kWidest);
  h = std::min(h, w / kNarrowest);
  const double scale = std::min(1.0, std::sqrt(kMostPixels / (w * h)));
  return {int(std::lround(w * scale)), int(std::lround(h * scale))};
}

void PictureCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Window).darker(107));
  if (picture_.isNull()) return;
  const QSizeF size = QSizeF(picture_.size()).scaled(this->size(), Qt::KeepAspectRatio);
  const QRectF target(QPointF((width() - size.width()) / 2, (height() - size.height()) / 2), size);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(target, picture_);
}

void PictureCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) emit doubleClicked();
}

void PictureCanvas::resizeEvent(QResizeEvent*) { emit resized(); }

}  // namespace idap
