#include <QFontMetricsF>
#include <cmath>

#include "model/edits/level_edits.h"
#include "studio/plan/elevation.h"
#include "studio/plan/paint_overlay.h"
#include "studio/widgets/texts.h"

namespace idap {

void paintHeights(const Drawing& drawing, Canvas& c, const QRectF& visible) {
  const QFont font = c.smallFont(c.font().pixelSize() * 0.88);
  const QFontMetricsF metrics(font);
  c.p.setFont(font);
  double last = 1e9;  // numbers that would stand on each other are left out
  const auto write = [&](double z, const QString& name, const QColor& color) {
    const double y = c.at({0, z}).y();
    if (y < visible.top() || y > visible.bottom() + metrics.height() || std::abs(y - last) < metrics.height())
      return;
    last = y;
    QString words = (z > 1e-9 ? QStringLiteral("+") : QString()) + lengthText(z, drawing.settings.unit);
    if (!name.isEmpty()) words += QStringLiteral("  ") + name;
    // The sign for a height on sections: a triangle that stands on its line.
    const QPointF foot(visible.left() + 10, y);
    c.p.setPen(c.pen(color, 1));
    c.p.setBrush(color);
    c.p.drawPolygon(QPolygonF{foot, foot + QPointF(-4, -6), foot + QPointF(4, -6)});
    const QRectF behind(foot.x() + 7, y - 2 - metrics.height(), metrics.horizontalAdvance(words) + 4,
                        metrics.height());
    QColor paper = c.colors.paper;
    paper.setAlphaF(0.8f);
    c.p.fillRect(behind, paper);
    c.p.drawText(QPointF(foot.x() + 9, y - 2 - metrics.descent()), words);
  };
  const double floor = drawing.elevation();
  const Level* own = drawing.home.levels.find(drawing.level);
  write(floor, own ? toQt(own->name) : QString(), c.colors.ink);
  write(floor + ceilingHeight(drawing.home, drawing.level), QString(), c.colors.ink);
  for (const auto& [id, level] : drawing.home.levels)
    if (!(id == drawing.level)) write(level->elevation, toQt(level->name), c.colors.soft);
}

}  // namespace idap
