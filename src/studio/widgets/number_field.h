// Fields for numbers that are no lengths: with a unit behind them (lm, K, %, EUR), and angles.
#pragma once

#include "studio/widgets/value_field.h"

namespace idap {

// A number or a sum of numbers.
class NumberField : public ValueField {
  Q_OBJECT
 public:
  explicit NumberField(QWidget* parent = nullptr, const QString& unit = {}, int decimals = 2);

  void setUnit(const QString& unit);  // shown behind the number; may be typed or left out
  void setDecimals(int decimals);     // at most so many; 0 takes whole numbers only

 protected:
  Reading read(const QString& text) const override;
  QString write(double value) const override;
  double usualStep() const override;

 private:
  QString unit_;
  int decimals_;
};

// An angle in degrees, or a sum of them. Degrees in value() too.
class AngleField : public NumberField {
  Q_OBJECT
 public:
  explicit AngleField(QWidget* parent = nullptr);
};

// The value of `12+3*(2-1)`; false for anything that is not a finite number.
bool readNumber(const QString& text, double& value);

}  // namespace idap
