// Draws the symbol of a piece, or its box while there is none: with as much detail as the scale lets one see.
#pragma once

#include <vector>

#include "studio/plan/canvas.h"
#include "studio/plan/piece_items.h"

namespace idap {

class SymbolPainter {
 public:
  explicit SymbolPainter(Canvas& canvas);

  // faded: as what lies behind or below.
  void draw(const PieceItem& item, bool faded = false);
  // What hangs above the cut of a plan: a dashed outline that hides nothing.
  void drawOverhead(const PieceItem& item);

 private:
  void box(const PieceItem& item, bool faded);
  QColor tint(const PieceItem& item, std::size_t slot, bool sloped, bool faded) const;
  void place(const PieceItem& item);
  QPointF map(Vec2f point) const {
    return {ax_ * point.x + bx_ * point.y + cx_, ay_ * point.x + by_ * point.y + cy_};
  }

  Canvas& c_;
  // From the symbol's metres to pixels.
  double ax_ = 1, ay_ = 0, bx_ = 0, by_ = 1, cx_ = 0, cy_ = 0;
  std::vector<QPointF> points_;  // kept for its memory
};

}  // namespace idap
