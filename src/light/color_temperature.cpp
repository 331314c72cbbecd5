#include "light/color_temperature.h"

#include <algorithm>
#include <cmath>

#include "light/spectrum.h"

namespace idap {

namespace {

Vec3 fromChromaticity(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// Planck's law over the visible range, Y = 1.
Vec3 blackBody(double kelvin) {
  constexpr double kSecondRadiation = 1.438776877e7;  // nm K
  Vec3 xyz;
  for (double w = 380; w <= 780; w += 5) {
    const double power = std::pow(w / 560, -5) / std::expm1(kSecondRadiation / (w * kelvin));
    xyz += colorMatching(w) * power;
  }
  return xyz / xyz.y;
}

// CIE daylight illuminant, 4000 .. 25000 K, Y = 1.
Vec3 daylight(double kelvin) {
  const double r = 1000 / kelvin;
  const double x = kelvin <= 7000 ? 0.244063 + r * (0.09911 + r * (2.9678 - r * 4.6070))
                                  : 0.237040 + r * (0.24748 + r * (1.9018 - r * 2.0064));
  return fromChromaticity(x, -3 * x * x + 2.870 * x - 0.275);
}

}  // namespace

Rgb rgbFromTemperature(double kelvin) {
  const double t = std::isfinite(kelvin) ? std::clamp(kelvin, 1000.0, 25000.0) : 6500.0;
  const double share = std::clamp((t - 4000) / 1000, 0.0, 1.0);
  Vec3 xyz;
  if (share < 1) xyz += blackBody(t) * (1 - share);
  if (share > 0) xyz += daylight(t) * share;
  return displayableRgb(xyz);
}

}  // namespace idap
