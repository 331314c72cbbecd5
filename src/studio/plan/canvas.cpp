#include "studio/plan/canvas.h"

#include <QFontMetricsF>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "studio/widgets/texts.h"

namespace idap {

QPolygonF Canvas::polygon(const std::vector<Vec2>& points) const {
  QPolygonF mapped;
  mapped.reserve(qsizetype(points.size()));
  for (const Vec2 point : points) mapped << at(point);
  return mapped;
}

QPen Canvas::pen(const QColor& color, double width, Qt::PenStyle style) const {
  QPen pen(color, width, style, Qt::RoundCap, Qt::RoundJoin);
  if (style != Qt::SolidLine) pen.setCapStyle(Qt::FlatCap);
  if (!printing_ && width <= 1) {
    pen.setWidthF(1), pen.setCosmetic(true);
    // Dashes of the fastest lines would begin anew at the edge of each part that is painted.
    if (style != Qt::SolidLine) pen.setWidthF(kDashedWidth);
  }
  if (printing_) pen.setWidthF(width * 0.6);  // ink is sharper than a screen
  return pen;
}

QFont Canvas::fontOf(const TextStyle& style) const {
  QFont font = font_;
  if (!style.font.empty()) font.setFamily(toQt(style.font));
  // Pixel sizes are whole numbers; points of 1/96 inch are not.
  font.setPixelSize(std::max(1, int(std::lround(style.size * view.scale))));
  font.setBold(style.bold);
  font.setItalic(style.italic);
  return font;
}

QFont Canvas::smallFont(double pixels, bool bold) const {
  QFont font = font_;
  font.setPixelSize(std::max(1, int(std::lround(pixels))));
  font.setBold(bold);
  return font;
}

double uprightAngle(double angle) {
  angle = std::remainder(angle, 2 * kPi);
  constexpr double kSlack = 1e-6;
  if (angle > kPi / 2 + kSlack) angle -= kPi;
  if (angle <= -kPi / 2 + kSlack) angle += kPi;
  return angle;
}

void Canvas::text(Vec2 where, const QString& words, const QFont& font, double angle, TextAlignment alignment,
                  Ground ground) {
  if (words.isEmpty() || font.pixelSize() < kSmallestText) return;
  const QStringList lines = words.split(QLatin1Char('\n'));
  const QFontMetricsF metrics(font);
  const double height = metrics.height(), middle = (metrics.ascent() - metrics.descent()) / 2;
  double width = 0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));

  p.save();
  p.translate(at(where));
  angle = uprightAngle(angle);
  if (angle != 0) p.rotate(-angle * 180 / kPi);
  p.setFont(font);
  const double block = (double(lines.size()) - 1) * height;
  const double left = alignment == TextAlignment::Left    ? 0
                      : alignment == TextAlignment::Right ? -width
                                                          : -width / 2;
  if (ground != Ground::None) {
    const QRectF behind = QRectF(left, -height / 2 - block / 2, width, height + block).adjusted(-3, 0, 3, 0);
    const QPen pen = p.pen();
    p.setPen(Qt::NoPen);
    QColor paper = colors.paper;
    paper.setAlphaF(ground == Ground::Box ? 0.9f : 0.72f);
    p.setBrush(paper);
    p.drawRoundedRect(behind, 2, 2);
    p.setPen(pen);
  }
  for (qsizetype i = 0; i < lines.size(); ++i) {
    const double own = metrics.horizontalAdvance(lines[i]);
    const double x = alignment == TextAlignment::Left    ? 0
                     : alignment == TextAlignment::Right ? -own
                                                         : -own / 2;
    p.drawText(QPointF(x, middle - block / 2 + double(i) * height), lines[i]);
  }
  p.restore();
}

Box2 textBox(Vec2 where, const std::string& text, double size) {
  std::size_t longest = 0, line = 0, lines = 1;
  for (const char c : text) {
    if (c == '\n') {
      line = 0;
      ++lines;
    } else {
      longest = std::max(longest, ++line);
    }
  }
  // Generous, and the same in every direction: the text may be turned.
  const double reach = size * (double(longest) * 0.9 + double(lines) * 1.5 + 1);
  return grown({where, where}, reach);
}

}  // namespace idap
