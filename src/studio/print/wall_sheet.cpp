// Straight views at the walls of rooms, with what is in them and what stands before them, as kitchens and
// baths are planned with.
#include <QFontInfo>
#include <QFontMetricsF>
#include <cmath>

#include "geometry/polygon.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/element_edits.h"
#include "studio/plan/plan_scene.h"
#include "studio/print/sheets.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kShortest = 0.4;   // m; shorter stretches of wall are shown by their neighbours
constexpr double kNearWall = 0.15;  // m from an edge of the room to the face of its wall
constexpr double kBefore = 1.3;     // m before the wall: what stands there is shown
constexpr double kAround = 14;      // mm around a view, for its dimensions and name
constexpr double kName = 8;         // mm under a view

// One wall of a room as it is seen from inside, left to right along x.
struct WallView {
  QString name;
  std::shared_ptr<Editor> editor;
  std::shared_ptr<PlanScene> scene;
  double length = 0, height = 0;  // m
  Box2 box;                       // of the drawing, on its plane
  double floor = 0;               // height of the floor on it
  double left = 0;                // x of the wall's visible left end
};

bool runsAlong(const Wall& wall, Vec2 a, Vec2 b) {
  const Vec2 d = wall.end - wall.start;
  const double l = length(d);
  if (l < 1e-6 || wall.arcExtent != 0) return false;
  const Vec2 along = d / l, edge = normalized(b - a);
  if (std::abs(cross(along, edge)) > 0.02) return false;
  const Vec2 middle = (a + b) / 2;
  const double t = dot(middle - wall.start, along);
  if (t < -0.1 || t > l + 0.1) return false;
  return std::abs(cross(along, middle - wall.start)) < wall.thickness / 2 + kNearWall;
}

double distanceToEdge(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t = std::clamp(dot(p - a, d) / std::max(dot(d, d), 1e-12), 0.0, 1.0);
  return length(p - a - d * t);
}

std::optional<WallView> wallView(const SheetContext& context, const Room& room, std::size_t edge) {
  const Home& home = context.source.home;
  Polygon ring = room.points;
  if (signedArea(ring) < 0) std::reverse(ring.begin(), ring.end());
  const Vec2 a = ring[edge], b = ring[(edge + 1) % ring.size()];
  const double l = length(b - a);
  if (l < kShortest) return std::nullopt;
  Elements shown;
  double height = 0;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != room.level || !runsAlong(*wall, a, b)) continue;
    shown.walls.push_back(id);
    height = std::max({height, wall->heightAtStart, wall->heightAtEnd});
  }
  if (shown.walls.empty()) return std::nullopt;
  for (const auto& [id, opening] : home.openings)
    if (std::find(shown.walls.begin(), shown.walls.end(), opening->wall) != shown.walls.end() &&
        distanceToEdge({opening->position.x, opening->position.y}, a, b) < 0.5)
      shown.openings.push_back(id);
  for (const auto& [id, piece] : home.furniture) {
    if (piece->level != room.level || !isShown(home, *piece)) continue;
    const Vec2 at{piece->position.x, piece->position.y};
    if (contains(ring, at) && distanceToEdge(at, a, b) < kBefore) shown.furniture.push_back(id);
  }
  // Turned so that who looks along +y looks at the wall from inside.
  Home part = extractElements(home, shown);
  const Vec2 inward = perpendicular(normalized(b - a));
  const double turn = std::atan2(-1.0, 0.0) - std::atan2(inward.y, inward.x);
  part = turnElements(part, allElements(part), a, turn);
  WallView view;
  view.editor = context.editorOf(part, part.walls.begin()->second->level);
  view.scene = std::make_shared<PlanScene>(*view.editor, Plane::XZ);
  view.scene->cutBefore();
  view.scene->completeSymbols();
  const Vec2 a2 = a, b2 = a + rotated(b - a, turn);
  view.length = l;
  view.height = height;
  view.floor = view.editor->elevation();
  view.left = std::min(a2.x, b2.x);
  view.box = {{view.left - 0.05, view.floor - 0.05}, {view.left + l + 0.05, view.floor + height + 0.05}};
  return view;
}

// A line with ticks at its ends and words over its middle; tenths of a millimetre.
void dimension(QPainter& p, QPointF from, QPointF to, const QString& words) {
  p.setPen(QPen(Qt::black, 1.5));
  p.drawLine(from, to);
  const bool upright = std::abs(to.y() - from.y()) > std::abs(to.x() - from.x());
  for (const QPointF end : {from, to}) p.drawLine(end + QPointF(-8, 8), end + QPointF(8, -8));
  p.save();
  p.translate((from + to) / 2);
  if (upright) p.rotate(-90);
  p.setFont(paperFont(26));
  const double width = QFontMetricsF(p.font()).horizontalAdvance(words);
  p.drawText(QPointF(-width / 2, -8), words);
  p.restore();
}

