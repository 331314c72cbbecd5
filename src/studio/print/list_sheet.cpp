// The furniture list with pictures, prices and totals. What is alike is one row with its number.
#include <QFontInfo>
#include <QFontMetricsF>
#include <QLocale>
#include <map>
#include <tuple>

#include "catalog/catalog.h"
#include "studio/plan/plan_scene.h"
#include "studio/print/sheets.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kRow = 140;  // tenths of a millimetre
constexpr double kHead = 70;
constexpr double kPicture = 180;

struct Row {
  QString name, size;
  int count = 0;
  std::optional<double> price;  // of one
  std::shared_ptr<Editor> editor;
  std::shared_ptr<PlanScene> scene;
  Box2 box;
};

struct Bill {
  std::vector<Row> rows;
  QString currency;
  int pieces = 0;
  double total = 0;
  bool priced = false;
};

// The piece by itself, seen from the front.
void portray(Row& row, const SheetContext& context, const Piece& piece) {
  Home home;
  home.assets = context.source.home.assets;
  Furniture alone;
  static_cast<Piece&>(alone) = piece;
  alone.level = {};
  alone.group = {};
  alone.position = {};
  alone.angle = 0;
  alone.visible = true;
  alone.nameVisible = false;
  home.furniture.set(home.newId<FurnitureId>(), alone);
  row.editor = context.editorOf(home, {});
  row.scene = std::make_shared<PlanScene>(*row.editor, Plane::XZ);
  row.box = grown(row.scene->bounds(), 0.02);
}

Bill billOf(const SheetContext& context) {
  const Home& home = context.source.home;
  Bill table;
  table.currency = toQt(home.currency);
  std::map<std::tuple<std::string, double, double, double, double>, std::size_t> known;
  const auto add = [&](const Piece& piece) {
    if (!isShown(home, piece)) return;
    const Vec3 s = piece.size;
    const auto [at, fresh] =
        known.try_emplace({piece.name, s.x, s.y, s.z, piece.price.value_or(-1)}, table.rows.size());
    if (fresh) {
      Row row;
      row.name = piece.name.empty() ? printed(QT_TRANSLATE_NOOP("idap", "Furniture")) : toQt(piece.name);
      const LengthUnit unit = context.source.settings.unit;
      row.size = QStringLiteral("%1 × %2 × %3")
                     .arg(lengthText(s.x, unit), lengthText(s.y, unit), lengthText(s.z, unit));
      row.price = piece.price;
      portray(row, context, piece);
      table.rows.push_back(std::move(row));
    }
    ++table.rows[at->second].count;
    ++table.pieces;
    if (piece.price) table.total += *piece.price, table.priced = true;
  };
  for (const auto& [id, piece] : home.furniture) add(*piece);
  for (const auto& [id, opening] : home.openings)
    if (opening->kind != OpeningKind::Bare) add(*opening);
  std::stable_sort(table.rows.begin(), table.rows.end(),
                   [](const Row& a, const Row& b) { return a.name.localeAwareCompare(b.name) < 0; });
  return table;
}

