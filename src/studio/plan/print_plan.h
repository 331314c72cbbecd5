// A plane of the home on paper, at an exact scale: 1 m at 1:50 is 20 mm. Vectors; one page.
#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>

#include "editor/editor.h"

class QPrinter;
class QPagedPaintDevice;

namespace idap {

struct PrintSettings {
  Plane plane = Plane::XY;
  double scale = 0;        // paper to home, 1/50; 0: as large as a round scale fits on the page
  bool titleBlock = true;  // title, notes, scale bar, north and date along the lower edge
};

// Paints on the page that the printer stands at; the caller goes on to another page between two calls.
void printPlan(QPrinter& printer, const Editor& editor, const PrintSettings& settings);
// The same with a painter that is open already, on a page of this size in the painter's units: for previews
// of several pages, and for PDF writers.
void printPlan(QPainter& painter, const QRectF& page, const Editor& editor, const PrintSettings& settings);

// The round scale (1/20, 1/25, 1/50, 1/100, …) that fits a plane on a page of so many millimetres.
double fittingScale(const Editor& editor, Plane plane, QSizeF pageMillimetres, bool titleBlock);

}  // namespace idap
