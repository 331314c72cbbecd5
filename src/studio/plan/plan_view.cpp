// What a plane paints, and how it hands on the pointer and the keys.
#include <QApplication>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QNativeGestureEvent>
#include <QPaintEvent>
#include <QToolTip>
#include <algorithm>

#include "editor/hit_test.h"
#include "studio/plan/paint_overlay.h"
#include "studio/plan/plan_input.h"
#include "studio/plan/plan_view_impl.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kFrame = 8;  // ms of a frame that painting anew may take
constexpr int kRest = 80;     // ms after the last turn of the wheel
constexpr int kFollow = 30;   // ms between two steps of a view that follows the pointer

}  // namespace

void PlanView::Impl::take(const DirtyBoxes& dirty) {
  if (dirty.all) layer.markAll();
  for (const Box2& box : dirty.boxes) layer.mark(view.toView(box));
  if (dirty.all || !dirty.boxes.empty()) self.update();
}

void PlanView::Impl::changed(Editor::Change change) {
  switch (change) {
    case Editor::Change::Document:
      scene.rebuild();
      layer.markAll();
      hovered.reset();
      self.zoomToFit();
      break;
    case Editor::Change::Level:
      scene.rebuild();
      layer.markAll();
      hovered.reset();
      nameLevel();
      if (scene.plane() != Plane::XY && fitted) self.zoomToFit();
      break;
    case Editor::Change::Settings:
      layer.markAll();
      placeCaption();
      if (fitted) self.zoomToFit();
      break;
    case Editor::Change::Home:
      nameLevel();
      break;
    case Editor::Change::Tool:
      hovered.reset();
      break;
    case Editor::Change::Selection:
    case Editor::Change::Overlay:
      break;
  }
  if (change == Editor::Change::Tool || change == Editor::Change::Overlay) showCursor();
  self.update();
}

void PlanView::Impl::nameLevel() {
  const Level* level = editor.home().levels.find(editor.level());
  caption->setLevelName(level ? toQt(level->name) : QString());
}

void PlanView::Impl::showCursor() {
  if (panning) {
    self.setCursor(Qt::ClosedHandCursor);
  } else if (spaceHeld) {
    self.setCursor(Qt::OpenHandCursor);
  } else {
    const Cursor cursor = editor.tool().cursor(editor, scene.plane());
    if (cursor == shownCursor && self.testAttribute(Qt::WA_SetCursor) && !handShown) return;
    shownCursor = cursor;
    handShown = false;
    self.setCursor(cursorOf(cursor, self));
    return;
  }
  handShown = true;
}

void PlanView::Impl::point(PointerEvent::Kind kind, QPointF at, PointerEvent::Button button,
                           Qt::KeyboardModifiers modifiers) {
  PointerEvent event;
  event.kind = kind;
  event.plane = scene.plane();
  event.at = view.toPlane(at);
  event.pixel = 1 / view.scale;
  event.button = button;
  event.modifiers = modifiersOf(modifiers);
  editor.pointer(event);
}

std::vector<AnyId> PlanView::Impl::hits(QPointF at) const {
  return hitsAt(editor, scene.plane(), view.toPlane(at), kNear / view.scale);
}

void PlanView::Impl::hover(QPointF at) {
  std::optional<AnyId> now;
  if (editor.selecting())
    if (const auto found = hits(at); !found.empty()) now = found.front();
  if (now == hovered) return;
  hovered = now;
  self.update();
}

