// The pointer in the live view: looking, circling, selecting, and moving things over floors and up walls by
// the tools of the plans.
#include <QApplication>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/held_move_tool.h"
#include "studio/view3d/view3d_impl.h"

namespace idap {

namespace {

constexpr double kTurnPerPixel = 0.005;  // rad
constexpr double kWheelStep = 0.35;      // m a notch, walking
constexpr double kWheelFactor = 0.85;    // of the distance a notch, circling
constexpr double kHung = 0.3;            // m above the floor from which what is at a wall hangs there
constexpr double kFarthest = 60;         // m: things are not dragged over the horizon

Modifiers modifiersOf(Qt::KeyboardModifiers m) {
  return {.shift = m.testFlag(Qt::ShiftModifier),
          .control = m.testFlag(Qt::ControlModifier),
          .alt = m.testFlag(Qt::AltModifier)};
}

// Stands or hangs with its back to a wall, above the floor.
bool hangsOnWall(const Editor& editor, const Piece& piece, const Elements& itself) {
  if (piece.position.z < kHung) return false;
  PieceSnapRequest request;
  request.piece = piece;
  request.tolerance = 0.02;
  request.mayStack = false;
  request.ignored = itself;
  return snapPiece(editor, request, false).onWall;
}

}  // namespace

std::optional<std::size_t> View3d::Impl::featureAt(QPointF at) const {
  if (!seen || !view->rect().contains(at.toPoint())) return std::nullopt;
  const render::Features& f = seen->features;
  const int x = std::clamp(int(at.x() * f.width / std::max(1, view->width())), 0, f.width - 1);
  const int y = std::clamp(int(at.y() * f.height / std::max(1, view->height())), 0, f.height - 1);
  return f.index(x, y);
}

Vec3 View3d::Impl::pivot() const {
  if (const auto middle = view->pointAt(view->rect().center())) return *middle;
  if (const auto ground = meet(ray(view->rect().center()), {}, {0, 0, 1});
      ground && length(*ground - camera.eye) < 100)
    return *ground;
  return camera.eye + viewDirection(camera) * 5.0;
}

void View3d::Impl::turn(QPointF by) {
  // Pulling the picture: what is under the pointer goes along with it.
  if (manner == Manner::Walk)
    look(turned(camera, by.x() * kTurnPerPixel, -by.y() * kTurnPerPixel));
  else
    look(orbited(camera, about, -by.x() * kTurnPerPixel, by.y() * kTurnPerPixel));
}

void View3d::Impl::pointer(PointerEvent::Kind kind, QPointF at, PointerEvent::Button which,
                           Qt::KeyboardModifiers modifiers) {
  const ViewRay through = ray(at);
  std::optional<Vec3> point = meet(through, onPlane, planeNormal);
  if (action == Action::Drop) {
    // What is dropped lies where the pointer points at.
    if (const auto i = featureAt(at); i && seen->features.distance[*i] > 0)
      point = through.at(double(seen->features.distance[*i]));
  }
  if (!point || length(*point - camera.eye) > kFarthest) {
    if (kind != PointerEvent::Kind::Release) return;
    point = Vec3{};
    PointerEvent last = editor.lastPointer();
    last.kind = kind;
    last.button = which;
    editor.pointer(last);
    return;
  }
  PointerEvent event;
  event.kind = kind;
  event.plane = plane;
  event.at = project(plane, *point);
  if (freezeX) event.at.x = frozen.x;
  event.pixel =
      length(*point - camera.eye) * 2 * std::tan(camera.fieldOfView / 2) / std::max(1, view->width());
  event.button = which;
  event.modifiers = modifiersOf(modifiers);
  if (freezeX) event.modifiers.shift = false;
  editor.pointer(event);
}

void View3d::Impl::beginMove(QPointF at, Qt::KeyboardModifiers modifiers) {
  const auto id = view->at(at.toPoint());
  const auto grabbed = view->pointAt(at.toPoint());
  if (!id || !grabbed) return;
  const Elements held_ = editor.selection();
  plane = Plane::XY;
  onPlane = *grabbed;
  planeNormal = {0, 0, 1};
  freezeX = false;
  const Piece* piece = pieceOf(editor.home(), *id);
  const bool opening = std::holds_alternative<OpeningId>(*id);
  const Vec3 toEye = camera.eye - *grabbed;
  const auto upright = [&](Vec2 normal) {
    planeNormal = {normal.x, normal.y, 0};
    plane = std::abs(normal.y) >= std::abs(normal.x) ? Plane::XZ : Plane::YZ;
  };
  if (piece && ((opening && piece->position.z > 0.05) || (!opening && hangsOnWall(editor, *piece, held_)))) {
    upright(rotated(Vec2{0, -1}, piece->angle));
  } else if (piece && !opening && modifiers.testFlag(Qt::ShiftModifier)) {
    upright(normalized(Vec2{toEye.x, toEye.y}));
    freezeX = true;
    frozen = project(plane, *grabbed);
  } else if (opening) {
    // Along its wall, whatever height it was grabbed at.
    planeNormal = {0, 0, 1};
  }
  editor.setTool(makeHeldMoveTool(held_, *id));
  action = Action::Move;
  pointer(PointerEvent::Kind::Press, at, PointerEvent::Button::Left, modifiers & ~Qt::ShiftModifier);
}

void View3d::mousePressEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  setFocus(Qt::MouseFocusReason);
  if (d.action != Impl::Action::None) return;
  d.pressedAt = d.lastAt = event->position();
  d.button = event->button();
  d.about = d.pivot();
  if (const auto under = pointAt(event->position().toPoint()); under && d.manner == Manner::Orbit)
    d.about = *under;
  d.action = event->button() == Qt::MiddleButton ? Impl::Action::Pan : Impl::Action::Undecided;
}

