#include "light/spectrum.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

// A bell with another width on each side of its middle.
double lobe(double x, double height, double middle, double left, double right) {
  const double t = (x - middle) * (x < middle ? left : right);
  return height * std::exp(-0.5 * t * t);
}

}  // namespace

Vec3 colorMatching(double w) {
  return {lobe(w, 0.362, 442.0, 0.0624, 0.0374) + lobe(w, 1.056, 599.8, 0.0264, 0.0323) +
              lobe(w, -0.065, 501.1, 0.0490, 0.0382),
          lobe(w, 0.821, 568.8, 0.0213, 0.0247) + lobe(w, 0.286, 530.9, 0.0613, 0.0322),
          lobe(w, 1.217, 437.0, 0.0845, 0.0278) + lobe(w, 0.681, 459.0, 0.0385, 0.0725)};
}

Vec3 rgbFromXyz(Vec3 c) {
  return {3.2409699 * c.x - 1.5373832 * c.y - 0.4986108 * c.z,
          -0.9692436 * c.x + 1.8759675 * c.y + 0.0415551 * c.z,
          0.0556301 * c.x - 0.2039770 * c.y + 1.0569715 * c.z};
}

Rgb displayableRgb(Vec3 xyz) {
  const Vec3 c = rgbFromXyz(xyz);
  const Rgb clipped = toFloat(Vec3{std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0)});
  const float l = luminance(clipped);
  return l > 0 ? clipped * (static_cast<float>(std::max(xyz.y, 0.0)) / l) : Rgb{};
}

}  // namespace idap
