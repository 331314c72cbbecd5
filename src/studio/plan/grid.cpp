#include "studio/plan/grid.h"

#include <cmath>

#include "studio/plan/painters.h"

namespace idap {

namespace {

constexpr double kInch = 0.0254;

// 1, 5, 10, 50, … of the unit.
double niceStep(LengthUnit unit, double atLeast, int& rank) {
  if (unit == LengthUnit::FeetInches) {
    constexpr double kSteps[] = {kInch,       6 * kInch,   12 * kInch,   60 * kInch,
                                 120 * kInch, 600 * kInch, 1200 * kInch, 6000 * kInch};
    for (rank = 0; rank < 7; ++rank)
      if (kSteps[rank] >= atLeast) break;
    return kSteps[rank];
  }
  double step = 0.001;
  for (rank = 0; step < atLeast && rank < 16; ++rank) step *= rank % 2 == 0 ? 5 : 2;
  return step;
}

class GridPainter : public Painter {
 public:
  void paint(const Drawing& drawing, Canvas& c) const override {
    if (!drawing.settings.gridShown) return;
    const GridSteps steps = gridSteps(drawing.settings.unit, c.view.scale);
    c.p.save();
    c.p.setRenderHint(QPainter::Antialiasing, false);
    lines(c, steps.fine, steps.strong, c.pen(c.colors.grid));
    lines(c, steps.strong, 0, c.pen(c.colors.gridStrong));
    c.p.restore();
  }

 private:
  // Lines in steps but not where the stronger ones come.
  static void lines(Canvas& c, double step, double except, const QPen& pen) {
    c.p.setPen(pen);
    const auto skipped = [&](double value) {
      return except > 0 && std::abs(std::remainder(value, except)) < step / 4;
    };
    const auto from = std::llround(std::floor(c.area.min.x / step)),
               to = std::llround(std::ceil(c.area.max.x / step));
    for (auto i = from; i <= to; ++i)
      if (const double x = double(i) * step; !skipped(x)) c.line({x, c.area.min.y}, {x, c.area.max.y});
    const auto low = std::llround(std::floor(c.area.min.y / step)),
               high = std::llround(std::ceil(c.area.max.y / step));
    for (auto i = low; i <= high; ++i)
      if (const double y = double(i) * step; !skipped(y)) c.line({c.area.min.x, y}, {c.area.max.x, y});
  }
};

}  // namespace

GridSteps gridSteps(LengthUnit unit, double scale, double pixels) {
  int rank = 0;
  GridSteps steps;
  steps.fine = niceStep(unit, pixels / scale, rank);
  int above = 0;
  steps.strong = niceStep(unit, steps.fine * (unit == LengthUnit::FeetInches ? 1.5 : 9), above);
  return steps;
}

double rulerStep(LengthUnit unit, double scale, double pixels) {
  int rank = 0;
  return niceStep(unit, pixels / scale, rank);
}

std::string rulerNumber(double metres, LengthUnit unit, double step) {
  if (std::abs(metres) < step / 1e3) metres = 0;
  switch (unit) {
    case LengthUnit::FeetInches: {
      const auto inches = std::llround(metres / kInch);
      if (inches % 12 == 0) return std::to_string(inches / 12) + "'";
      return std::to_string(inches) + "\"";
    }
    case LengthUnit::Millimetre:
      return std::to_string(std::llround(metres * 1000));
    case LengthUnit::Centimetre:
      if (step >= 0.01) return std::to_string(std::llround(metres * 100));
      break;
    case LengthUnit::Metre:
      break;
  }
  std::string number = formatLength(metres, unit, 3);
  return number.substr(0, number.find(' '));
}

const Painter& gridPainter() {
  static const GridPainter painter;
  return painter;
}

}  // namespace idap
