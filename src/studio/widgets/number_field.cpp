#include "studio/widgets/number_field.h"

#include <cmath>

#include "base/error.h"
#include "base/units.h"
#include "studio/widgets/texts.h"

namespace idap {

bool readNumber(const QString& text, double& value) {
  // The arithmetic of lengths without their units.
  static const QString kAllowed = QStringLiteral("0123456789.,+-*/() \u00a0\u2212\u00d7\u00f7");
  for (const QChar c : text)
    if (!kAllowed.contains(c)) return false;
  try {
    value = parseLength(fromQt(text), LengthUnit::Metre);
    return true;
  } catch (const ParseError&) {
    return false;
  }
}

NumberField::NumberField(QWidget* parent, const QString& unit, int decimals)
    : ValueField(parent), unit_(unit), decimals_(decimals) {
  showValue();
}

void NumberField::setUnit(const QString& unit) {
  if (unit == unit_) return;
  unit_ = unit;
  if (!typing()) showValue();
}

void NumberField::setDecimals(int decimals) {
  decimals_ = decimals;
  if (!typing()) showValue();
}

ValueField::Reading NumberField::read(const QString& text) const {
  QString number = text;
  const QString unit = unit_.trimmed();
  if (!unit.isEmpty()) number.remove(unit, Qt::CaseInsensitive);
  Reading reading;
  if (!readNumber(number.trimmed(), reading.value))
    reading.problem = tr("“%1” is not a number. Write a number or a sum: 45, 2.5, 30+15.").arg(text);
  else if (decimals_ == 0 && std::abs(reading.value - std::round(reading.value)) > 1e-9)
    reading.problem = tr("This must be a whole number.");
  return reading;
}

QString NumberField::write(double value) const {
  QString number = QString::number(value, 'f', decimals_);
  if (decimals_ > 0) {
    while (number.endsWith(QLatin1Char('0'))) number.chop(1);
    if (number.endsWith(QLatin1Char('.'))) number.chop(1);
  }
  if (number == QStringLiteral("-0")) number = QStringLiteral("0");
  return number + unit_;
}

double NumberField::usualStep() const { return 1; }

AngleField::AngleField(QWidget* parent) : NumberField(parent, QStringLiteral("°"), 2) {}

}  // namespace idap
