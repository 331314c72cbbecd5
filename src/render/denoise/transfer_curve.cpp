#include "render/denoise/transfer_curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace idap::render {

namespace {

constexpr double kA = 1.41283765e+03, kB = 1.64593172e+00, kC = 4.31384981e-01, kD = -2.94139609e-03;
constexpr double kE = 1.92653254e-01, kF = 6.26026094e-03, kG = 9.98620152e-01;
constexpr double kY0 = 1.57945760e-06, kY1 = 3.22087631e-02, kX0 = 2.23151711e-03, kX1 = 3.70974749e-01;
constexpr float kMaxLinear = 65504;

double exactForward(double y) {
  if (y <= kY0) return kA * y;
  if (y <= kY1) return kB * std::pow(y, kC) + kD;
  return kE * std::log(y + kF) + kG;
}

double exactInverse(double x) {
  if (x <= kX0) return x / kA;
  if (x <= kX1) return std::pow((x - kD) / kB, 1 / kC);
  return std::exp((x - kG) / kE) - kF;
}

// The forward table has 256 entries an octave, addressed by the bits of the float.
constexpr int kShift = 23 - 8;
constexpr float kSmallest = 0x1p-30f;
constexpr std::uint32_t kFirst = std::bit_cast<std::uint32_t>(kSmallest) >> kShift;
constexpr std::uint32_t kLast = (std::bit_cast<std::uint32_t>(kMaxLinear) >> kShift) + 1;
constexpr int kInverseSteps = 16384;

}  // namespace

TransferCurve::TransferCurve() {
  const double scale = 1 / exactForward(kMaxLinear);
  for (std::uint32_t i = kFirst; i <= kLast; ++i) {
    forward_.push_back(static_cast<float>(scale * exactForward(std::bit_cast<float>(i << kShift))));
  }
  for (int i = 0; i <= kInverseSteps + 1; ++i) {
    inverse_.push_back(static_cast<float>(exactInverse(i / (scale * kInverseSteps))));
  }
}

float TransferCurve::forward(float linear) const {
  if (!(linear > kSmallest)) return 0;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(std::min(linear, kMaxLinear));
  const std::size_t i = (bits >> kShift) - kFirst;
  const float t = static_cast<float>(bits & ((1u << kShift) - 1)) * (1.0f / (1u << kShift));
  return forward_[i] + t * (forward_[i + 1] - forward_[i]);
}

float TransferCurve::inverse(float encoded) const {
  if (!(encoded > 0)) return 0;
  const float at = std::min(encoded, 1.0f) * kInverseSteps;
  const auto i = static_cast<std::size_t>(at);
  return inverse_[i] + (at - static_cast<float>(i)) * (inverse_[i + 1] - inverse_[i]);
}

}  // namespace idap::render
