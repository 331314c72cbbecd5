// A piece of the catalog dragged onto a plane: the tool that places it follows the drag.
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>

#include "editor/tools/place_tool.h"
#include "studio/plan/plan_input.h"
#include "studio/plan/plan_view_impl.h"
#include "studio/widgets/mime_types.h"

namespace idap {

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
