#include "studio/print/print_job.h"

#include <algorithm>
#include <cmath>

#include "studio/print/sheets.h"

namespace idap {

namespace {

constexpr double kScales[] = {1.0,       0.5,       0.2,        0.1,        1.0 / 20,   1.0 / 25,
                              1.0 / 50,  1.0 / 75,  1.0 / 100,  1.0 / 125,  1.0 / 150,  1.0 / 200,
                              1.0 / 250, 1.0 / 500, 1.0 / 1000, 1.0 / 2000, 1.0 / 5000, 1.0 / 10000};

std::vector<PrintPage> sheetsOf(SheetKind kind, const SheetContext& context) {
  switch (kind) {
    case SheetKind::Plan:
      return planSheets(context, Plane::XY);
    case SheetKind::Front:
      return planSheets(context, Plane::XZ);
    case SheetKind::Side:
      return planSheets(context, Plane::YZ);
    case SheetKind::WallElevations:
      return wallSheets(context);
    case SheetKind::FurnitureList:
      return listSheets(context);
    case SheetKind::Pictures:
      return pictureSheets(context);
  }
  return {};
}

}  // namespace

const char* sheetName(SheetKind kind) {
  switch (kind) {
    case SheetKind::Plan:
      return QT_TRANSLATE_NOOP("idap", "Plan");
    case SheetKind::Front:
      return QT_TRANSLATE_NOOP("idap", "Front elevation");
    case SheetKind::Side:
      return QT_TRANSLATE_NOOP("idap", "Side elevation");
    case SheetKind::WallElevations:
      return QT_TRANSLATE_NOOP("idap", "Walls of rooms");
    case SheetKind::FurnitureList:
      return QT_TRANSLATE_NOOP("idap", "Furniture list");
    case SheetKind::Pictures:
      return QT_TRANSLATE_NOOP("idap", "Pictures");
  }
  return "";
}

std::vector<double> roundScales() { return {std::begin(kScales), std::end(kScales)}; }

double fittingScale(Vec2 metres, QSizeF room) {
  for (const double scale : kScales)
    if (metres.x * 1000 * scale <= room.width() && metres.y * 1000 * scale <= room.height()) return scale;
  return std::min(room.width() / (metres.x * 1000), room.height() / (metres.y * 1000));
}

QString scaleText(double scale) {
  return scale >= 1 ? QStringLiteral("%1:1").arg(scale)
                    : QStringLiteral("1:%1").arg(std::round(1000 / scale) / 1000);
}

PrintSource printSource(const Editor& editor) {
  return {editor.document().snapshot().home, editor.sharedCatalog(), editor.settings(), editor.level()};
}

std::shared_ptr<Editor> SheetContext::editorOf(const Home& home, LevelId level) const {
  auto editor = std::make_shared<Editor>(source.catalog);
  editor->setSettings(source.settings);
  editor->open(std::make_unique<Document>(home));
  if (level) editor->setLevel(level);
  return editor;
}

std::vector<PrintPage> layOut(const PrintSource& source, const PrintJob& job) {
  QSizeF room = job.page.paintRect(QPageLayout::Millimeter).size();
  if (job.titleBlock) room.rheight() -= kTitleBlock;
  const SheetContext context{source, job, room};
  std::vector<PrintPage> pages;
  for (const SheetKind kind : job.sheets)
    for (PrintPage& page : sheetsOf(kind, context)) pages.push_back(std::move(page));
  if (!job.titleBlock) return pages;
  const auto kept = std::make_shared<const PrintSource>(source);
  const int count = int(pages.size());
  for (int i = 0; i < count; ++i) {
    PrintPage& page = pages[std::size_t(i)];
    const bool plan = page.northUp;
    page.paint = [kept, inner = page.paint, title = page.title, scale = page.scale, plan, i, count](
                     QPainter& p, const QRectF& area) {
      inner(p, area);
      const QRectF tenths = inTenths(p, area);
      paintTitleBlock(p, tenths, *kept, title, scale,
                      plan ? std::optional(kept->home.site.north) : std::nullopt, i + 1, count);
      p.restore();
    };
  }
  return pages;
}

}  // namespace idap