struct Placed {
  WallView view;
  QRectF box;  // mm on the page, of the drawing itself
  double scale = 0;
};

void paintView(QPainter& p, const QRectF& area, const Placed& placed, LengthUnit unit) {
  const double dots = p.device()->logicalDpiX() / 25.4;
  const QRectF target(area.topLeft() + placed.box.topLeft() * dots, placed.box.size() * dots);
  QFont font = QApplication::font();
  font.setPixelSize(QFontInfo(font).pixelSize());
  drawPlan(p, target, placed.view.box, *placed.view.scene, font);
  inTenths(p, area);
  const WallView& v = placed.view;
  const double perMetre = 10'000 * placed.scale;
  const QPointF corner(placed.box.left() * 10 + (v.left - v.box.min.x) * perMetre,
                       placed.box.bottom() * 10 - (v.floor - v.box.min.y) * perMetre);
  const double bottom = corner.y() + 55;
  dimension(p, {corner.x(), bottom}, {corner.x() + v.length * perMetre, bottom},
            lengthText(v.length, unit, -1));
  dimension(p, {corner.x() - 45, corner.y()}, {corner.x() - 45, corner.y() - v.height * perMetre},
            lengthText(v.height, unit, -1));
  p.setFont(paperFont(32, true));
  p.drawText(QRectF(placed.box.left() * 10, bottom + 8, std::max(placed.box.width() * 10, 800.0), 50),
             Qt::AlignLeft | Qt::AlignVCenter, v.name + QStringLiteral("   ") + scaleText(placed.scale));
  p.restore();
}

// Row by row, as words are set; a view too wide for the page is drawn smaller.
std::vector<std::vector<Placed>> setInRows(const std::vector<WallView>& views, double scale, QSizeF room) {
  const QSizeF free = room - QSizeF(2 * kAround, kAround + kName + 8);
  std::vector<std::vector<Placed>> sheets(1);
  double x = 0, y = 0, rowHeight = 0;
  for (const WallView& v : views) {
    Placed placed;
    const Vec2 metres = v.box.max - v.box.min;
    placed.scale = std::min(scale, fittingScale(metres, free));
    const QSizeF size = QSizeF(metres.x, metres.y) * 1000 * placed.scale;
    const QSizeF whole = size + QSizeF(2 * kAround, kAround + kName + 8);
    if (x > 0 && x + whole.width() > room.width() + 0.01) x = 0, y += rowHeight, rowHeight = 0;
    if (y > 0 && y + whole.height() > room.height() + 0.01) {
      sheets.emplace_back();
      x = y = rowHeight = 0;
    }
    placed.box = QRectF(QPointF(x + kAround, y + 6), size);
    x += whole.width();
    rowHeight = std::max(rowHeight, whole.height());
    placed.view = v;
    sheets.back().push_back(std::move(placed));
  }
  return sheets;
}

}  // namespace

std::vector<PrintPage> wallSheets(const SheetContext& context) {
  const Home& home = context.source.home;
  std::vector<PrintPage> pages;
  for (const auto& [id, room] : home.rooms) {
    if (context.job.room ? id != *context.job.room : room->level != context.source.level) continue;
    const QString name = room->name.empty() ? printed(QT_TRANSLATE_NOOP("idap", "Room")) : toQt(room->name);
    std::vector<WallView> views;
    for (std::size_t edge = 0; edge < room->points.size(); ++edge) {
      auto view = wallView(context, *room, edge);
      if (!view) continue;
      view->name = printed(QT_TRANSLATE_NOOP("idap", "%1: wall %2"))
                       .arg(name, QString(QChar(u'A' + ushort(views.size() % 26))));
      views.push_back(std::move(*view));
    }
    if (views.empty()) continue;
    const double wanted = context.job.scale;
    std::vector<std::vector<Placed>> sheets;
    if (wanted > 0) {
      sheets = setInRows(views, wanted, context.room);
    } else {
      // As large as lets all walls of the room stand on one page.
      for (const double scale : {1.0 / 20, 1.0 / 25, 1.0 / 50}) {
        sheets = setInRows(views, scale, context.room);
        if (sheets.size() == 1) break;
      }
    }
    for (auto& sheet : sheets) {
      PrintPage page;
      page.title = printed(QT_TRANSLATE_NOOP("idap", "%1: walls")).arg(name);
      page.scale = sheet.front().scale;
      for (const Placed& placed : sheet)
        if (placed.scale != page.scale) page.scale = 0;  // each says its own
      const auto kept = std::make_shared<const std::vector<Placed>>(std::move(sheet));
      page.paint = [kept, unit = context.source.settings.unit](QPainter& p, const QRectF& area) {
        for (const Placed& placed : *kept) paintView(p, area, placed, unit);
      };
      pages.push_back(std::move(page));
    }
  }
  return pages;
}

}  // namespace idap
