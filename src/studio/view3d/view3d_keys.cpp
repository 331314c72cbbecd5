// Walking with the keys: smooth while they are held.
#include <QKeyEvent>
#include <algorithm>

#include "studio/view3d/view3d_impl.h"

namespace idap {

namespace {

constexpr double kWalk = 1.4;     // m/s
constexpr double kHurry = 3;      // times as fast with Shift
constexpr double kTurn = 1.3;     // rad/s
constexpr double kLongest = 0.1;  // s that one step may stand for

}  // namespace

bool View3d::Impl::isWalkingKey(int key) {
  switch (key) {
    case Qt::Key_W:
    case Qt::Key_A:
    case Qt::Key_S:
    case Qt::Key_D:
    case Qt::Key_Q:
    case Qt::Key_E:
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
      return true;
    default:
      return false;
  }
}

void View3d::Impl::step() {
  if (held.isEmpty()) return walking.stop();
  const double seconds = std::min(kLongest, double(sinceStep.restart()) / 1000);
  const double far = kWalk * (hurry ? kHurry : 1) * seconds;
  const auto on = [this](int a, int b = 0) {
    return (held.contains(a) ? 1 : 0) + (b && held.contains(b) ? 1 : 0);
  };
  const double ahead = on(Qt::Key_W, Qt::Key_Up) - on(Qt::Key_S, Qt::Key_Down);
  const double right = on(Qt::Key_D) - on(Qt::Key_A);
  const double up = on(Qt::Key_E, Qt::Key_PageUp) - on(Qt::Key_Q, Qt::Key_PageDown);
  const double left = on(Qt::Key_Left) - on(Qt::Key_Right);
  Camera next = walked(turned(camera, left * kTurn * seconds, 0), right * far, ahead * far, up * far * 0.5);
  if (stops && manner == Manner::Walk) next.eye = keptOutOfWalls(editor.home(), camera.eye, next.eye);
  look(next);
}

bool View3d::event(QEvent* event) {
  // Letters that are tools elsewhere walk here.
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    const auto others = key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier);
    if ((Impl::isWalkingKey(key->key()) && others == Qt::NoModifier) ||
        (key->key() == Qt::Key_Escape && impl_->action != Impl::Action::None)) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void View3d::keyPressEvent(QKeyEvent* event) {
  Impl& d = *impl_;
  if (event->key() == Qt::Key_Escape && (d.action == Impl::Action::Move || d.action == Impl::Action::Drop)) {
    d.action = Impl::Action::None;
    d.editor.setTool(nullptr);
    return;
  }
  if (!Impl::isWalkingKey(event->key()) ||
      (event->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) != Qt::NoModifier)
    return QWidget::keyPressEvent(event);
  d.hurry = event->modifiers() & Qt::ShiftModifier;
  if (event->isAutoRepeat()) return;
  d.held.insert(event->key());
  if (d.walking.isActive()) return;
  d.sinceStep.start();
  d.walking.start();
}

void View3d::keyReleaseEvent(QKeyEvent* event) {
  if (event->isAutoRepeat()) return;
  if (impl_->held.contains(event->key())) impl_->step();
  impl_->held.remove(event->key());
}

void View3d::focusOutEvent(QFocusEvent* event) {
  impl_->held.clear();
  QWidget::focusOutEvent(event);
}

}  // namespace idap