void PlanView::Impl::paint(QPainter& p, const QRect& area) {
  layer.setSize(self.size(), self.devicePixelRatioF(), colors.paper);
  layer.setView(view);
  const QFont f = font();
  // While the wheel turns a picture that is costly to paint is only stretched; when it rests, strip by
  // strip takes the stretched one's place. All other causes have it painted at once.
  const bool zooming = zoomed.isValid() && zoomed.elapsed() < kRest;
  const bool costly = layer.wholeStale() && layer.wholeCost() > kFrame;
  if (zooming && costly) {
    rest.start(kRest);
  } else {
    layer.repair(
        [&](QPainter& painter, const QRectF& part) {
          // Lines end a little outside, where their smoothed ends are not seen.
          const double slack = 2 / view.scale;
          scene.paint(painter, view, colors, grown(view.toPlane(part), slack), f, false);
        },
        costly && zoomed.isValid() ? kFrame : 0);
    if (!layer.stale()) zoomed.invalidate();
    if (layer.stale()) rest.start(0);
  }

  layer.draw(p, area);
  p.setRenderHint(QPainter::Antialiasing);
  Canvas canvas(p, view, colors, view.toPlane(QRectF(self.rect())), f, false);
  const Drawing drawing = scene.drawing();
  const QRectF visible = inner();
  if (scene.plane() != Plane::XY) paintHeights(drawing, canvas, visible.adjusted(6, 0, 0, 0));
  const Overlay overlay = editor.tool().overlay(editor, scene.plane(), 1 / view.scale);
  const bool onHandle =
      std::any_of(overlay.handles.begin(), overlay.handles.end(), [](const Handle& h) { return h.active; });
  if (hovered && !onHandle && !contains(editor.selection(), *hovered) && !panning)
    paintHover(drawing, canvas, *hovered);
  paintSelection(drawing, canvas, editor.selection());
  paintCameraNames(drawing, canvas, editor.selection(), hovered);
  paintOverlay(canvas, overlay, editor.settings().unit, visible);
  if (editor.settings().rulersShown)
    paintRulers(p, self.rect(), view, colors, self.font(), editor.settings().unit, pointer);
  if (self.hasFocus()) {
    p.setRenderHint(QPainter::Antialiasing, false);
    p.setPen(QPen(colors.accent, 1));
    p.setBrush(Qt::NoBrush);
    p.drawRect(self.rect().adjusted(0, 0, -1, -1));
  }
}

PlanView::PlanView(Editor& editor, Plane plane, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(*this, editor, plane)) {
  setObjectName(plane == Plane::XY   ? QStringLiteral("planXY")
                : plane == Plane::XZ ? QStringLiteral("planXZ")
                                     : QStringLiteral("planYZ"));
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  setMinimumSize(120, 90);
  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) { impl_->changed(change); };
  listener.homeChanged = [this](const Home& before, const Home& after) {
    impl_->take(impl_->scene.update(before, after));
  };
  impl_->subscription = editor.subscribe(std::move(listener));
  connect(&impl_->scene.symbols(), &SymbolStore::ready, this,
          [this] { impl_->take(impl_->scene.takeSymbols()); });
  connect(&impl_->scene.pictures(), &Pictures::changed, this, [this] {
    impl_->scene.takeColors();
    impl_->layer.markAll();
    update();
  });
  connect(impl_->caption, &PlanCaption::maximiseRequested, this, &PlanView::maximiseRequested);
  impl_->rest.setSingleShot(true);
  connect(&impl_->rest, &QTimer::timeout, this, [this] { update(); });
  impl_->follow.setInterval(kFollow);
  connect(&impl_->follow, &QTimer::timeout, this, [this] { impl_->followPointer(); });
  impl_->nameLevel();
  impl_->placeCaption();
  impl_->showCursor();
}

PlanView::~PlanView() { impl_->editor.unsubscribe(impl_->subscription); }

Plane PlanView::plane() const { return impl_->scene.plane(); }
double PlanView::pixel() const { return 1 / impl_->view.scale; }
Vec2 PlanView::toPlane(QPointF view) const { return impl_->view.toPlane(view); }
QPointF PlanView::toView(Vec2 plane) const { return impl_->view.toView(plane); }

bool PlanView::settled() const { return !impl_->layer.stale() && impl_->scene.symbols().idle(); }

void PlanView::drawTo(QPainter& painter, const QRectF& target, const Box2& area) const {
  drawPlan(painter, target, area, impl_->scene, impl_->font());
}

Box2 PlanView::drawnBox() const { return impl_->drawn(); }

bool PlanView::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::ShortcutOverride: {
      auto* key = static_cast<QKeyEvent*>(event);
      impl_->usedKey = 0;
      if (const auto meant = keyOf(*key); meant && impl_->editor.key(*meant)) {
        impl_->usedKey = key->key();
        event->accept();
        return true;
      }
      break;
    }
    case QEvent::ContextMenu: {
      auto* menu = static_cast<QContextMenuEvent*>(event);
      if (menu->reason() == QContextMenuEvent::Keyboard)
        emit contextMenuRequested(mapToGlobal(rect().center()));
      event->accept();
      return true;
    }
    case QEvent::NativeGesture: {
      auto* gesture = static_cast<QNativeGestureEvent*>(event);
      if (gesture->gestureType() == Qt::ZoomNativeGesture) {
        impl_->zoomAbout(gesture->position(), 1 + gesture->value());
        return true;
      }
      break;
    }
    case QEvent::ToolTip: {
      auto* help = static_cast<QHelpEvent*>(event);
      const PieceItem* item = nullptr;
      if (impl_->hovered)
        std::visit([&](auto id) { item = impl_->scene.pieces().find(id.value); }, *impl_->hovered);
      if (!item || childAt(help->pos())) break;
      const LengthUnit unit = impl_->editor.settings().unit;
      const Vec3 size = item->piece().size;
      QToolTip::showText(help->globalPos(),
                         QStringLiteral("%1\n%2 × %3 × %4")
                             .arg(toQt(item->piece().name), lengthText(size.x, unit),
                                  lengthText(size.y, unit), lengthText(size.z, unit)),
                         this);
      return true;
    }
    default:
      break;
  }
  return QWidget::event(event);
}

