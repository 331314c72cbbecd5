// What is dragged into the live view: furniture, which lies where the pointer points at, and finishes, which
// show on what is under it.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>

#include "editor/tools/place_tool.h"
#include "studio/view3d/view3d_impl.h"
#include "studio/widgets/mime_types.h"

namespace idap {

// With Shift the whole of a piece, both sides of a wall.
void View3d::Impl::paintAt(QPointF at, Qt::KeyboardModifiers modifiers) {
  auto under = view->partAt(at.toPoint());
  if (under && modifiers.testFlag(Qt::ShiftModifier)) under->second.clear();
  finish->over(under);
}

void View3d::dragEnterEvent(QDragEnterEvent* event) {
  Impl& d = *impl_;
  if (d.action != Impl::Action::None) return;
  const QByteArray id = event->mimeData()->data(QString::fromLatin1(kPieceMime));
  const QByteArray material = event->mimeData()->data(QString::fromLatin1(kMaterialMime));
  const CatalogPiecePtr piece = id.isEmpty() ? nullptr : d.editor.catalog().find(id.toStdString());
  if (piece) {
    d.action = Impl::Action::Drop;
    d.plane = Plane::XY;
    d.onPlane = {0, 0, d.editor.elevation()};
    d.planeNormal = {0, 0, 1};
    d.freezeX = false;
    d.editor.setTool(makePlaceTool(piece, true));
  } else if (!material.isEmpty()) {
    d.action = Impl::Action::Paint;
    d.finish.emplace(d.editor, Finish{.material = material.toStdString()});
  } else {
    return;
  }
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void View3d::dragMoveEvent(QDragMoveEvent* event) {
  Impl& d = *impl_;
  if (d.action == Impl::Action::Paint)
    d.paintAt(event->position(), event->modifiers());
  else if (d.action == Impl::Action::Drop)
    d.pointer(PointerEvent::Kind::Move, event->position(), PointerEvent::Button::None, event->modifiers());
  else
    return;
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void View3d::dragLeaveEvent(QDragLeaveEvent*) {
  Impl& d = *impl_;
  d.finish.reset();
  if (d.action == Impl::Action::Drop) d.editor.setTool(nullptr);
  if (d.action == Impl::Action::Paint || d.action == Impl::Action::Drop) d.action = Impl::Action::None;
}

void View3d::dropEvent(QDropEvent* event) {
  Impl& d = *impl_;
  if (d.action == Impl::Action::Paint) {
    d.paintAt(event->position(), event->modifiers());
    d.finish->drop();
    d.finish.reset();
  } else if (d.action == Impl::Action::Drop) {
    d.pointer(PointerEvent::Kind::Press, event->position(), PointerEvent::Button::Left, event->modifiers());
    if (!d.editor.selecting())
      d.pointer(PointerEvent::Kind::Release, event->position(), PointerEvent::Button::Left,
                event->modifiers());
  } else {
    return;
  }
  d.action = Impl::Action::None;
  event->setDropAction(Qt::CopyAction);
  event->accept();
  setFocus(Qt::OtherFocusReason);
}

}  // namespace idap
