// The inside of a PlanView, for the files that implement it: plan_view.cpp, plan_navigation.cpp,
// plan_drop.cpp.
#pragma once

#include <QElapsedTimer>
#include <QFontInfo>
#include <QTimer>
#include <optional>
#include <vector>

#include "editor/finish_drag.h"
#include "studio/plan/plan_caption.h"
#include "studio/plan/plan_layer.h"
#include "studio/plan/plan_scene.h"
#include "studio/plan/plan_view.h"
#include "studio/plan/rulers.h"

namespace idap {

inline constexpr double kNear = 5;  // pixels: what the pointer is taken to be on

struct PlanView::Impl {
  PlanView& self;
  Editor& editor;
  PlanScene scene;
  PlanLayer layer;
  PlanColors colors;
  ViewMap view;
  PlanCaption* caption;
  int subscription = 0;
  bool fitted = true;  // the view still shows all: it goes on doing so when its size changes
  std::optional<AnyId> hovered;
  std::optional<QPointF> pointer;
  bool panning = false, spaceHeld = false, menuPressed = false, dragging = false;
  std::optional<FinishDrag> finish;  // dragged over the view
  QPointF panFrom, panOrigin;
  int usedKey = 0;       // was taken as a shortcut's override already
  QElapsedTimer zoomed;  // since the wheel turned; invalid when what it left is painted
  QTimer rest;           // goes on painting
  QTimer follow;         // pans while a drag is held outside

  Impl(PlanView& view_, Editor& editor_, Plane plane)
      : self(view_),
        editor(editor_),
        scene(editor_, plane),
        colors(view_.palette()),
        caption(new PlanCaption(plane, &view_)) {}

  QFont font() const {
    QFont f = self.font();
    f.setPixelSize(QFontInfo(f).pixelSize());
    return f;
  }
  int ruler() const { return editor.settings().rulersShown ? rulerThickness(self.font()) : 0; }
  QRectF inner() const { return QRectF(self.rect()).adjusted(ruler(), ruler(), 0, 0); }

  void placeCaption() { caption->move(ruler() + 6, ruler() + 6); }
  Cursor shownCursor = Cursor::Arrow;
  bool handShown = true;

  // Panning and zooming: plan_navigation.cpp.
  void setView(ViewMap next);
  void zoomAbout(QPointF still, double factor);
  void panBy(QPointF pixels);
  void show(Box2 box, double margin);
  Box2 drawn() const;
  void startPan(QPointF at);
  void panTo(QPointF at);
  void followPointer();  // a step of a view whose drag is held outside

  void take(const DirtyBoxes& dirty);
  void changed(Editor::Change change);
  void nameLevel();
  void showCursor();
  void point(PointerEvent::Kind kind, QPointF at, PointerEvent::Button button,
             Qt::KeyboardModifiers modifiers);
  std::vector<AnyId> hits(QPointF at) const;
  void hover(QPointF at);
  void paintAt(QPointF at);
  void paint(QPainter& p, const QRect& area);
};

}  // namespace idap