void PlanView::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  impl_->paint(painter, event->rect());
}

void PlanView::mousePressEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  if (event->button() == Qt::MiddleButton || (event->button() == Qt::LeftButton && impl_->spaceHeld)) {
    impl_->startPan(at);
    return;
  }
  if (event->button() == Qt::RightButton && impl_->editor.selecting()) {
    const auto under = impl_->hits(at);
    const auto selected = [this](AnyId id) { return contains(impl_->editor.selection(), id); };
    if (!under.empty() && std::none_of(under.begin(), under.end(), selected))
      impl_->editor.select(only(under.front()));
    impl_->menuPressed = true;
    return;
  }
  if (buttonOf(event->button()) == PointerEvent::Button::None) {
    event->ignore();
    return;
  }
  impl_->point(PointerEvent::Kind::Press, at, buttonOf(event->button()), event->modifiers());
}

void PlanView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = event->position();
  impl_->pointer = at;
  if (impl_->panning) {
    impl_->panTo(at);
    return;
  }
  const Vec2 on = impl_->view.toPlane(at);
  emit pointerAt(on.x, on.y);
  const bool left = event->buttons().testFlag(Qt::LeftButton);
  impl_->point(PointerEvent::Kind::Move, at,
               left                                         ? PointerEvent::Button::Left
               : event->buttons().testFlag(Qt::RightButton) ? PointerEvent::Button::Right
                                                            : PointerEvent::Button::None,
               event->modifiers());
  if (left) {
    if (impl_->hovered) impl_->hovered.reset();
    if (!impl_->inner().contains(at) && !impl_->follow.isActive()) impl_->follow.start();
    if (impl_->inner().contains(at)) impl_->follow.stop();
  } else {
    impl_->hover(at);
  }
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
  impl_->follow.stop();
  if (impl_->panning && (event->button() == Qt::MiddleButton || event->button() == Qt::LeftButton)) {
    impl_->panning = false;
    impl_->showCursor();
    return;
  }
  if (event->button() == Qt::RightButton && impl_->menuPressed) {
    impl_->menuPressed = false;
    emit contextMenuRequested(event->globalPosition().toPoint());
    return;
  }
  if (buttonOf(event->button()) == PointerEvent::Button::None) return;
  impl_->point(PointerEvent::Kind::Release, event->position(), buttonOf(event->button()), event->modifiers());
}

void PlanView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) {
    zoomToFit();
    return;
  }
  if (event->button() != Qt::LeftButton || impl_->spaceHeld) {
    mousePressEvent(event);
    return;
  }
  impl_->point(PointerEvent::Kind::DoubleClick, event->position(), PointerEvent::Button::Left,
               event->modifiers());
}

void PlanView::leaveEvent(QEvent*) {
  impl_->pointer.reset();
  impl_->hovered.reset();
  PointerEvent event = impl_->editor.lastPointer();
  event.kind = PointerEvent::Kind::Leave;
  event.plane = plane();
  impl_->editor.pointer(event);
  emit pointerLeft();
  update();
}

void PlanView::keyPressEvent(QKeyEvent* event) {
  if (impl_->usedKey != 0 && impl_->usedKey == event->key()) {  // the tool has it already
    impl_->usedKey = 0;
    return;
  }
  const auto meant = keyOf(*event);
  if (meant && impl_->editor.key(*meant)) return;
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat()) {
    impl_->spaceHeld = true;
    impl_->showCursor();
    return;
  }
  if (event->key() == Qt::Key_Space) return;
  event->ignore();
}

void PlanView::keyReleaseEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && !event->isAutoRepeat() && impl_->spaceHeld) {
    impl_->spaceHeld = false;
    impl_->showCursor();
    return;
  }
  event->ignore();
}

void PlanView::changeEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange:
    case QEvent::LanguageChange:
      impl_->colors = PlanColors(palette());
      impl_->layer.markAll();
      impl_->placeCaption();
      update();
      break;
    default:
      break;
  }
  QWidget::changeEvent(event);
}

}  // namespace idap
