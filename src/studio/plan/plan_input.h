// Qt's events in the editor's words.
#pragma once

#include <QCursor>
#include <QKeyEvent>
#include <optional>

#include "editor/input.h"
#include "editor/overlay.h"

namespace idap {

Modifiers modifiersOf(Qt::KeyboardModifiers modifiers);
PointerEvent::Button buttonOf(Qt::MouseButton button);
// Nothing for keys that no tool takes: shortcuts, function keys, dead keys.
std::optional<KeyEvent> keyOf(const QKeyEvent& event);
QCursor cursorOf(Cursor cursor, const QWidget& widget);

}  // namespace idap