void paintRows(QPainter& p, const QRectF& area, const Bill& table, std::size_t from, std::size_t to,
               bool last) {
  const QRectF all = inTenths(p, area);
  const double price = table.priced ? 260 : 0, count = 190, size = std::min(620.0, all.width() * 0.36);
  const double nameLeft = kPicture + 20, right = all.width();
  const double sizeLeft = right - 2 * price - count - size, countLeft = right - 2 * price - count;
  const auto cell = [&](double x, double w, double y, double h, int alignment, const QString& words) {
    p.drawText(QRectF(x, y, w - 12, h), alignment | Qt::AlignVCenter,
               QFontMetricsF(p.font()).elidedText(words, Qt::ElideRight, w - 12));
  };
  const auto money = [&](double sum) { return QLocale().toString(sum, 'f', 2); };
  p.setPen(Qt::black);
  p.setFont(paperFont(30, true));
  cell(nameLeft, sizeLeft - nameLeft, 0, kHead, Qt::AlignLeft, printed(QT_TRANSLATE_NOOP("idap", "Name")));
  cell(sizeLeft, size, 0, kHead, Qt::AlignLeft, printed(QT_TRANSLATE_NOOP("idap", "Width × depth × height")));
  cell(countLeft, count, 0, kHead, Qt::AlignRight, printed(QT_TRANSLATE_NOOP("idap", "Number")));
  if (table.priced) {
    cell(right - 2 * price, price, 0, kHead, Qt::AlignRight,
         printed(QT_TRANSLATE_NOOP("idap", "Price")) + QLatin1Char(' ') + table.currency);
    cell(right - price, price, 0, kHead, Qt::AlignRight,
         printed(QT_TRANSLATE_NOOP("idap", "Sum")) + QLatin1Char(' ') + table.currency);
  }
  p.setPen(QPen(Qt::black, 3));
  p.drawLine(QPointF(0, kHead), QPointF(right, kHead));
  double y = kHead;
  const double dots = p.device()->logicalDpiX() / 254.0;
  QFont font = QApplication::font();
  font.setPixelSize(QFontInfo(font).pixelSize());
  for (std::size_t i = from; i < to; ++i, y += kRow) {
    const Row& row = table.rows[i];
    // The picture, in device units.
    const QRectF frame(4, y + 6, kPicture - 8, kRow - 12);
    const Vec2 metres = row.box.max - row.box.min;
    const QSizeF fitted =
        QSizeF(std::max(metres.x, 1e-3), std::max(metres.y, 1e-3)).scaled(frame.size(), Qt::KeepAspectRatio);
    const QRectF place(QPointF(frame.center().x() - fitted.width() / 2, frame.bottom() - fitted.height()),
                       fitted);
    p.restore();
    row.scene->completeSymbols();
    drawPlan(p, QRectF(area.topLeft() + place.topLeft() * dots, place.size() * dots), row.box, *row.scene,
             font);
    inTenths(p, area);
    p.setPen(Qt::black);
    p.setFont(paperFont(30));
    cell(nameLeft, sizeLeft - nameLeft, y, kRow, Qt::AlignLeft, row.name);
    cell(sizeLeft, size, y, kRow, Qt::AlignLeft, row.size);
    cell(countLeft, count, y, kRow, Qt::AlignRight, QString::number(row.count));
    if (row.price) {
      cell(right - 2 * price, price, y, kRow, Qt::AlignRight, money(*row.price));
      cell(right - price, price, y, kRow, Qt::AlignRight, money(*row.price * row.count));
    }
    p.setPen(QPen(QColor(190, 190, 190), 1));
    p.drawLine(QPointF(0, y + kRow), QPointF(right, y + kRow));
  }
  if (last) {
    p.setPen(Qt::black);
    p.setFont(paperFont(32, true));
    cell(nameLeft, sizeLeft - nameLeft, y, kHead, Qt::AlignLeft, printed(QT_TRANSLATE_NOOP("idap", "Total")));
    cell(countLeft, count, y, kHead, Qt::AlignRight, QString::number(table.pieces));
    if (table.priced)
      cell(right - 2 * price, 2 * price, y, kHead, Qt::AlignRight,
           money(table.total) + QLatin1Char(' ') + table.currency);
  }
  p.restore();
}

}  // namespace

std::vector<PrintPage> listSheets(const SheetContext& context) {
  const auto table = std::make_shared<const Bill>(billOf(context));
  const std::size_t perPage =
      std::size_t(std::max(1.0, (context.room.height() * 10 - 2 * kHead - 10) / kRow));
  std::vector<PrintPage> pages;
  std::size_t from = 0;
  do {
    const std::size_t to = std::min(table->rows.size(), from + perPage);
    PrintPage page;
    page.title = printed(sheetName(SheetKind::FurnitureList));
    const bool last = to == table->rows.size();
    page.paint = [table, from, to, last](QPainter& p, const QRectF& area) {
      paintRows(p, area, *table, from, to, last);
    };
    pages.push_back(std::move(page));
    from = to;
  } while (from < table->rows.size());
  return pages;
}

}  // namespace idap
