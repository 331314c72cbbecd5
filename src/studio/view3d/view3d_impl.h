// The parts of the live view, shared by the files that make it. Not for others.
#pragma once

#include <QElapsedTimer>
#include <QSet>
#include <QTimer>

#include "editor/finish_drag.h"
#include "editor/view/camera_motion.h"
#include "scene/live/live_render.h"
#include "studio/view3d/live_link.h"
#include "studio/view3d/view3d.h"

namespace idap {

struct View3d::Impl {
  Impl(View3d* v, Editor& e) : view(v), editor(e) {}

  // view3d.cpp
  void submit();
  void show(const LiveFrame& frame);
  void outlineSelection();
  QSize pixels() const;
  double aspect() const { return double(std::max(1, view->width())) / std::max(1, view->height()); }
  void look(const Camera& to);  // and tell

  // view3d_pointer.cpp
  ViewRay ray(QPointF at) const {
    return rayThrough(camera, aspect(),
                      {at.x() / std::max(1, view->width()), at.y() / std::max(1, view->height())});
  }
  std::optional<std::size_t> featureAt(QPointF at) const;
  void turn(QPointF by);
  void beginMove(QPointF at, Qt::KeyboardModifiers modifiers);
  void pointer(PointerEvent::Kind kind, QPointF at, PointerEvent::Button button,
               Qt::KeyboardModifiers modifiers);
  Vec3 pivot() const;  // what orbiting circles around

  // view3d_drop.cpp
  void paintAt(QPointF at, Qt::KeyboardModifiers modifiers);

  // view3d_keys.cpp
  static bool isWalkingKey(int key);
  void step();

  View3d* view;
  Editor& editor;
  int subscription = 0;
  LiveLink link;
  Camera camera;
  Manner manner = Manner::Orbit;
  CutAway cut = CutAway::ByView;
  bool stops = false;
  double compensation = 0;
  int samples = 256;
  bool placed = false;  // the camera was set for this home

  QImage picture, outline;
  std::shared_ptr<const LiveView> seen;
  std::uint64_t asked = 0, shown = 0;
  int shownSamples = 0;
  bool shownFinished = false;

  // The pointer: what a press has begun.
  enum class Action { None, Undecided, Look, Pan, Move, Drop, Paint };
  Action action = Action::None;
  Qt::MouseButton button = Qt::NoButton;
  QPointF pressedAt, lastAt;
  Vec3 about;               // of an orbit
  Plane plane = Plane::XY;  // of a move
  Vec3 onPlane, planeNormal{0, 0, 1};
  bool freezeX = false;  // a move that only goes up and down
  Vec2 frozen;

  std::optional<FinishDrag> finish;  // dragged over the view

  QSet<int> held;
  QTimer walking;
  QElapsedTimer sinceStep;
  bool hurry = false;
};

}  // namespace idap
