// A plane to scale; over several pages where one is too small, with marks to join them by.
#include <QFontInfo>
#include <QFontMetricsF>
#include <cmath>

#include "studio/plan/plan_scene.h"
#include "studio/print/sheets.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kMargin = 0.3;  // m around what is drawn
constexpr double kOverlap = 10;  // mm that neighbouring pages share
constexpr double kMark = 5;      // mm, half a joining mark

struct Tiling {
  int columns = 1, rows = 1;
  double stepX = 0, stepY = 0;  // mm from one page to the next
  double left = 0, top = 0;     // mm of the drawing's corner from that of the pages laid together
};

int pagesFor(double content, double room) {
  return content <= room + 0.01 ? 1 : int(std::ceil((content - kOverlap - 0.01) / (room - kOverlap)));
}

Tiling tile(QSizeF content, QSizeF room) {
  Tiling t;
  t.columns = pagesFor(content.width(), room.width());
  t.rows = pagesFor(content.height(), room.height());
  t.stepX = room.width() - kOverlap;
  t.stepY = room.height() - kOverlap;
  t.left = ((t.columns - 1) * t.stepX + room.width() - content.width()) / 2;
  t.top = ((t.rows - 1) * t.stepY + room.height() - content.height()) / 2;
  return t;
}

QString tileName(int column, int row) {
  QString letters;
  for (int n = row; n >= 0; n = n / 26 - 1) letters.prepend(QChar(u'A' + n % 26));
  return letters + QString::number(column + 1);
}

// Where the next page's edge comes to lie, with its name.
void joiningMarks(QPainter& p, const QRectF& area, const Tiling& t, int column, int row, QSizeF room) {
  inTenths(p, area);
  p.setPen(QPen(QColor(110, 110, 110), 1));
  p.setFont(paperFont(24));
  const double w = room.width() * 10, h = room.height() * 10, o = kOverlap * 10, m = kMark * 10;
  const auto cross = [&](double x, double y) {
    p.drawLine(QPointF(x - m, y), QPointF(x + m, y));
    p.drawLine(QPointF(x, y - m), QPointF(x, y + m));
  };
  const bool left = column > 0, right = column + 1 < t.columns, above = row > 0, below = row + 1 < t.rows;
  for (const double x : {o / 2, w - o / 2}) {
    if ((x < w / 2 && !left) || (x > w / 2 && !right)) continue;
    for (const double y : {o / 2, h - o / 2}) cross(x, y);
  }
  if (!left && !right)
    for (const double y : {o / 2, h - o / 2})
      if ((y < h / 2 && above) || (y > h / 2 && below)) cross(o / 2, y), cross(w - o / 2, y);
  const auto name = [&](const QRectF& box, int alignment, int c, int r) {
    p.drawText(box, alignment, QStringLiteral("→ %1").arg(tileName(c, r)));
  };
  if (right) name({w - 300, h / 2 - 20, 290, 40}, Qt::AlignRight, column + 1, row);
  if (below) name({w / 2 - 150, h - 40, 300, 36}, Qt::AlignCenter, column, row + 1);
  p.restore();
}

}  // namespace

std::vector<PrintPage> planSheets(const SheetContext& context, Plane plane) {
  const PrintJob& job = context.job;
  Home home = context.source.home;
  // The title block shows where north is; the compass, often far out, would only make the plan smaller.
  if (job.titleBlock) home.site.compassVisible = false;
  std::vector<LevelId> levels{context.source.level};
  if (plane == Plane::XY && job.allLevels && !home.levels.empty()) {
    levels.clear();
    for (const auto& [id, level] : home.levels) levels.push_back(id);
  }
  std::vector<PrintPage> pages;
  for (const LevelId level : levels) {
    const auto editor = context.editorOf(home, level);
    const auto scene = std::make_shared<PlanScene>(*editor, plane);
    scene->completeSymbols();
    const Box2 drawn = scene->bounds();
    if (drawn.empty() && levels.size() > 1) continue;  // an empty level
    const Box2 box = drawn.empty() ? Box2{{-5, -5}, {5, 5}} : grown(drawn, kMargin);
    const Vec2 metres = box.max - box.min;
    const double scale = job.scale > 0 ? job.scale : fittingScale(metres, context.room);
    const QSizeF room = context.room;
    const Tiling tiling = tile(QSizeF(metres.x, metres.y) * 1000 * scale, room);
    QString title = printed(sheetName(plane == Plane::XY   ? SheetKind::Plan
                                      : plane == Plane::XZ ? SheetKind::Front
                                                           : SheetKind::Side));
    const Level* named = home.levels.find(editor->level());
    if (named && plane == Plane::XY) title += QStringLiteral(" · ") + toQt(named->name);
    for (int row = 0; row < tiling.rows; ++row)
      for (int column = 0; column < tiling.columns; ++column) {
        PrintPage page;
        page.scale = scale;
        page.northUp = plane == Plane::XY;
        page.title = title;
        const bool tiled = tiling.rows * tiling.columns > 1;
        if (tiled) page.title += QStringLiteral(" · ") + tileName(column, row);
        // The part of the plane that this page shows.
        const double x = box.min.x + (column * tiling.stepX - tiling.left) / 1000 / scale;
        const double y = box.max.y - (row * tiling.stepY - tiling.top) / 1000 / scale;
        const Box2 part{{x, y - room.height() / 1000 / scale}, {x + room.width() / 1000 / scale, y}};
        page.paint = [editor, scene, part, room, tiling, column, row, tiled](QPainter& p,
                                                                             const QRectF& area) {
          const double dots = p.device()->logicalDpiX() / 25.4;
          QFont font = QApplication::font();
          font.setPixelSize(QFontInfo(font).pixelSize());
          drawPlan(p, QRectF(area.topLeft(), room * dots), part, *scene, font);
          if (tiled) joiningMarks(p, area, tiling, column, row, room);
        };
        pages.push_back(std::move(page));
      }
  }
  return pages;
}

}  // namespace idap
