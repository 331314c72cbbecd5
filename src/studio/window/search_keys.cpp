#include "studio/window/search_keys.h"

#include <QKeyEvent>
#include <QLineEdit>

#include "studio/widgets/value_field.h"

namespace idap {

void SearchKeys::watch(QWidget* panel) {
  for (QLineEdit* line : panel->findChildren<QLineEdit*>())
    if (!qobject_cast<ValueField*>(line)) line->installEventFilter(this);
}

bool SearchKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
      event->ignore();  // not the field's: on to the window's shortcuts
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace idap
