// What is dragged from the catalog onto a plane: with a piece the tool that places it follows the drag, a
// finish shows on what is under it.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>

#include "editor/tools/place_tool.h"
#include "studio/plan/plan_input.h"
#include "studio/plan/plan_view_impl.h"
#include "studio/widgets/mime_types.h"

namespace idap {

void PlanView::Impl::paintAt(QPointF at) {
  finish->over(partAt(editor, scene.plane(), view.toPlane(at), kNear / view.scale));
}

void PlanView::dragEnterEvent(QDragEnterEvent* event) {
  Impl& d = *impl_;
  const QByteArray id = event->mimeData()->data(QString::fromLatin1(kPieceMime));
  const QByteArray material = event->mimeData()->data(QString::fromLatin1(kMaterialMime));
  const CatalogPiecePtr piece = id.isEmpty() ? nullptr : d.editor.catalog().find(id.toStdString());
  if (piece) {
    d.dragging = true;
    d.editor.setTool(makePlaceTool(piece, true));
    d.point(PointerEvent::Kind::Move, event->position(), PointerEvent::Button::None, event->modifiers());
  } else if (!material.isEmpty()) {
    d.finish.emplace(d.editor, Finish{.material = material.toStdString()});
    d.paintAt(event->position());
  } else {
    return;
  }
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void PlanView::dragMoveEvent(QDragMoveEvent* event) {
  Impl& d = *impl_;
  if (d.finish) {
    d.paintAt(event->position());
  } else if (d.dragging) {
    d.pointer = event->position();
    d.point(PointerEvent::Kind::Move, event->position(), PointerEvent::Button::None, event->modifiers());
  } else {
    return;
  }
  event->setDropAction(Qt::CopyAction);
  event->accept();
}

void PlanView::dragLeaveEvent(QDragLeaveEvent*) {
  impl_->finish.reset();
  if (!impl_->dragging) return;
  impl_->dragging = false;
  impl_->pointer.reset();
  PointerEvent event = impl_->editor.lastPointer();
  event.kind = PointerEvent::Kind::Leave;
  impl_->editor.pointer(event);
  impl_->editor.setTool(nullptr);
}

void PlanView::dropEvent(QDropEvent* event) {
  Impl& d = *impl_;
  if (d.finish) {
    d.paintAt(event->position());
    d.finish->drop();
    d.finish.reset();
  } else if (d.dragging) {
    d.dragging = false;
    d.point(PointerEvent::Kind::Press, event->position(), PointerEvent::Button::Left, event->modifiers());
    if (!d.editor.selecting())
      d.point(PointerEvent::Kind::Release, event->position(), PointerEvent::Button::Left, event->modifiers());
  } else {
    return;
  }
  event->setDropAction(Qt::CopyAction);
  event->accept();
  setFocus(Qt::OtherFocusReason);
}

}  // namespace idap
