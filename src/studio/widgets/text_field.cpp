#include "studio/widgets/text_field.h"

#include <QEvent>
#include <QKeyEvent>
#include <QTextDocument>
#include <cmath>

namespace idap {

namespace {

bool leavesField(const QFocusEvent* event) {
  return event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason;
}
bool undoes(const QKeyEvent* event) {
  return event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo);
}

}  // namespace

TextField::TextField(QWidget* parent) : QLineEdit(parent) {}

void TextField::setValue(const QString& value) {
  value_ = value;
  mixed_ = false;
  if (!typing()) reset();
}

void TextField::setMixed() {
  mixed_ = true;
  value_.clear();
  if (!typing()) reset();
}

void TextField::reset() {
  setPlaceholderText(mixed_ ? tr("Several values") : QString());
  if (text() != value_) {
    setText(value_);
    if (!hasFocus()) setCursorPosition(0);  // a long text shows its beginning
  }
  setModified(false);
}

bool TextField::commit() {
  if (!typing()) return false;
  const QString typed = text().trimmed();
  const bool changed = mixed_ ? !typed.isEmpty() : typed != value_;
  if (changed) {
    value_ = typed;
    mixed_ = false;
  }
  reset();
  if (changed) emit valueChanged(value_);
  return changed;
}

bool TextField::event(QEvent* event) {
  // With nothing half typed, undo and redo are those of the home.
  if (event->type() == QEvent::ShortcutOverride && !typing() && undoes(static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return false;
  }
  return QLineEdit::event(event);
}

void TextField::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    commit();
    selectAll();
  } else if (event->key() == Qt::Key_Escape && typing()) {
    reset();
    selectAll();
    event->accept();
    return;
  } else if (!typing() && undoes(event)) {
    event->ignore();
    return;
  }
  QLineEdit::keyPressEvent(event);
}

void TextField::focusOutEvent(QFocusEvent* event) {
  if (leavesField(event)) {
    commit();
    setCursorPosition(0);
  }
  QLineEdit::focusOutEvent(event);
}

void TextField::changeEvent(QEvent* event) {
  QLineEdit::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && mixed_) setPlaceholderText(tr("Several values"));
}

QSize TextField::minimumSizeHint() const {
  QSize size = QLineEdit::minimumSizeHint();
  size.setWidth(fontMetrics().averageCharWidth() * 8);
  return size;
}

TextArea::TextArea(QWidget* parent) : QPlainTextEdit(parent) {
  setTabChangesFocus(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

bool TextArea::typing() const { return document()->isModified(); }

void TextArea::setValue(const QString& value) {
  value_ = value;
  mixed_ = false;
  if (!typing()) reset();
}

void TextArea::setMixed() {
  mixed_ = true;
  value_.clear();
  if (!typing()) reset();
}

void TextArea::reset() {
  setPlaceholderText(mixed_ ? tr("Several values") : QString());
  if (toPlainText() != value_) setPlainText(value_);
  document()->setModified(false);
}

void TextArea::commit() {
  if (!typing()) return;
  const QString typed = toPlainText();
  const bool changed = mixed_ ? !typed.isEmpty() : typed != value_;
  if (changed) {
    value_ = typed;
    mixed_ = false;
  }
  document()->setModified(false);
  if (changed) emit valueChanged(value_);
}

bool TextArea::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && !typing() && undoes(static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return false;
  }
  return QPlainTextEdit::event(event);
}

void TextArea::keyPressEvent(QKeyEvent* event) {
  if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) &&
      (event->modifiers() & Qt::ControlModifier)) {
    commit();
    event->accept();
    return;
  }
  if (event->key() == Qt::Key_Escape && typing()) {
    reset();
    event->accept();
    return;
  }
  QPlainTextEdit::keyPressEvent(event);
}

void TextArea::focusOutEvent(QFocusEvent* event) {
  if (leavesField(event)) commit();
  QPlainTextEdit::focusOutEvent(event);
}

void TextArea::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && mixed_) setPlaceholderText(tr("Several values"));
}

QSize TextArea::sizeHint() const {
  const double margins = 2 * (frameWidth() + document()->documentMargin());
  return {fontMetrics().averageCharWidth() * 20,
          static_cast<int>(std::ceil(lines_ * fontMetrics().lineSpacing() + margins))};
}

QSize TextArea::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 8, sizeHint().height()};
}

}  // namespace idap
