// A field for a date and a time of day at the home's place; applied at a rest, or on leaving the field.
#pragma once

#include <QDateTimeEdit>
#include <cstdint>
#include <string>

class QTimer;

namespace idap {

class TimeField : public QDateTimeEdit {
  Q_OBJECT
 public:
  explicit TimeField(QWidget* parent = nullptr);

  // utc: milliseconds since 1970, shown as the clocks of the zone (IANA) do. Typing is not disturbed.
  void setTime(std::int64_t utc, const std::string& zone);
  QSize minimumSizeHint() const override;

 signals:
  void timeChosen(qint64 utc);  // by the user

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;

 private:
  void commit();

  std::string zone_ = "UTC";
  std::int64_t utc_ = 0;
  bool changed_ = false;
  QTimer* rest_;
};

}  // namespace idap
