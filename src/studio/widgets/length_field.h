// A field for a length: takes `120+15`, `3.25m`, `10'8"`, shows the user's unit. Metres inside.
#pragma once

#include "base/units.h"
#include "studio/widgets/value_field.h"

namespace idap {

class LengthField : public ValueField {
  Q_OBJECT
 public:
  explicit LengthField(QWidget* parent = nullptr, LengthUnit unit = LengthUnit::Centimetre);

  LengthUnit unit() const { return unit_; }
  void setUnit(LengthUnit unit);  // a bare number counts in it

 protected:
  Reading read(const QString& text) const override;
  QString write(double metres) const override;
  double usualStep() const override;

 private:
  LengthUnit unit_;
};

}  // namespace idap
