// The drawing of a plane as a picture that is kept: panning moves it, a change paints only where it is, so
// that the cost of a frame does not grow with the home.
#pragma once

#include <QPixmap>
#include <QRegion>
#include <functional>

#include "studio/plan/view_map.h"

namespace idap {

class PlanLayer {
 public:
  // Paints an area, given in logical pixels of the view; clipped to it already, on paper already.
  using Paint = std::function<void(QPainter& painter, const QRectF& area)>;

  void setSize(const QSize& logical, double devicePixelRatio, const QColor& paper);
  // A move by whole device pixels at the same scale keeps what is there. Otherwise all is to be painted anew;
  // until it is, the old picture stands in, scaled.
  void setView(const ViewMap& view);
  const ViewMap& view() const { return view_; }

  void markAll();
  void mark(const QRectF& logical);
  bool stale() const { return !stale_.isEmpty(); }
  bool wholeStale() const { return whole_; }
  double wholeCost() const { return cost_; }  // ms that painting all took the last time

  // Brings everything up to date; with a budget (ms) as much as fits, at least a strip.
  void repair(const Paint& paint, double budget = 0);
  void draw(QPainter& painter, const QRect& logical) const;

 private:
  QRect deviceRect() const { return QRect(QPoint(0, 0), pixmap_.size()); }

  QPixmap pixmap_;
  double ratio_ = 1;
  QColor paper_;
  ViewMap view_;
  QRegion stale_;  // device pixels
  bool whole_ = true;
  double spent_ = 0, cost_ = 0;  // ms, on the whole that is being painted; on the last one
};

}  // namespace idap
