#include "studio/plan/rulers.h"

#include <QFontMetrics>
#include <cmath>

#include "studio/plan/grid.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

QFont numbersFont(const QFont& font) {
  QFont small = font;
  small.setPixelSize(std::max(8, int(std::lround(QFontMetrics(font).height() * 0.62))));
  return small;
}

}  // namespace

int rulerThickness(const QFont& font) { return QFontMetrics(numbersFont(font)).height() + 5; }

void paintRulers(QPainter& p, const QRect& frame, const ViewMap& view, const PlanColors& colors,
                 const QFont& font, LengthUnit unit, const std::optional<QPointF>& pointer) {
  const int thick = rulerThickness(font);
  const QFont numbers = numbersFont(font);
  const QFontMetrics metrics(numbers);
  const QColor ground = mixed(colors.paper, colors.ink, 0.06);
  p.setRenderHint(QPainter::Antialiasing, false);
  const QRect top(frame.left(), frame.top(), frame.width(), thick),
      left(frame.left(), frame.top(), thick, frame.height());
  p.fillRect(top, ground);
  p.fillRect(left, ground);
  p.setPen(colors.gridStrong);
  p.drawLine(left.right(), top.bottom(), top.right(), top.bottom());
  p.drawLine(left.right(), top.bottom(), left.right(), left.bottom());

  const double step = rulerStep(unit, view.scale, metrics.horizontalAdvance(QStringLiteral("00000")) + 12);
  const double fine = rulerStep(unit, view.scale, 6);
  p.setFont(numbers);
  const auto each = [&](double from, double to, double every, const auto& draw) {
    for (auto i = std::llround(std::ceil(from / every)); double(i) * every <= to; ++i)
      draw(double(i) * every);
  };
  const Vec2 low = view.toPlane(QPointF(left.right(), frame.bottom())),
             high = view.toPlane(QPointF(frame.right(), top.bottom()));
  const QColor tick = colors.faint;
  p.save();
  p.setClipRect(QRect(left.right() + 1, top.top(), frame.width(), thick));
  p.setPen(tick);
  each(low.x, high.x, fine, [&](double x) {
    const int at = int(std::lround(view.toView(Vec2{x, 0}).x()));
    p.drawLine(at, top.bottom() - 3, at, top.bottom());
  });
  each(low.x - step, high.x, step, [&](double x) {
    const int at = int(std::lround(view.toView(Vec2{x, 0}).x()));
    p.setPen(tick);
    p.drawLine(at, top.top() + 2, at, top.bottom());
    p.setPen(colors.soft);
    p.drawText(at + 3, top.top() + metrics.ascent() + 1, toQt(rulerNumber(x, unit, step)));
  });
  p.restore();
  p.save();
  p.setClipRect(QRect(left.left(), top.bottom() + 1, thick, frame.height()));
  p.setPen(tick);
  each(low.y, high.y, fine, [&](double y) {
    const int at = int(std::lround(view.toView(Vec2{0, y}).y()));
    p.drawLine(left.right() - 3, at, left.right(), at);
  });
  each(low.y, high.y + step, step, [&](double y) {
    const int at = int(std::lround(view.toView(Vec2{0, y}).y()));
    p.setPen(tick);
    p.drawLine(left.left() + 2, at, left.right(), at);
    p.setPen(colors.soft);
    const QString number = toQt(rulerNumber(y, unit, step));
    p.save();
    p.translate(left.left() + metrics.ascent() + 1, at - 3);
    p.rotate(-90);
    p.drawText(0, 0, number);
    p.restore();
  });
  p.restore();
  p.fillRect(QRect(left.topLeft(), QSize(thick, thick)), ground);
  if (pointer) {
    p.setPen(QPen(colors.accent, 1));
    const QPoint at = pointer->toPoint();
    if (at.x() > left.right()) p.drawLine(at.x(), top.top(), at.x(), top.bottom());
    if (at.y() > top.bottom()) p.drawLine(left.left(), at.y(), left.right(), at.y());
  }
  p.setRenderHint(QPainter::Antialiasing, true);
}

}  // namespace idap
