#include "studio/widgets/value_field.h"

#include <QEvent>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <cmath>
#include <limits>

namespace idap {

namespace {
constexpr int kRest = 350;  // ms
}

ValueField::ValueField(QWidget* parent)
    : QLineEdit(parent),
      min_(-std::numeric_limits<double>::infinity()),
      max_(std::numeric_limits<double>::infinity()),
      rest_(new QTimer(this)) {
  rest_->setSingleShot(true);
  rest_->setInterval(kRest);
  connect(rest_, &QTimer::timeout, this, [this] { commit(); });
  connect(this, &QLineEdit::textEdited, this, [this] { onEdited(); });
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

ValueField::~ValueField() = default;

void ValueField::setValue(double value) {
  const bool same = state_ == State::Value && value == value_;
  value_ = value;
  state_ = State::Value;
  if (typing() && (held_ || same)) return;
  showValue();
}

void ValueField::setMixed() { show(State::Mixed); }
void ValueField::setNone() { show(State::None); }

void ValueField::show(State state) {
  const bool same = state_ == state;
  state_ = state;
  if (typing() && (held_ || same)) return;
  showValue();
}

void ValueField::setRange(double min, double max) {
  min_ = min;
  max_ = max;
}

void ValueField::showValue() {
  stepping_ = false;
  rest_->stop();
  const QString words = state_ == State::Mixed ? tr("Several values") : QString();
  if (placeholderText() != words) setPlaceholderText(words);
  const QString shown = state_ == State::Value ? write(value_) : QString();
  // setText() moves the cursor: only when there is something new to show.
  if (text() != shown) {
    const bool all = hasFocus() && selectedText() == text();
    setText(shown);
    if (all) selectAll();
    if (!hasFocus()) setCursorPosition(0);
  }
  setModified(false);
  mark({});
}

void ValueField::reset() {
  held_ = false;
  showValue();
}

ValueField::Reading ValueField::checked(const QString& text) const {
  Reading reading = read(text.trimmed());
  if (!reading.problem.isEmpty()) return reading;
  // A limit as it is shown may lie a rounding beyond the limit itself.
  const double slack = 1e-9 * std::max(1.0, std::abs(reading.value));
  if (reading.value < min_ - slack) {
    reading.problem = tr("This must be at least %1.").arg(write(min_));
  } else if (reading.value > max_ + slack) {
    reading.problem = tr("This must be at most %1.").arg(write(max_));
  } else {
    reading.value = std::clamp(reading.value, min_, max_);
  }
  return reading;
}

void ValueField::onEdited() {
  held_ = true;
  stepping_ = false;
  rest_->stop();
  const QString typed = text().trimmed();
  if (typed.isEmpty()) {
    mark({});
    return;
  }
  const Reading reading = checked(typed);
  mark(reading.problem);
  if (reading.problem.isEmpty()) emit valueTyped(reading.value);
}

bool ValueField::commit() {
  if (stepping_) {
    const double value = stepped_;
    value_ = value;
    state_ = State::Value;
    held_ = false;
    showValue();
    emit valueChanged(value);
    return true;
  }
  if (!isModified()) return true;
  const QString typed = text().trimmed();
  if (typed.isEmpty()) {
    const bool clears = optional_ && state_ != State::None;
    if (clears) state_ = State::None;
    reset();  // an empty line keeps what was there
    if (clears) emit cleared();
    return true;
  }
  const Reading reading = checked(typed);
  mark(reading.problem);
  if (!reading.problem.isEmpty()) return false;
  const bool changed = state_ != State::Value || (reading.value != value_ && typed != write(value_));
  if (changed) value_ = reading.value;
  state_ = State::Value;
  reset();
  if (changed) emit valueChanged(value_);
  return true;
}

void ValueField::stepBy(double steps) {
  if (isReadOnly() || state_ != State::Value || steps == 0) return;
  if (isModified() && !commit()) return;
  const double from = stepping_ ? stepped_ : value_;
  const double step = step_ > 0 ? step_ : usualStep();
  const double to = std::clamp(from + steps * step, std::min(min_, from), std::max(max_, from));
  if (to == from) return;
  stepping_ = true;
  held_ = true;
  stepped_ = to;
  setText(write(to));
  selectAll();
  mark({});
  rest_->start();
  emit valueStepping(to);
}

void ValueField::mark(const QString& problem) {
  if (problem == problem_) return;
  problem_ = problem;
  setAccessibleDescription(problem);
  if (problem.isEmpty()) {
    setPalette(QPalette());
    return;
  }
  // The field's own colours leaning to red: readable in light and dark.
  QPalette colours;
  const QColor base = colours.color(QPalette::Base);
  const QColor red(220, 50, 47);
  const auto mixed = [&](int a, int b) { return (3 * a + b) / 4; };
  colours.setColor(QPalette::Base, QColor(mixed(base.red(), red.red()), mixed(base.green(), red.green()),
                                          mixed(base.blue(), red.blue())));
  setPalette(colours);
}

bool ValueField::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::ToolTip:
      if (!problem_.isEmpty()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), problem_, this);
        return true;
      }
      break;
    case QEvent::ShortcutOverride: {
      // With nothing half typed, undo and redo are those of the home.
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
        if (stepping_) commit();
        if (!isModified()) {
          event->ignore();
          return false;
        }
      }
      break;
    }
    default:
      break;
  }
  return QLineEdit::event(event);
}

