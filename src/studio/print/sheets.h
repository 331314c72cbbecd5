// The kinds of sheets, one file each. For layOut() only.
#pragma once

#include "studio/print/print_job.h"

namespace idap {

inline constexpr double kTitleBlock = 22;  // mm, its height

// What the sheets of one job share.
struct SheetContext {
  const PrintSource& source;
  const PrintJob& job;
  QSizeF room;  // mm that a drawing has on a page

  // An editor of its own on a home, for the painters of the plans.
  std::shared_ptr<Editor> editorOf(const Home& home, LevelId level) const;
};

std::vector<PrintPage> planSheets(const SheetContext& context, Plane plane);
std::vector<PrintPage> wallSheets(const SheetContext& context);
std::vector<PrintPage> listSheets(const SheetContext& context);
std::vector<PrintPage> pictureSheets(const SheetContext& context);

// Texts of this folder, translated now.
QString printed(const char* english);

// A font of so many tenths of a millimetre for a painter that counts in those.
QFont paperFont(int tenths, bool bold = false);

// Has the painter count in tenths of a millimetre from a corner of the area; restore() ends it.
QRectF inTenths(QPainter& painter, const QRectF& area);

// Along the lower edge of a page; area in tenths of a millimetre. north: radians, where there is one to show.
void paintTitleBlock(QPainter& painter, const QRectF& area, const PrintSource& source, const QString& what,
                     double scale, std::optional<double> north, int page, int pages);

}  // namespace idap
