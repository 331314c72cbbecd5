#include "studio/plan/plan_input.h"

#include <QPainter>
#include <QPixmap>
#include <QWidget>

#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// Drawn black on white, as the cursors of all systems are: seen on any ground.
template <class Draw>
QCursor drawnCursor(const QWidget& widget, QPoint hot, const Draw& draw) {
  constexpr int kSize = 24;
  const double ratio = widget.devicePixelRatioF();
  QPixmap picture(QSize(kSize, kSize) * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter p(&picture);
  p.setRenderHint(QPainter::Antialiasing);
  p.setBrush(Qt::NoBrush);
  for (const auto& [color, width] : {std::pair{Qt::white, 4.0}, std::pair{Qt::black, 1.8}}) {
    p.setPen(QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    draw(p);
  }
  p.end();
  return QCursor(picture, hot.x(), hot.y());
}

}  // namespace

Modifiers modifiersOf(Qt::KeyboardModifiers modifiers) {
  return {.shift = modifiers.testFlag(Qt::ShiftModifier),
          .control = modifiers.testFlag(Qt::ControlModifier),
          .alt = modifiers.testFlag(Qt::AltModifier)};
}

PointerEvent::Button buttonOf(Qt::MouseButton button) {
  return button == Qt::LeftButton    ? PointerEvent::Button::Left
         : button == Qt::RightButton ? PointerEvent::Button::Right
                                     : PointerEvent::Button::None;
}

std::optional<KeyEvent> keyOf(const QKeyEvent& event) {
  KeyEvent key;
  key.modifiers = modifiersOf(event.modifiers());
  switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      key.key = Key::Enter;
      return key;
    case Qt::Key_Escape:
      key.key = Key::Escape;
      return key;
    case Qt::Key_Tab:
      key.key = key.modifiers.shift ? Key::BackTab : Key::Tab;
      return key;
    case Qt::Key_Backtab:
      key.key = Key::BackTab;
      return key;
    case Qt::Key_Backspace:
      key.key = Key::Backspace;
      return key;
    case Qt::Key_Delete:
      key.key = Key::Delete;
      return key;
    case Qt::Key_Left:
      key.key = Key::Left;
      return key;
    case Qt::Key_Right:
      key.key = Key::Right;
      return key;
    case Qt::Key_Up:
      key.key = Key::Up;
      return key;
    case Qt::Key_Down:
      key.key = Key::Down;
      return key;
    case Qt::Key_PageUp:
      key.key = Key::PageUp;
      return key;
    case Qt::Key_PageDown:
      key.key = Key::PageDown;
      return key;
    default:
      break;
  }
  // What is held with Control, Alt or Meta is a shortcut, unless it writes something (AltGr).
  const bool altGr = event.modifiers().testFlag(Qt::GroupSwitchModifier);
  if (!altGr && (key.modifiers.control || key.modifiers.alt || event.modifiers().testFlag(Qt::MetaModifier)))
    return std::nullopt;
  const QString text = event.text();
  if (text.isEmpty() || !text.at(0).isPrint()) return std::nullopt;
  key.text = fromQt(text);
  return key;
}

QCursor cursorOf(Cursor cursor, const QWidget& widget) {
  switch (cursor) {
    case Cursor::Arrow:
      return Qt::ArrowCursor;
    case Cursor::Cross:
      return Qt::CrossCursor;
    case Cursor::Move:
      return Qt::SizeAllCursor;
    case Cursor::SizeHorizontal:
      return Qt::SizeHorCursor;
    case Cursor::SizeVertical:
      return Qt::SizeVerCursor;
    case Cursor::SizeDiagonal:
      return Qt::SizeBDiagCursor;
    case Cursor::SizeAntiDiagonal:
      return Qt::SizeFDiagCursor;
    case Cursor::Text:
      return Qt::IBeamCursor;
    case Cursor::Hand:
      return Qt::PointingHandCursor;
    case Cursor::Forbidden:
      return Qt::ForbiddenCursor;
    case Cursor::Rotate:
      return drawnCursor(widget, {12, 12}, [](QPainter& p) {
        p.drawArc(QRectF(5, 5, 14, 14), 60 * 16, 270 * 16);
        p.drawPolyline(QPolygonF{QPointF(11, 2), QPointF(15.5, 6), QPointF(10.5, 9)});
      });
    case Cursor::Eraser:
      return drawnCursor(widget, {6, 19}, [](QPainter& p) {
        p.drawPolygon(
            QPolygonF{QPointF(4, 16), QPointF(14, 5), QPointF(20, 10), QPointF(10, 20), QPointF(7, 20)});
        p.drawLine(QPointF(9, 10.5), QPointF(15, 15.5));
      });
  }
  return Qt::ArrowCursor;
}

}  // namespace idap
