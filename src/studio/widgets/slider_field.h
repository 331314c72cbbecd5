// A slider with its number beside it: for values one finds by eye (brightness, shininess, colour
// temperature).
#pragma once

#include <QSlider>
#include <QWidget>

#include "studio/widgets/number_field.h"

namespace idap {

class SliderField : public QWidget {
  Q_OBJECT
 public:
  // step: of the slider; the number takes any value in between.
  SliderField(double min, double max, double step, const QString& unit, int decimals,
              QWidget* parent = nullptr);

  double value() const { return number_->value(); }
  void setValue(double value);
  void setMixed();
  void setNone(const QString& words);  // no value of its own; the words stand in the number's place
  NumberField* number() const { return number_; }
  QSlider* slider() const { return slider_; }

 signals:
  void valueChanging(double value);  // the slider is dragged; valueChanged() follows
  void valueChanged(double value);   // by the user, once a change

 private:
  int position(double value) const;
  double valueAt(int position) const;

  double min_, max_, step_;
  QSlider* slider_;
  NumberField* number_;
  bool dragged_ = false;
};

}  // namespace idap
