#include "studio/widgets/length_field.h"

#include "base/error.h"
#include "studio/widgets/texts.h"

namespace idap {

LengthField::LengthField(QWidget* parent, LengthUnit unit) : ValueField(parent), unit_(unit) { showValue(); }

void LengthField::setUnit(LengthUnit unit) {
  if (unit == unit_) return;
  unit_ = unit;
  if (!typing()) showValue();
}

ValueField::Reading LengthField::read(const QString& text) const {
  try {
    return {parseLength(fromQt(text), unit_), {}};
  } catch (const ParseError&) {
    return {0, tr("“%1” is not a length. Write a number, with a unit if you like, or a sum: 120, 3.25 m, "
                  "10'8\", 120+15.")
                   .arg(text)};
  }
}

QString LengthField::write(double metres) const { return lengthText(metres, unit_); }

double LengthField::usualStep() const {
  switch (unit_) {
    case LengthUnit::Millimetre:
    case LengthUnit::Centimetre:
    case LengthUnit::Metre:
      return 0.01;
    case LengthUnit::FeetInches:
      return 0.0254;
  }
  return 0.01;
}

}  // namespace idap
