// How a plane is panned and zoomed: by the wheel, a touchpad, a held button, and to fit.
#include <QApplication>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "studio/plan/plan_view_impl.h"

namespace idap {

namespace {

constexpr double kLeastScale = 0.5, kMostScale = 20'000;  // pixels a metre
constexpr double kEmptyHome = 10;                         // m that a home without anything shows

}  // namespace

void PlanView::Impl::setView(ViewMap next) {
  // On whole device pixels, so that a pan can move the picture instead of painting it anew.
  const double ratio = self.devicePixelRatioF();
  next.origin = QPointF(std::round(next.origin.x() * ratio), std::round(next.origin.y() * ratio)) / ratio;
  if (next == view) return;
  view = next;
  self.update();
}

void PlanView::Impl::zoomAbout(QPointF still, double factor) {
  ViewMap next = view;
  next.scale = std::clamp(view.scale * factor, kLeastScale, kMostScale);
  const double real = next.scale / view.scale;
  next.origin = still + (view.origin - still) * real;
  fitted = false;
  zoomed.start();
  setView(next);
}

void PlanView::Impl::panBy(QPointF pixels) {
  ViewMap next = view;
  next.origin += pixels;
  fitted = false;
  setView(next);
}

void PlanView::Impl::show(Box2 box, double margin) {
  if (box.empty()) return;
  const QRectF room = inner().adjusted(0, caption->height(), 0, 0);
  const Vec2 size = box.max - box.min;
  ViewMap next;
  const double fit = std::min((room.width() - 2 * margin) / std::max(size.x, 0.1),
                              (room.height() - 2 * margin) / std::max(size.y, 0.1));
  next.scale = std::clamp(fit, kLeastScale, 2000.0);
  const Vec2 middle = (box.min + box.max) * 0.5;
  next.origin = room.center() - QPointF(middle.x, -middle.y) * next.scale;
  setView(next);
}

Box2 PlanView::Impl::drawn() const {
  const Box2 box = scene.bounds();
  if (!box.empty()) return box;
  const double half = kEmptyHome / 2;
  return scene.plane() == Plane::XY ? Box2{{-half, -half}, {half, half}} : Box2{{-half, -0.5}, {half, 3.5}};
}

void PlanView::Impl::startPan(QPointF at) {
  panning = true;
  panFrom = at;
  panOrigin = view.origin;
  showCursor();
}

void PlanView::Impl::panTo(QPointF at) {
  ViewMap next = view;
  next.origin = panOrigin + at - panFrom;
  fitted = false;
  setView(next);
}

void PlanView::Impl::followPointer() {
  if (!pointer || !(QApplication::mouseButtons() & Qt::LeftButton)) {
    follow.stop();
    return;
  }
  const QRectF room = inner();
  const QPointF at = *pointer;
  const QPointF out(at.x() - std::clamp(at.x(), room.left(), room.right()),
                    at.y() - std::clamp(at.y(), room.top(), room.bottom()));
  panBy(-QPointF(std::clamp(out.x(), -40.0, 40.0), std::clamp(out.y(), -40.0, 40.0)) * 0.5);
  point(PointerEvent::Kind::Move, at, PointerEvent::Button::Left, QApplication::keyboardModifiers());
}

void PlanView::zoomToFit() {
  impl_->show(drawnBox(), 2 * fontMetrics().height());
  impl_->fitted = true;
}

void PlanView::zoomToSelection() {
  const Box3 box = bounds(impl_->editor.home(), impl_->editor.selection());
  if (box.empty()) {
    zoomToFit();
    return;
  }
  const Vec2 a = project(plane(), box.min), b = project(plane(), box.max);
  impl_->show(grown({a, b}, 0.3), 2 * fontMetrics().height());
  impl_->fitted = false;
}

void PlanView::zoomBy(double factor) { impl_->zoomAbout(impl_->inner().center(), factor); }

void PlanView::centreOn(Vec2 at) { impl_->panBy(impl_->inner().center() - impl_->view.toView(at)); }

void PlanView::wheelEvent(QWheelEvent* event) {
  const bool zooms = event->modifiers().testFlag(Qt::ControlModifier);
  const bool fingers = event->phase() != Qt::NoScrollPhase && !event->pixelDelta().isNull();
  QPointF way =
      event->pixelDelta().isNull() ? QPointF(event->angleDelta()) / 2 : QPointF(event->pixelDelta());
  if (!zooms && fingers) {  // two fingers on a touchpad push the paper
    impl_->panBy(way);
  } else if (event->modifiers().testFlag(Qt::ShiftModifier) || (!zooms && way.y() == 0)) {
    impl_->panBy(QPointF(way.x() != 0 ? way.x() : way.y(), 0));
  } else {
    // One notch of a wheel is 15 degrees, counted in eighths.
    const double notches = fingers ? way.y() / 60 : event->angleDelta().y() / 120.0;
    impl_->zoomAbout(event->position(), std::pow(1.2, notches));
  }
  event->accept();
  impl_->pointer = event->position();
  const Vec2 on = impl_->view.toPlane(event->position());
  emit pointerAt(on.x, on.y);
}

void PlanView::resizeEvent(QResizeEvent* event) {
  impl_->placeCaption();
  if (impl_->fitted) {
    zoomToFit();
  } else if (event->oldSize().isValid()) {  // what was in the middle stays there
    ViewMap next = impl_->view;
    next.origin += QPointF(event->size().width() - event->oldSize().width(),
                           event->size().height() - event->oldSize().height()) /
                   2;
    impl_->setView(next);
  }
}

}  // namespace idap
