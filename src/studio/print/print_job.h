// What is printed, as a value, and the pages that come of it. A metre at 1:50 measures 20 mm on every kind of
// paper: printer, PDF, SVG and preview paint the same pages.
#pragma once

#include <QPageLayout>
#include <QPainter>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "editor/editor.h"

namespace idap {

enum class SheetKind { Plan, Front, Side, WallElevations, FurnitureList, Pictures };

struct PrintJob {
  QPageLayout page{QPageSize(QPageSize::A4), QPageLayout::Landscape, QMarginsF(10, 10, 10, 10),
                   QPageLayout::Millimeter};
  double scale = 0;        // paper to home, 1/50; 0: as large as a round scale fits on the page
  bool titleBlock = true;  // title, notes, scale bar, north and date along the lower edge
  std::vector<SheetKind> sheets{SheetKind::Plan};
  bool allLevels = false;      // plans of every level instead of the current one
  std::optional<RoomId> room;  // whose walls are shown; none: of every room of the level
};

// What is printed of: a snapshot.
struct PrintSource {
  Home home;
  std::shared_ptr<const Catalog> catalog;
  EditorSettings settings;
  LevelId level;
};
PrintSource printSource(const Editor& editor);

struct PrintPage {
  QString title;         // "Plan", "Kitchen: wall B"
  double scale = 0;      // 0: nothing to measure
  bool northUp = false;  // a plan: its title block shows where north is
  // area: what margins leave, in the painter's units; its device tells how many those are to an inch.
  std::function<void(QPainter&, const QRectF& area)> paint;
};
std::vector<PrintPage> layOut(const PrintSource& source, const PrintJob& job);

// What a sheet kind is called, marked for translation.
const char* sheetName(SheetKind kind);

// The scales that plans are drawn at, from large to small.
std::vector<double> roundScales();
// The largest round scale at which so many metres fit on so many millimetres.
double fittingScale(Vec2 metres, QSizeF millimetres);
QString scaleText(double scale);  // "1:50"

}  // namespace idap
