// The painters, one object of each: see painters.cpp for their order.
#pragma once

#include "studio/plan/painter.h"

namespace idap {

const Painter& backgroundPainter();  // the scanned plan
const Painter& gridPainter();
const Painter& levelBelowPainter();
const Painter& roomPainter();
const Painter& roomTextPainter();
const Painter& wallPainter();
const Painter& openingPainter();
const Painter& furniturePainter();
const Painter& dimensionPainter();
const Painter& labelPainter();
const Painter& polylinePainter();
const Painter& cameraPainter();
const Painter& compassPainter();
const Painter& storeyPainter();     // XZ, YZ: floors and ceilings with their heights
const Painter& elevationPainter();  // XZ, YZ: walls and all that stands between them

}  // namespace idap
