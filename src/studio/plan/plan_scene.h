// What one plane of an editor shows, without the widget: for the view, and for paper.
#pragma once

#include <QFont>
#include <QPainter>
#include <memory>

#include "editor/editor.h"
#include "studio/plan/painter.h"
#include "studio/plan/pictures.h"
#include "studio/plan/piece_items.h"
#include "studio/plan/plan_colors.h"
#include "studio/plan/symbol_store.h"

namespace idap {

class PlanScene {
 public:
  PlanScene(const Editor& editor, Plane plane);

  Plane plane() const { return plane_; }
  SymbolStore& symbols() { return *symbols_; }
  Pictures& pictures() { return *pictures_; }
  const PieceItems& pieces() const { return pieces_; }
  PieceItems& pieces() { return pieces_; }
  Drawing drawing() const;

  // Cuts the building before all there is, so that nothing is shown as cut: of elevations.
  void cutBefore();
  void rebuild();  // another document or level
  // The home changed: what has to be painted anew.
  DirtyBoxes update(const Home& before, const Home& after);
  DirtyBoxes takeSymbols();
  void takeColors();
  void completeSymbols();

  Box2 bounds() const;  // of all that is drawn; empty for an empty home

  // An area of the plane with a painter whose unit is a logical pixel.
  void paint(QPainter& painter, const ViewMap& view, const PlanColors& colors, const Box2& area,
             const QFont& font, bool onPaper) const;

 private:
  const Editor& editor_;
  Plane plane_;
  std::shared_ptr<SymbolStore> symbols_;
  std::shared_ptr<Pictures> pictures_;
  mutable PieceItems pieces_;
  double section_ = 0;
};

// An area of the plane into a rectangle of any painter, at exactly the scale that this makes: for paper.
void drawPlan(QPainter& painter, const QRectF& target, const Box2& area, const PlanScene& scene,
              const QFont& font);

}  // namespace idap
