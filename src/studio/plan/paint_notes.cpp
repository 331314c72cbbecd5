// What is written over a drawing: dimensions; on the plan labels and polylines.
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <optional>

#include "editor/hit_test_shapes.h"
#include "studio/plan/painters.h"
#include "studio/plan/smooth_line.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// On the plan, and from the side where it tells a height.
class DimensionPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, dimension] : drawing.home.dimensions)
      if (const auto line = lineOf(drawing, *dimension); line && c.shows(dimensionBox(*line, *dimension), 10))
        draw(drawing, c, *dimension, *line);
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [](const Drawing& drawing) {
      return [&drawing](DimensionId, const Dimension& d) {
        const auto line = lineOf(drawing, d);
        return line ? dimensionBox(*line, d) : Box2{};
      };
    };
    addChanged(diff.dimensions, before.home.dimensions, after.home.dimensions, box(before), box(after),
               dirty);
  }
  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, d] : drawing.home.dimensions)
      if (const auto line = lineOf(drawing, *d)) box.add(line->from), box.add(line->to);
  }

 private:
  static std::optional<DimensionLine> lineOf(const Drawing& drawing, const Dimension& d) {
    if (!(d.level == drawing.level)) return {};
    return dimensionLine(drawing.plane, d, drawing.elevation());
  }
  static Box2 dimensionBox(const DimensionLine& line, const Dimension& d) {
    Box2 box;
    for (const Vec2 p : {line.start, line.end, line.from, line.to}) box.add(p);
    return grown(box, d.textSize * 4 + 0.1);  // a text may be longer than its line
  }
  static void draw(const Drawing& drawing, Canvas& c, const Dimension& d, const DimensionLine& line) {
    const Vec2 a = line.from, b = line.to, aside = a - line.start;
    const Vec2 along = (b - a) / length(b - a);
    const QColor color = d.color ? c.colors.readable(*d.color) : c.colors.ink;
    c.p.setPen(c.pen(mixed(c.colors.paper, color, 0.5)));
    if (const double reach = length(aside);
        reach > 1e-9) {  // extension lines, a little off what they measure
      const Vec2 way = aside / reach;
      const double off = std::min(3 / c.view.scale, reach / 2), past = 4 / c.view.scale;
      c.line(line.start + way * off, a + way * past);
      c.line(line.end + way * off, b + way * past);
    }
    c.p.setPen(c.pen(color, 1));
    c.line(a, b);
    // Oblique ticks, as architects draw them.
    const Vec2 tick = rotated(along, kPi / 4) * (5 / c.view.scale);
    c.p.setPen(c.pen(color, 1.6));
    c.line(a - tick, a + tick);
    c.line(b - tick, b + tick);
    TextStyle style;
    style.size = d.textSize;
    // What is measured lies in space: its length is the same on every plane.
    const double measured = std::hypot(length(d.end - d.start), d.endElevation - d.startElevation);
    const double angle = uprightAngle(std::atan2(along.y, along.x));
    // On the side away from what is measured, where there is room; above a line that lies on it.
    Vec2 beside = perpendicular(rotated(Vec2{1, 0}, angle));
    if (dot(beside, aside) < -1e-9) beside = -beside;
    beside = beside * (d.textSize * 0.62 + 2 / c.view.scale);
    c.p.setPen(c.pen(color));
    // From the side it stands before walls and furniture.
    c.text((a + b) * 0.5 + beside, lengthText(measured, drawing.settings.unit), c.fontOf(style), angle,
           TextAlignment::Centre, drawing.plane == Plane::XY ? Canvas::Ground::None : Canvas::Ground::Halo);
  }
};

class LabelPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, label] : drawing.home.labels) {
      if (!(label->level == drawing.level) || !c.shows(labelBox(*label))) continue;
      c.p.setPen(c.pen(label->style.color ? c.colors.readable(*label->style.color) : c.colors.ink));
      c.text(label->position, toQt(label->text), c.fontOf(label->style), label->angle,
             label->style.alignment);
    }
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [](LabelId, const Label& label) { return labelBox(label); };
    addChanged(diff.labels, before.home.labels, after.home.labels, box, box, dirty);
  }
  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, label] : drawing.home.labels)
      if (label->level == drawing.level) box.add(label->position);
  }

 private:
  static Box2 labelBox(const Label& label) { return textBox(label.position, label.text, label.style.size); }
};

class PolylinePainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    for (const auto& [id, line] : drawing.home.polylines)
      if (line->level == drawing.level && c.shows(lineBox(*line), 4)) draw(c, *line);
  }
  void changed(const HomeDiff& diff, const Drawing& before, const Drawing& after,
               DirtyBoxes& dirty) const override {
    const auto box = [](PolylineId, const Polyline& line) { return lineBox(line); };
    addChanged(diff.polylines, before.home.polylines, after.home.polylines, box, box, dirty);
  }
  void extend(const Drawing& drawing, Box2& box) const override {
    for (const auto& [id, line] : drawing.home.polylines)
      if (line->level == drawing.level) add(box, bounds(line->points));
  }

 private:
  // Curves stay within half the longest step of their points; arrows are four lines wide.
  static Box2 lineBox(const Polyline& line) {
    double longest = 0;
    for (std::size_t i = 1; i < line.points.size(); ++i)
      longest = std::max(longest, length(line.points[i] - line.points[i - 1]));
    return grown(bounds(line.points), 4 * line.thickness + (line.curved ? longest / 2 : 0) + 0.02);
  }

  static void draw(Canvas& c, const Polyline& line) {
    if (line.points.size() < 2) return;
    const QColor color = c.colors.readable(line.color);
    const double width = std::max(1.0, line.thickness * c.view.scale);
    QPen pen = c.pen(color, 1.01);
    pen.setWidthF(width);
    pen.setCapStyle(Qt::FlatCap);
    switch (line.dash) {
      case LineDash::Solid:
        break;
      case LineDash::Dot:
        pen.setStyle(Qt::DotLine);
        break;
      case LineDash::Dash:
        pen.setStyle(Qt::DashLine);
        break;
      case LineDash::DashDot:
        pen.setStyle(Qt::DashDotLine);
        break;
      case LineDash::DashDotDot:
        pen.setStyle(Qt::DashDotDotLine);
        break;
    }
    c.p.setPen(pen);
    c.p.setBrush(Qt::NoBrush);
    const std::vector<Vec2> points = line.curved ? smoothLine(line.points, line.closed) : line.points;
    if (line.closed) {
      c.p.drawPolygon(c.polygon(points));
      return;
    }
    c.p.drawPolyline(c.polygon(points));
    arrow(c, line.startArrow, points[0], points[0] - points[1], color, width);
    arrow(c, line.endArrow, points.back(), points.back() - points[points.size() - 2], color, width);
  }

  static void arrow(Canvas& c, LineArrow kind, Vec2 tip, Vec2 way, const QColor& color, double width) {
    const double distance = length(way);
    if (kind == LineArrow::None || distance < 1e-9) return;
    const double size = std::max(6.0, 3.2 * width) / c.view.scale;
    const Vec2 along = way / distance * size, across = perpendicular(along) * 0.42;
    c.p.setPen(c.pen(color, std::max(1.0, std::min(width, 3.0))));
    switch (kind) {
      case LineArrow::Delta:
        c.p.setBrush(color);
        c.p.drawPolygon(c.polygon({tip, tip - along + across, tip - along - across}));
        break;
      case LineArrow::Open:
        c.p.setBrush(Qt::NoBrush);
        c.p.drawPolyline(c.polygon({tip - along + across, tip, tip - along - across}));
        break;
      case LineArrow::Disc:
        c.p.setBrush(color);
        c.p.drawEllipse(c.at(tip), size * c.view.scale * 0.4, size * c.view.scale * 0.4);
        break;
      case LineArrow::None:
        break;
    }
  }
};

}  // namespace

const Painter& dimensionPainter() {
  static const DimensionPainter painter;
  return painter;
}
const Painter& labelPainter() {
  static const LabelPainter painter;
  return painter;
}
const Painter& polylinePainter() {
  static const PolylinePainter painter;
  return painter;
}

}  // namespace idap
