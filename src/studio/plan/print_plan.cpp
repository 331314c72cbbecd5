#include "studio/plan/print_plan.h"

#include <QApplication>
#include <QDateTime>
#include <QFontInfo>
#include <QFontMetricsF>
#include <QLocale>
#include <QPrinter>
#include <algorithm>
#include <cmath>

#include "studio/plan/grid.h"
#include "studio/plan/plan_scene.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kScales[] = {1.0,       0.5,       0.2,        0.1,        1.0 / 20,   1.0 / 25,
                              1.0 / 50,  1.0 / 75,  1.0 / 100,  1.0 / 125,  1.0 / 150,  1.0 / 200,
                              1.0 / 250, 1.0 / 500, 1.0 / 1000, 1.0 / 2000, 1.0 / 5000, 1.0 / 10000};
constexpr double kBlock = 22;    // mm, height of the title block
constexpr double kMargin = 0.3;  // m around what is drawn

QString words(const char* english) { return QCoreApplication::translate("idap", english); }

Box2 printedBox(const PlanScene& scene) {
  const Box2 box = scene.bounds();
  return box.empty() ? Box2{{-5, -5}, {5, 5}} : grown(box, kMargin);
}

double fitting(const Box2& box, QSizeF room) {
  const Vec2 size = box.max - box.min;
  for (const double scale : kScales)
    if (size.x * 1000 * scale <= room.width() && size.y * 1000 * scale <= room.height()) return scale;
  return std::min(room.width() / (size.x * 1000), room.height() / (size.y * 1000));
}

QString scaleText(double scale) {
  return scale >= 1 ? QStringLiteral("%1:1").arg(scale) : QStringLiteral("1:%1").arg(std::lround(1 / scale));
}

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

QFont sized(QFont font, int tenths, bool bold = false) {
  font.setPixelSize(tenths);
  font.setBold(bold);
  return font;
}

// The painter counts in tenths of a millimetre: the sizes of fonts are whole numbers.
void titleBlock(QPainter& p, const QRectF& block, const Editor& editor, const PrintSettings& settings,
                double scale) {
  const Home& home = editor.home();
  p.setPen(QPen(Qt::black, 3));
  p.drawLine(block.topLeft(), block.topRight());
  const QFont font = QApplication::font();
  const double middle = block.left() + block.width() * 0.45;
  p.setFont(sized(font, 50, true));
  const QString title = toQt(!home.title.empty() ? home.title : home.name);
  const QRectF left(block.left(), block.top() + 15, middle - block.left() - 30, block.height() - 15);
  p.drawText(QRectF(left.topLeft(), QSizeF(left.width(), 62)), Qt::AlignLeft | Qt::AlignVCenter,
             QFontMetricsF(p.font()).elidedText(
                 title.isEmpty() ? words(QT_TRANSLATE_NOOP("idap", "Untitled home")) : title, Qt::ElideRight,
                 left.width()));
  p.setFont(sized(font, 28));
  p.drawText(left.adjusted(0, 66, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, toQt(home.notes));

  QString what = settings.plane == Plane::XY   ? words(QT_TRANSLATE_NOOP("idap", "Plan"))
                 : settings.plane == Plane::XZ ? words(QT_TRANSLATE_NOOP("idap", "Front elevation"))
                                               : words(QT_TRANSLATE_NOOP("idap", "Side elevation"));
  if (const Level* level = home.levels.find(editor.level()))
    what += QStringLiteral(" · ") + toQt(level->name);
  p.setFont(sized(font, 30));
  const QRectF right(middle, block.top() + 20,
                     block.right() - middle - (settings.plane == Plane::XY ? 170 : 0), block.height() - 20);
  p.drawText(QRectF(right.topLeft(), QSizeF(right.width(), 40)), Qt::AlignLeft | Qt::AlignVCenter,
             what + QStringLiteral("   ") + words(QT_TRANSLATE_NOOP("idap", "Scale")) + QLatin1Char(' ') +
                 scaleText(scale));
  p.drawText(QRectF(right.topLeft(), QSizeF(right.width(), 40)), Qt::AlignRight | Qt::AlignVCenter,
             QLocale().toString(QDate::currentDate(), QLocale::ShortFormat));
  scaleBar(p, {right.left(), right.top() + 75}, scale, editor.settings().unit, right.width() * 0.7);
  if (settings.plane == Plane::XY)
    northArrow(p, {block.right() - 75, block.top() + block.height() * 0.58}, 55, home.site.north);
}

}  // namespace

double fittingScale(const Editor& editor, Plane plane, QSizeF page, bool block) {
  const PlanScene scene(editor, plane);
  return fitting(printedBox(scene), {page.width(), page.height() - (block ? kBlock : 0)});
}

void printPlan(QPrinter& printer, const Editor& editor, const PrintSettings& settings) {
  QPainter painter(&printer);
  printPlan(painter, QRectF(QPointF(0, 0), printer.pageLayout().paintRectPixels(printer.resolution()).size()),
            editor, settings);
}

void printPlan(QPainter& p, const QRectF& page, const Editor& editor, const PrintSettings& settings) {
  const double dotsPerMm = p.device()->logicalDpiX() / 25.4;
  PlanScene scene(editor, settings.plane);
  scene.completeSymbols();
  const QSizeF room(page.width() / dotsPerMm, page.height() / dotsPerMm - (settings.titleBlock ? kBlock : 0));
  const Box2 box = printedBox(scene);
  const double scale = settings.scale > 0 ? settings.scale : fitting(box, room);
  // The area that this room shows at this scale, about the middle of what is drawn.
  const Vec2 middle = (box.min + box.max) * 0.5,
             half{room.width() / 2000 / scale, room.height() / 2000 / scale};
  QFont font = QApplication::font();
  font.setPixelSize(QFontInfo(font).pixelSize());
  drawPlan(p, QRectF(page.topLeft(), room * dotsPerMm), {middle - half, middle + half}, scene, font);
  if (!settings.titleBlock) return;
  p.save();
  p.translate(page.left(), page.top() + room.height() * dotsPerMm);
  p.scale(dotsPerMm / 10, dotsPerMm / 10);
  titleBlock(p, QRectF(0, 0, room.width() * 10, kBlock * 10), editor, settings, scale);
  p.restore();
}

}  // namespace idap
