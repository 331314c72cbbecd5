#include <QPainterPath>
#include <cmath>

#include "studio/plan/opening_shape.h"
#include "studio/plan/painters.h"
#include "studio/plan/piece_items.h"

namespace idap {

namespace {

std::vector<Vec2> list(const std::array<Vec2, 4>& corners) { return {corners.begin(), corners.end()}; }

// A line that divides the opening lengthwise; share 0: at its front, 1: at its back.
void lengthwise(Canvas& c, const std::array<Vec2, 4>& box, double share) {
  c.line(box[0] + (box[3] - box[0]) * share, box[1] + (box[2] - box[1]) * share);
}

class OpeningPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const PieceItem* item : drawing.pieces.items())
      if (item->opening && c.shows(item->box)) draw(drawing, c, *item->opening);
  }

  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    addChanged(
        diff.openings, before.home.openings, after.home.openings,
        [&](OpeningId, const Opening& o) { return openingBox(before.home, o); },
        [&](OpeningId, const Opening& o) { return openingBox(after.home, o); }, dirty);
  }

 private:
  static void draw(const Drawing& drawing, Canvas& c, const Opening& opening) {
    const OpeningShape shape = openingShape(drawing.home, opening);
    // The wall is not there.
    c.p.setPen(c.pen(c.colors.paper, 1.6));
    c.p.setBrush(c.colors.paper);
    const std::vector<Vec2> hole = list(shape.hole);
    c.p.drawPolygon(c.polygon(hole));
    const QPen line = c.pen(c.colors.ink, 1), thin = c.pen(c.colors.soft, 1);
    c.p.setBrush(Qt::NoBrush);
    c.p.setPen(line);
    c.line(hole[0], hole[3]);
    c.line(hole[1], hole[2]);
    switch (opening.kind) {
      case OpeningKind::Window:
        c.p.drawPolygon(c.polygon(list(shape.frame)));
        lengthwise(c, shape.frame, 0.5);
        c.p.setPen(thin);
        lengthwise(c, shape.hole, 0);
        lengthwise(c, shape.hole, 1);
        break;
      case OpeningKind::Door:
        // The threshold, faintly: the floor goes on.
        c.p.setPen(c.pen(c.colors.faint));
        lengthwise(c, shape.hole, 0);
        lengthwise(c, shape.hole, 1);
        if (shape.leaves.empty()) {  // it slides
          c.p.setPen(line);
          for (const auto& [from, to, y] : {std::tuple{0.0, 0.54, 0.4}, std::tuple{0.46, 1.0, 0.6}}) {
            const auto at = [&](double u, double v) {
              return hole[0] + (hole[1] - hole[0]) * u + (hole[3] - hole[0]) * v;
            };
            c.p.drawPolygon(
                c.polygon({at(from, y - 0.09), at(to, y - 0.09), at(to, y + 0.09), at(from, y + 0.09)}));
          }
        }
        break;
      case OpeningKind::Bare:
        c.p.setPen(c.pen(c.colors.soft, 1, Qt::DashLine));
        lengthwise(c, shape.hole, 0);
        lengthwise(c, shape.hole, 1);
        break;
    }
    for (const OpeningShape::Leaf& leaf : shape.leaves) drawLeaf(c, leaf, opening.kind == OpeningKind::Door);
  }

  static void drawLeaf(Canvas& c, const OpeningShape::Leaf& leaf, bool door) {
    const double turn = leaf.to - leaf.from;
    if (std::abs(turn) < 1e-6 || leaf.width * c.view.scale < 5) return;
    const QPointF axis = c.at(leaf.axis);
    const double r = leaf.width * c.view.scale;
    c.p.setBrush(Qt::NoBrush);
    c.p.setPen(c.pen(door ? c.colors.soft : c.colors.faint));
    QPainterPath arc;
    const QRectF circle(axis.x() - r, axis.y() - r, 2 * r, 2 * r);
    arc.arcMoveTo(circle, leaf.from * 180 / kPi);
    arc.arcTo(circle, leaf.from * 180 / kPi, turn * 180 / kPi);
    c.p.drawPath(arc);
    const Vec2 along = rotated(Vec2{1, 0}, leaf.to);
    if (!door) {
      c.line(leaf.axis, leaf.axis + along * leaf.width);
      return;
    }
    // The leaf, open, with its thickness.
    constexpr double kThick = 0.04;
    const Vec2 across = perpendicular(along) * (turn > 0 ? -kThick : kThick);
    c.p.setPen(c.pen(c.colors.ink, 1.2));
    c.p.setBrush(c.colors.paper);
    c.p.drawPolygon(c.polygon({leaf.axis, leaf.axis + along * leaf.width,
                               leaf.axis + along * leaf.width + across, leaf.axis + across}));
  }
};

}  // namespace

const Painter& openingPainter() {
  static const OpeningPainter painter;
  return painter;
}

}  // namespace idap
