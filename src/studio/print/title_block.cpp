#include <QApplication>
#include <QDateTime>
#include <QFontMetricsF>
#include <QLocale>
#include <cmath>

#include "studio/plan/grid.h"
#include "studio/print/sheets.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// A ruler to measure by with the eye, or after a copy was made smaller.
void scaleBar(QPainter& p, QPointF at, double scale, LengthUnit unit, double most) {
  const double perMetre = 10'000 * scale;
  double step = rulerStep(unit, perMetre, most / 10);
  if (4 * step * perMetre > most) step /= 2;
  const double wide = step * perMetre;
  p.setPen(QPen(Qt::black, 2));
  for (int i = 0; i < 4; ++i) {
    p.setBrush(i % 2 == 0 ? Qt::black : Qt::white);
    p.drawRect(QRectF(at.x() + i * wide, at.y(), wide, 16));
  }
  for (const int i : {0, 2, 4}) {
    const QString number = i == 0 ? QStringLiteral("0") : lengthText(i * step, unit, 2);
    const double width = QFontMetricsF(p.font()).horizontalAdvance(number);
    p.drawText(QPointF(at.x() + i * wide - (i == 0 ? 0 : width / 2), at.y() + 48), number);
  }
}

void northArrow(QPainter& p, QPointF at, double radius, double north) {
  p.save();
  p.translate(at);
  p.rotate(-north * 180 / kPi);
  p.setPen(QPen(Qt::black, 2));
  p.setBrush(Qt::NoBrush);
  p.drawEllipse(QPointF(0, 0), radius, radius);
  p.setBrush(Qt::black);
  p.drawPolygon(
      QPolygonF{QPointF(0, -radius), QPointF(radius * 0.35, radius * 0.6), QPointF(0, radius * 0.3)});
  p.setBrush(Qt::white);
  p.drawPolygon(
      QPolygonF{QPointF(0, -radius), QPointF(0, radius * 0.3), QPointF(-radius * 0.35, radius * 0.6)});
  const double width = QFontMetricsF(p.font()).horizontalAdvance(QLatin1Char('N'));
  p.drawText(QPointF(-width / 2, -radius - 8), QStringLiteral("N"));
  p.restore();
}

}  // namespace

QString printed(const char* english) { return QCoreApplication::translate("idap", english); }

QFont paperFont(int tenths, bool bold) {
  QFont font = QApplication::font();
  font.setPixelSize(tenths);
  font.setBold(bold);
  return font;
}

QRectF inTenths(QPainter& p, const QRectF& area) {
  const double dots = p.device()->logicalDpiX() / 254.0;
  p.save();
  p.translate(area.topLeft());
  p.scale(dots, dots);
  return {0, 0, area.width() / dots, area.height() / dots};
}

void paintTitleBlock(QPainter& p, const QRectF& area, const PrintSource& source, const QString& what,
                     double scale, std::optional<double> north, int page, int pages) {
  const Home& home = source.home;
  const QRectF block = area.adjusted(0, area.height() - kTitleBlock * 10, 0, 0);
  p.setPen(QPen(Qt::black, 3));
  p.drawLine(block.topLeft(), block.topRight());
  const double middle = block.left() + block.width() * 0.45;
  const auto line = [&](const QRectF& box, int alignment, const QString& text) {
    p.drawText(box, alignment | Qt::AlignVCenter,
               QFontMetricsF(p.font()).elidedText(text, Qt::ElideRight, box.width()));
  };
  p.setFont(paperFont(50, true));
  const QString title = toQt(!home.title.empty() ? home.title : home.name);
  const QRectF left(block.left(), block.top() + 15, middle - block.left() - 30, block.height() - 15);
  line({left.topLeft(), QSizeF(left.width(), 62)}, Qt::AlignLeft,
       title.isEmpty() ? printed(QT_TRANSLATE_NOOP("idap", "Untitled home")) : title);
  p.setFont(paperFont(28));
  p.drawText(left.adjusted(0, 66, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, toQt(home.notes));

  const QRectF right(middle, block.top() + 16, block.right() - middle - (north ? 170 : 0),
                     block.height() - 16);
  const QString date = QLocale().toString(QDate::currentDate(), QLocale::ShortFormat);
  p.setFont(paperFont(30));
  const double dateWidth = QFontMetricsF(p.font()).horizontalAdvance(date) + 20;
  line({right.topLeft(), QSizeF(right.width() - dateWidth, 40)}, Qt::AlignLeft, what);
  line({right.left(), right.top(), right.width(), 40}, Qt::AlignRight, date);
  const QRectF second(right.left(), right.top() + 42, right.width(), 40);
  p.setFont(paperFont(28));
  if (scale > 0)
    line(second, Qt::AlignLeft,
         printed(QT_TRANSLATE_NOOP("idap", "Scale")) + QLatin1Char(' ') + scaleText(scale));
  if (pages > 1)
    line(second, Qt::AlignRight, printed(QT_TRANSLATE_NOOP("idap", "Sheet %1 of %2")).arg(page).arg(pages));
  if (scale > 0)
    scaleBar(p, {right.left(), right.top() + 100}, scale, source.settings.unit, right.width() * 0.7);
  if (north) northArrow(p, {block.right() - 75, block.top() + block.height() * 0.58}, 55, *north);
}

}  // namespace idap
