#include "light/cie_sky.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace idap {

namespace {

// a, b shape the fall from zenith to horizon; c, d, e the brightening around the sun.
struct Shape {
  double a, b, c, d, e;
};
constexpr Shape kShapes[15] = {
    {4.0, -0.70, 0, -1.0, 0},      {4.0, -0.70, 2, -1.5, 0.15},   {1.1, -0.80, 0, -1.0, 0},
    {1.1, -0.80, 2, -1.5, 0.15},   {0.0, -1.00, 0, -1.0, 0},      {0.0, -1.00, 2, -1.5, 0.15},
    {0.0, -1.00, 5, -2.5, 0.30},   {0.0, -1.00, 10, -3.0, 0.45},  {-1.0, -0.55, 2, -1.5, 0.15},
    {-1.0, -0.55, 5, -2.5, 0.30},  {-1.0, -0.55, 10, -3.0, 0.45}, {-1.0, -0.32, 10, -3.0, 0.45},
    {-1.0, -0.32, 16, -3.0, 0.30}, {-1.0, -0.15, 16, -3.0, 0.30}, {-1.0, -0.15, 24, -2.8, 0.15},
};

double gradation(const Shape& s, double cosZenith) {
  return cosZenith > 0 ? 1 + s.a * std::exp(s.b / cosZenith) : 1;
}

double indicatrix(const Shape& s, double cosine) {
  const double c = std::clamp(cosine, -1.0, 1.0);
  return 1 + s.c * (std::exp(s.d * std::acos(c)) - std::exp(s.d * kPi / 2)) + s.e * c * c;
}

}  // namespace

double relativeLuminance(CieSky sky, Vec3 direction, Vec3 sun) {
  if (sky.type < 1 || sky.type > 16) throw Error("CIE skies are numbered 1 to 16");
  if (direction.z < 0) return 0;
  if (sky.type == 16) return (1 + 2 * direction.z) / 3;
  const Shape& s = kShapes[sky.type - 1];
  return indicatrix(s, dot(direction, sun)) * gradation(s, direction.z) /
         (indicatrix(s, sun.z) * gradation(s, 1));
}

double horizontalIlluminance(CieSky sky, Vec3 sun) {
  constexpr int kRings = 90, kSteps = 180;
  double sum = 0;
  for (int i = 0; i < kRings; ++i) {
    // Rings of equal projected solid angle.
    const double cosZenith = std::sqrt((i + 0.5) / kRings), sinZenith = std::sqrt(1 - cosZenith * cosZenith);
    for (int j = 0; j < kSteps; ++j) {
      const double azimuth = 2 * kPi * (j + 0.5) / kSteps;
      sum += relativeLuminance(sky, {sinZenith * std::cos(azimuth), sinZenith * std::sin(azimuth), cosZenith},
                               sun);
    }
  }
  return kPi * sum / (kRings * kSteps);
}

}  // namespace idap
