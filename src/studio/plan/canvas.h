// What painters draw with: the painter, the way from metres to pixels, the colours, and the little drawing
// that all of them share. One unit of the painter is a logical pixel, on paper 1/96 inch.
#pragma once

#include <QFont>
#include <QPainter>
#include <QPen>
#include <QPolygonF>
#include <QString>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "model/annotation.h"
#include "model/text_style.h"
#include "studio/plan/plan_colors.h"
#include "studio/plan/view_map.h"

namespace idap {

// Texts smaller than this, in pixels, are left out: nobody can read them.
inline constexpr double kSmallestText = 7;
// Pixels that a dashed line is wide at least; its dashes are counted in this.
inline constexpr double kDashedWidth = 1.01;

class Canvas {
 public:
  Canvas(QPainter& painter, const ViewMap& map, const PlanColors& planColors, const Box2& shown, QFont font,
         bool printing)
      : p(painter), view(map), colors(planColors), area(shown), font_(std::move(font)), printing_(printing) {}

  QPainter& p;
  const ViewMap& view;
  const PlanColors& colors;
  const Box2 area;  // of the plane, that is to be drawn

  bool printing() const { return printing_; }
  const QFont& font() const { return font_; }
  QPointF at(Vec2 point) const { return view.toView(point); }
  QPolygonF polygon(const std::vector<Vec2>& points) const;
  bool shows(const Box2& box, double pixels = 2) const {
    return area.overlaps(grown(box, pixels / view.scale));
  }

  // A line of so many pixels; one pixel wide lines are the fastest and sharpest.
  QPen pen(const QColor& color, double width = 1, Qt::PenStyle style = Qt::SolidLine) const;
  QFont fontOf(const TextStyle& style) const;               // at its size on the plan
  QFont smallFont(double pixels, bool bold = false) const;  // at a size on the screen

  void line(Vec2 a, Vec2 b) { p.drawLine(at(a), at(b)); }

  // Lines of text, the first's middle line through the point for one line (the block's for many); turned by
  // radians counter-clockwise, but never upside down. Left out when too small to be read.
  enum class Ground { None, Halo, Box };
  void text(Vec2 where, const QString& words, const QFont& font, double angle = 0,
            TextAlignment alignment = TextAlignment::Centre, Ground ground = Ground::None);

 private:
  QFont font_;
  bool printing_;
};

// radians, turned by half a turn where text along it would stand on its head.
double uprightAngle(double angle);

// About how much of the plane a text covers, in metres: for knowing what to repaint.
Box2 textBox(Vec2 where, const std::string& text, double size);

}  // namespace idap
