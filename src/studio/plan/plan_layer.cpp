#include "studio/plan/plan_layer.h"

#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr int kStrip = 64;  // device pixels, painted at once when time is short

}  // namespace

void PlanLayer::setSize(const QSize& logical, double ratio, const QColor& paper) {
  const QSize device(std::max(1, int(std::ceil(logical.width() * ratio))),
                     std::max(1, int(std::ceil(logical.height() * ratio))));
  if (device == pixmap_.size() && ratio == ratio_ && paper == paper_) return;
  const bool same = ratio == ratio_ && paper == paper_ && !pixmap_.isNull() && !whole_;
  QPixmap next(device);
  next.fill(paper);
  if (same) {  // what was seen is still right
    QPainter(&next).drawPixmap(0, 0, pixmap_);
    stale_ = (stale_ & QRect(QPoint(0, 0), device)) | (QRegion(QRect(QPoint(0, 0), device)) - deviceRect());
  }
  pixmap_ = std::move(next);
  ratio_ = ratio;
  paper_ = paper;
  if (!same) markAll();
}

void PlanLayer::setView(const ViewMap& view) {
  if (view == view_) return;
  const ViewMap old = view_;
  view_ = view;
  if (pixmap_.isNull()) return;
  const QPointF moved = (view.origin - old.origin) * ratio_;
  const QPoint steps = moved.toPoint();
  const bool whole = std::abs(moved.x() - steps.x()) < 1e-3 && std::abs(moved.y() - steps.y()) < 1e-3;
  if (view.scale == old.scale && whole) {
    if (std::abs(steps.x()) >= pixmap_.width() || std::abs(steps.y()) >= pixmap_.height()) {
      markAll();
      return;
    }
    QRegion exposed;
    pixmap_.scroll(steps.x(), steps.y(), deviceRect(), &exposed);
    stale_.translate(steps);
    stale_ = (stale_ | exposed) & deviceRect();
    return;
  }
  QPixmap stretched(pixmap_.size());
  stretched.fill(paper_);
  {
    QPainter painter(&stretched);
    const double s = view.scale / old.scale;
    painter.translate(view.origin * ratio_ - old.origin * ratio_ * s);
    painter.scale(s, s);
    painter.drawPixmap(0, 0, pixmap_);
  }
  pixmap_ = std::move(stretched);
  markAll();
}

void PlanLayer::markAll() {
  stale_ = deviceRect();
  whole_ = true;
  spent_ = 0;
}

void PlanLayer::mark(const QRectF& logical) {
  constexpr double kSlack = 3;  // pixels: pens and smoothing reach over the edge
  const QRectF device(logical.topLeft() * ratio_, logical.size() * ratio_);
  stale_ |=
      device.adjusted(-kSlack * ratio_, -kSlack * ratio_, kSlack * ratio_, kSlack * ratio_).toAlignedRect() &
      deviceRect();
}

void PlanLayer::repair(const Paint& paint, double budget) {
  if (stale_.isEmpty()) return;
  // Many scattered rectangles cost more than what is between them.
  constexpr int kMostRects = 12;
  if (stale_.rectCount() > kMostRects) stale_ = stale_.boundingRect();
  QElapsedTimer clock;
  clock.start();
  QPainter painter(&pixmap_);
  painter.scale(ratio_, ratio_);
  while (!stale_.isEmpty()) {
    QRect part = *stale_.begin();
    if (budget > 0) part.setHeight(std::min(part.height(), kStrip));
    const QRectF logical(QPointF(part.topLeft()) / ratio_, QSizeF(part.size()) / ratio_);
    painter.setClipRect(logical);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(logical, paper_);
    paint(painter, logical);
    stale_ -= part;
    if (budget > 0 && double(clock.nsecsElapsed()) * 1e-6 > budget) break;
  }
  spent_ += double(clock.nsecsElapsed()) * 1e-6;
  if (!stale_.isEmpty() || !whole_) return;
  whole_ = false;
  cost_ = spent_;
}

void PlanLayer::draw(QPainter& painter, const QRect& logical) const {
  const QRectF source(QPointF(logical.topLeft()) * ratio_, QSizeF(logical.size()) * ratio_);
  painter.drawPixmap(QRectF(logical), pixmap_, source);
}

}  // namespace idap
