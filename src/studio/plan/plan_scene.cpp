#include "studio/plan/plan_scene.h"

#include <algorithm>

#include "editor/hit_test_shapes.h"

namespace idap {

PlanScene::PlanScene(const Editor& editor, Plane plane)
    : editor_(editor),
      plane_(plane),
      symbols_(SymbolStore::shared()),
      pictures_(Pictures::shared()),
      pieces_(plane, editor.sharedCatalog(), symbols_) {
  rebuild();
}

Drawing PlanScene::drawing() const {
  return {editor_.home(), plane_, editor_.level(), editor_.settings(), pieces_, *pictures_, section_};
}

void PlanScene::cutBefore() { section_ = 1e9; }

void PlanScene::rebuild() {
  section_ = plane_ == Plane::XY ? 0 : sectionNearness(editor_.home(), editor_.level(), plane_);
  pieces_.rebuild(editor_.home(), editor_.level(), *pictures_);
}

DirtyBoxes PlanScene::update(const Home& before, const Home& after) {
  const HomeDiff changes = diff(before, after);
  DirtyBoxes dirty;
  if (changes.empty()) return dirty;
  if (!changes.levels.empty()) dirty.all = true;
  const double sectionBefore = section_;
  if (plane_ != Plane::XY && !changes.walls.empty())
    section_ = sectionNearness(after, editor_.level(), plane_);
  pieces_.update(changes, after, *pictures_);
  const Drawing was{before, plane_, editor_.level(), editor_.settings(), pieces_, *pictures_, sectionBefore};
  const Drawing is{after, plane_, editor_.level(), editor_.settings(), pieces_, *pictures_, section_};
  for (const Painter* painter : painters(plane_, false)) painter->changed(changes, was, is, dirty);
  return dirty;
}

DirtyBoxes PlanScene::takeSymbols() {
  DirtyBoxes dirty;
  pieces_.takeSymbols(editor_.home(), *pictures_, dirty);
  return dirty;
}

void PlanScene::takeColors() { pieces_.takeColors(editor_.home(), *pictures_); }

void PlanScene::completeSymbols() { pieces_.completeSymbols(editor_.home(), *pictures_); }

Box2 PlanScene::bounds() const {
  Box2 box;
  const Drawing all = drawing();
  for (const Painter* painter : painters(plane_, false)) painter->extend(all, box);
  return box;
}

void PlanScene::paint(QPainter& painter, const ViewMap& view, const PlanColors& colors, const Box2& area,
                      const QFont& font, bool onPaper) const {
  painter.setRenderHint(QPainter::Antialiasing);
  Canvas canvas(painter, view, colors, area, font, onPaper);
  const Drawing all = drawing();
  for (const Painter* each : painters(plane_, onPaper)) each->paint(all, canvas);
}

void drawPlan(QPainter& painter, const QRectF& target, const Box2& area, const PlanScene& scene,
              const QFont& font) {
  if (area.empty() || target.isEmpty()) return;
  // The painters count in 1/96 inch, whatever the paper's resolution is.
  const double dots = painter.device() ? painter.device()->logicalDpiX() / 96.0 : 1;
  const QSizeF size = target.size() / dots;
  const Vec2 extent = area.max - area.min;
  ViewMap view;
  view.scale = std::min(size.width() / std::max(extent.x, 1e-9), size.height() / std::max(extent.y, 1e-9));
  const Vec2 middle = (area.min + area.max) * 0.5;
  view.origin = QPointF(size.width() / 2 - middle.x * view.scale, size.height() / 2 + middle.y * view.scale);
  painter.save();
  painter.translate(target.topLeft());
  painter.scale(dots, dots);
  painter.setClipRect(QRectF(QPointF(0, 0), size), Qt::IntersectClip);
  scene.paint(painter, view, PlanColors::forPrint(), area, font, true);
  painter.restore();
}

}  // namespace idap
