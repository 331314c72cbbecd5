// Between the metres of a plane and the logical pixels of a view: one scale, v up against pixels down.
#pragma once

#include <QPointF>
#include <QRectF>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace idap {

struct ViewMap {
  double scale = 100;  // logical pixels a metre
  QPointF origin;      // where the plane's (0, 0) lies

  QPointF toView(Vec2 p) const { return {origin.x() + p.x * scale, origin.y() - p.y * scale}; }
  Vec2 toPlane(QPointF p) const { return {(p.x() - origin.x()) / scale, (origin.y() - p.y()) / scale}; }
  QRectF toView(const Box2& box) const {
    return QRectF(toView(Vec2{box.min.x, box.max.y}), toView(Vec2{box.max.x, box.min.y}));
  }
  Box2 toPlane(const QRectF& rect) const {
    const Vec2 a = toPlane(rect.bottomLeft()), b = toPlane(rect.topRight());
    return {a, b};
  }
  friend bool operator==(const ViewMap&, const ViewMap&) = default;
};

inline Box2 grown(Box2 box, double by) { return {box.min - Vec2{by, by}, box.max + Vec2{by, by}}; }
inline void add(Box2& box, const Box2& other) {
  if (other.empty()) return;
  box.add(other.min);
  box.add(other.max);
}

}  // namespace idap
