#include "studio/widgets/slider_field.h"

#include <cmath>

namespace idap {

namespace {

// The wheel scrolls the panel under the pointer, never the value.
class CalmSlider : public QSlider {
 public:
  using QSlider::QSlider;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (hasFocus())
      QSlider::wheelEvent(event);
    else
      event->ignore();
  }
};

}  // namespace

SliderField::SliderField(double min, double max, double step, const QString& unit, int decimals,
                         QWidget* parent)
    : QWidget(parent),
      min_(min),
      max_(max),
      step_(step),
      slider_(new CalmSlider(Qt::Horizontal, this)),
      number_(new NumberField(this, unit, decimals)) {
  slider_->setRange(0, static_cast<int>(std::lround((max - min) / step)));
  slider_->setPageStep(std::max(1, slider_->maximum() / 10));
  slider_->setMinimumWidth(fontMetrics().averageCharWidth() * 6);
  slider_->setFocusPolicy(Qt::StrongFocus);
  number_->setRange(min, max);
  number_->setStep(step);
  // As wide as its longest number, so that most of a narrow panel is left to the slider.
  const QString longest = QString::number(std::max(std::abs(min), std::abs(max)), 'f', decimals) + unit;
  number_->setFixedWidth(fontMetrics().horizontalAdvance(longest) + fontMetrics().height() * 5 / 4);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(number_);
  setFocusProxy(number_);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);

  connect(slider_, &QSlider::valueChanged, this, [this](int at) {
    const double value = valueAt(at);
    number_->setValue(value);
    if (slider_->isSliderDown()) {
      dragged_ = true;
      emit valueChanging(value);
    } else {
      emit valueChanged(value);  // keys, a click beside the handle
    }
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] {
    if (std::exchange(dragged_, false)) emit valueChanged(valueAt(slider_->value()));
  });
  const auto follow = [this](double value) {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(position(value));
  };
  connect(number_, &NumberField::valueStepping, this, [this, follow](double value) {
    follow(value);
    emit valueChanging(value);
  });
  connect(number_, &NumberField::valueChanged, this, [this, follow](double value) {
    follow(value);
    emit valueChanged(value);
  });
}

int SliderField::position(double value) const {
  return static_cast<int>(std::lround((std::clamp(value, min_, max_) - min_) / step_));
}
double SliderField::valueAt(int position) const { return std::min(max_, min_ + position * step_); }

void SliderField::setValue(double value) {
  if (slider_->isSliderDown()) return;
  number_->setValue(value);
  const QSignalBlocker quiet(slider_);
  slider_->setValue(position(value));
}

void SliderField::setMixed() {
  if (!slider_->isSliderDown()) number_->setMixed();
}

void SliderField::setNone(const QString& words) {
  if (slider_->isSliderDown()) return;
  number_->setNone();
  number_->setPlaceholderText(words);
}

}  // namespace idap
