#include "studio/plan/plan_view.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QElapsedTimer>
#include <QFontInfo>
#include <QHelpEvent>
#include <QMimeData>
#include <QNativeGestureEvent>
#include <QPaintEvent>
#include <QTimer>
#include <QToolTip>
#include <cmath>

#include "editor/hit_test.h"
#include "editor/tools/place_tool.h"
#include "studio/plan/paint_overlay.h"
#include "studio/plan/plan_caption.h"
#include "studio/plan/plan_input.h"
#include "studio/plan/plan_layer.h"
#include "studio/plan/plan_scene.h"
#include "studio/plan/rulers.h"
#include "studio/widgets/mime_types.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kLeastScale = 0.5, kMostScale = 20'000;  // pixels a metre
constexpr double kEmptyHome = 10;                         // m that a home without anything shows
constexpr double kNear = 5;                               // pixels: what the pointer is taken to be on
constexpr double kFrame = 8;                              // ms of a frame that painting anew may take
constexpr int kRest = 80;                                 // ms after the last turn of the wheel
constexpr int kFollow = 30;  // ms between two steps of a view that follows the pointer

}  // namespace

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

  void setView(ViewMap next) {
    // On whole device pixels, so that a pan can move the picture instead of painting it anew.
    const double ratio = self.devicePixelRatioF();
    next.origin = QPointF(std::round(next.origin.x() * ratio), std::round(next.origin.y() * ratio)) / ratio;
    if (next == view) return;
    view = next;
    self.update();
  }
  void zoomAbout(QPointF still, double factor) {
    ViewMap next = view;
    next.scale = std::clamp(view.scale * factor, kLeastScale, kMostScale);
    const double real = next.scale / view.scale;
    next.origin = still + (view.origin - still) * real;
    fitted = false;
    zoomed.start();
    setView(next);
  }
  void panBy(QPointF pixels) {
    ViewMap next = view;
    next.origin += pixels;
    fitted = false;
    setView(next);
  }
  void show(Box2 box, double margin) {
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
  Box2 drawn() const {
    const Box2 box = scene.bounds();
    if (!box.empty()) return box;
    const double half = kEmptyHome / 2;
    return scene.plane() == Plane::XY ? Box2{{-half, -half}, {half, half}} : Box2{{-half, -0.5}, {half, 3.5}};
  }

  void take(const DirtyBoxes& dirty) {
    if (dirty.all) layer.markAll();
    for (const Box2& box : dirty.boxes) layer.mark(view.toView(box));
    if (dirty.all || !dirty.boxes.empty()) self.update();
  }
  void changed(Editor::Change change) {
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
  void nameLevel() {
    const Level* level = editor.home().levels.find(editor.level());
    caption->setLevelName(level ? toQt(level->name) : QString());
  }
  void placeCaption() { caption->move(ruler() + 6, ruler() + 6); }
  void showCursor() {
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
  Cursor shownCursor = Cursor::Arrow;
  bool handShown = true;

  void point(PointerEvent::Kind kind, QPointF at, PointerEvent::Button button,
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
  std::vector<AnyId> hits(QPointF at) const {
    return hitsAt(editor, scene.plane(), view.toPlane(at), kNear / view.scale);
  }
  void hover(QPointF at) {
    std::optional<AnyId> now;
    if (editor.selecting())
      if (const auto found = hits(at); !found.empty()) now = found.front();
    if (now == hovered) return;
    hovered = now;
    self.update();
  }
  void startPan(QPointF at) {
    panning = true;
    panFrom = at;
    panOrigin = view.origin;
    showCursor();
  }

  void paint(QPainter& p, const QRect& area) {
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
};

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
  connect(&impl_->follow, &QTimer::timeout, this, [this] {
    if (!impl_->pointer || !(QApplication::mouseButtons() & Qt::LeftButton)) {
      impl_->follow.stop();
      return;
    }
    const QRectF room = impl_->inner();
    const QPointF at = *impl_->pointer;
    const QPointF out(at.x() - std::clamp(at.x(), room.left(), room.right()),
                      at.y() - std::clamp(at.y(), room.top(), room.bottom()));
    impl_->panBy(-QPointF(std::clamp(out.x(), -40.0, 40.0), std::clamp(out.y(), -40.0, 40.0)) * 0.5);
    impl_->point(PointerEvent::Kind::Move, at, PointerEvent::Button::Left, QApplication::keyboardModifiers());
  });
  impl_->nameLevel();
  impl_->placeCaption();
  impl_->showCursor();
}

PlanView::~PlanView() { impl_->editor.unsubscribe(impl_->subscription); }

Plane PlanView::plane() const { return impl_->scene.plane(); }
double PlanView::pixel() const { return 1 / impl_->view.scale; }
Vec2 PlanView::toPlane(QPointF view) const { return impl_->view.toPlane(view); }
QPointF PlanView::toView(Vec2 plane) const { return impl_->view.toView(plane); }

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
    ViewMap next = impl_->view;
    next.origin = impl_->panOrigin + at - impl_->panFrom;
    impl_->fitted = false;
    impl_->setView(next);
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

void PlanView::dragEnterEvent(QDragEnterEvent* event) {
  const QByteArray id = event->mimeData()->data(QString::fromLatin1(kPieceMime));
  const CatalogPiecePtr piece = id.isEmpty() ? nullptr : impl_->editor.catalog().find(id.toStdString());
  if (!piece) return;
  impl_->dragging = true;
  impl_->editor.setTool(makePlaceTool(piece, true));
  impl_->point(PointerEvent::Kind::Move, event->position(), PointerEvent::Button::None, event->modifiers());
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void PlanView::dragMoveEvent(QDragMoveEvent* event) {
  if (!impl_->dragging) return;
  impl_->pointer = event->position();
  impl_->point(PointerEvent::Kind::Move, event->position(), PointerEvent::Button::None, event->modifiers());
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void PlanView::dragLeaveEvent(QDragLeaveEvent*) {
  if (!impl_->dragging) return;
  impl_->dragging = false;
  impl_->pointer.reset();
  PointerEvent event = impl_->editor.lastPointer();
  event.kind = PointerEvent::Kind::Leave;
  impl_->editor.pointer(event);
  impl_->editor.setTool(nullptr);
}

void PlanView::dropEvent(QDropEvent* event) {
  if (!impl_->dragging) return;
  impl_->dragging = false;
  impl_->point(PointerEvent::Kind::Press, event->position(), PointerEvent::Button::Left, event->modifiers());
  if (!impl_->editor.selecting())
    impl_->point(PointerEvent::Kind::Release, event->position(), PointerEvent::Button::Left,
                 event->modifiers());
  event->setDropAction(Qt::CopyAction);
  event->accept();
  setFocus(Qt::OtherFocusReason);
}

}  // namespace idap
