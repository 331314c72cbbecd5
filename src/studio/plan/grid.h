// Steps of rulers and grids: round numbers in the user's unit, as fine as can be told apart.
#pragma once

#include <string>

#include "base/units.h"

namespace idap {

struct GridSteps {
  double fine = 0.1, strong = 1;  // m
};
// The finest steps that leave so many pixels between two lines, at so many pixels a metre.
GridSteps gridSteps(LengthUnit unit, double scale, double pixels = 9);

// A ruler's step that leaves room for its numbers, and a number: "3", "250", "12'".
double rulerStep(LengthUnit unit, double scale, double pixels);
std::string rulerNumber(double metres, LengthUnit unit, double step);

}  // namespace idap
