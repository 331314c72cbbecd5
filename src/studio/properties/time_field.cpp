#include "studio/properties/time_field.h"

#include <QTimer>
#include <QWheelEvent>

#include "base/error.h"
#include "light/civil_time.h"

namespace idap {

TimeField::TimeField(QWidget* parent) : QDateTimeEdit(parent), rest_(new QTimer(this)) {
  setTimeSpec(Qt::UTC);  // holds the clock's figures; the zone is ours to count with
  setDisplayFormat(QStringLiteral("yyyy-MM-dd HH:mm"));
  setCalendarPopup(true);
  setKeyboardTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  rest_->setSingleShot(true);
  rest_->setInterval(700);
  connect(rest_, &QTimer::timeout, this, &TimeField::commit);
  connect(this, &QDateTimeEdit::dateTimeChanged, this, [this] {
    changed_ = true;
    rest_->start();
  });
}

void TimeField::setTime(std::int64_t utc, const std::string& zone) {
  if (changed_) return;
  utc_ = utc;
  zone_ = isTimeZone(zone) ? zone : "UTC";
  const CivilTime t = civilFromUtc(utc, zone_);
  const QDateTime shown(QDate(t.year, t.month, t.day), QTime(t.hour, t.minute, t.second), Qt::UTC);
  if (shown == dateTime()) return;
  const QSignalBlocker quiet(this);
  setDateTime(shown);
}

void TimeField::commit() {
  rest_->stop();
  if (!std::exchange(changed_, false)) return;
  const QDate date = dateTime().date();
  const QTime time = dateTime().time();
  const std::int64_t utc =
      utcFromCivil({date.year(), date.month(), date.day(), time.hour(), time.minute(), time.second()}, zone_);
  if (utc == utc_) return;
  utc_ = utc;
  emit timeChosen(utc);
}

void TimeField::wheelEvent(QWheelEvent* event) {
  if (hasFocus())
    QDateTimeEdit::wheelEvent(event);
  else
    event->ignore();
}

void TimeField::focusOutEvent(QFocusEvent* event) {
  QDateTimeEdit::focusOutEvent(event);
  if (event->reason() != Qt::PopupFocusReason && event->reason() != Qt::ActiveWindowFocusReason) commit();
}

QSize TimeField::minimumSizeHint() const {
  QSize size = QDateTimeEdit::minimumSizeHint();
  size.setWidth(fontMetrics().averageCharWidth() * 8);
  return size;
}

}  // namespace idap