void View3d::mouseMoveEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  const QPointF at = event->position();
  if (d.action == Impl::Action::Undecided) {
    if ((at - d.pressedAt).manhattanLength() < QApplication::startDragDistance()) return;
    const auto id = d.button == Qt::LeftButton ? this->at(d.pressedAt.toPoint()) : std::nullopt;
    const bool movable =
        id && (std::holds_alternative<FurnitureId>(*id) || std::holds_alternative<OpeningId>(*id) ||
               std::holds_alternative<GroupId>(*id));
    d.action = Impl::Action::Look;
    if (movable && contains(d.editor.selection(), *id)) d.beginMove(d.pressedAt, event->modifiers());
    if (d.action == Impl::Action::Look) setCursor(Qt::ClosedHandCursor);
  }
  const QPointF by = at - d.lastAt;
  d.lastAt = at;
  if (d.action == Impl::Action::Look) {
    d.turn(by);
  } else if (d.action == Impl::Action::Pan) {
    const double metre =
        length(d.about - d.camera.eye) * 2 * std::tan(d.camera.fieldOfView / 2) / std::max(1, width());
    d.look(shifted(d.camera, -by.x() * metre, by.y() * metre));
  } else if (d.action == Impl::Action::Move) {
    d.pointer(PointerEvent::Kind::Move, at, PointerEvent::Button::Left, event->modifiers());
  }
}

void View3d::mouseReleaseEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (event->button() != d.button) return;
  const Impl::Action was = std::exchange(d.action, Impl::Action::None);
  unsetCursor();
  if (was == Impl::Action::Move) {
    d.action = was;
    d.pointer(PointerEvent::Kind::Release, event->position(), PointerEvent::Button::Left, event->modifiers());
    d.action = Impl::Action::None;
    return;
  }
  if (was != Impl::Action::Undecided) return;
  const auto id = at(event->position().toPoint());
  const bool more = event->modifiers().testFlag(Qt::ShiftModifier);
  Elements chosen = more ? d.editor.selection() : Elements{};
  if (d.button == Qt::RightButton && id && contains(d.editor.selection(), *id))
    chosen = d.editor.selection();
  else if (id && more && contains(chosen, *id))
    remove(chosen, *id);
  else if (id)
    add(chosen, *id);
  d.editor.select(chosen);
  if (d.button == Qt::RightButton) emit contextMenuRequested(event->globalPosition().toPoint());
}

// Walks there.
void View3d::mouseDoubleClickEvent(QMouseEvent* event) {
  Impl& d = *impl_;
  if (event->button() != Qt::LeftButton) return;
  const auto id = at(event->position().toPoint());
  const auto point = pointAt(event->position().toPoint());
  if (!id || !point || !std::holds_alternative<RoomId>(*id)) {
    emit maximiseRequested();
    return;
  }
  Camera next = d.camera;
  const double height = d.manner == Manner::Walk ? d.camera.eye.z - point->z : 0;
  next.eye = {point->x, point->y, point->z + (height > 0.8 && height < 2.4 ? height : 1.6)};
  if (d.manner == Manner::Orbit) next.pitch = 0;
  setCamera(next);
}

void View3d::wheelEvent(QWheelEvent* event) {
  Impl& d = *impl_;
  const double notches = event->angleDelta().y() / 120.0;
  if (d.manner == Manner::Walk) {
    Camera next = walked(d.camera, 0, notches * kWheelStep, 0);
    if (d.stops) next.eye = keptOutOfWalls(d.editor.home(), d.camera.eye, next.eye);
    d.look(next);
  } else {
    const auto under = pointAt(event->position().toPoint());
    d.look(approached(d.camera, under ? *under : d.pivot(), std::pow(kWheelFactor, notches)));
  }
  event->accept();
}

}  // namespace idap