void ValueField::keyPressEvent(QKeyEvent* event) {
  const double many = event->modifiers() & Qt::ShiftModifier ? 10 : 1;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      if (!commit()) {
        QToolTip::showText(mapToGlobal(QPoint(0, height())), problem_, this);
        event->accept();
        return;
      }
      selectAll();
      break;
    case Qt::Key_Escape:
      if (!isModified()) break;
      reset();
      selectAll();
      event->accept();
      return;
    case Qt::Key_Up:
      stepBy(many);
      return;
    case Qt::Key_Down:
      stepBy(-many);
      return;
    case Qt::Key_PageUp:
      stepBy(10);
      return;
    case Qt::Key_PageDown:
      stepBy(-10);
      return;
    default:
      if (!isModified() && (event->matches(QKeySequence::Undo) || event->matches(QKeySequence::Redo))) {
        event->ignore();
        return;
      }
      break;
  }
  QLineEdit::keyPressEvent(event);
}

void ValueField::wheelEvent(QWheelEvent* event) {
  // Only in the field that has the keyboard: rolling over a panel scrolls it and changes nothing.
  if (!hasFocus()) {
    event->ignore();
    return;
  }
  wheel_ += event->angleDelta().y() / 120.0;
  const double whole = std::trunc(wheel_);
  wheel_ -= whole;
  stepBy(whole * (event->modifiers() & Qt::ShiftModifier ? 10 : 1));
  event->accept();
}

void ValueField::focusInEvent(QFocusEvent* event) {
  QLineEdit::focusInEvent(event);
  wheel_ = 0;
  // A number is mostly replaced as a whole.
  if (!isModified() && event->reason() != Qt::PopupFocusReason)
    QTimer::singleShot(0, this, [this] {
      if (hasFocus() && !isModified()) selectAll();
    });
}

void ValueField::focusOutEvent(QFocusEvent* event) {
  if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) {
    commit();
    held_ = false;
  }
  QLineEdit::focusOutEvent(event);
}

void ValueField::changeEvent(QEvent* event) {
  QLineEdit::changeEvent(event);
  if (event->type() == QEvent::LanguageChange && state_ == State::Mixed)
    setPlaceholderText(tr("Several values"));
}

QSize ValueField::sizeHint() const {
  QSize size = QLineEdit::sizeHint();
  size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000.00 cm")) + size.height());
  return size;
}

QSize ValueField::minimumSizeHint() const {
  QSize size = QLineEdit::minimumSizeHint();
  size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("00.00 m")) + size.height() / 2);
  return size;
}

}  // namespace idap
