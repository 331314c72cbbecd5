// Maps from the unit square to directions and points, keeping stratification. Densities are per steradian or,
// for the triangle, uniform over its area.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "render/lanes/lane_math.h"

namespace idap::render {

inline constexpr float kPiF = std::numbers::pi_v<float>;
inline constexpr float kOneMinusEpsilon = 0.99999994f;

// Point i of n of the Hammersley set.
inline Vec2f hammersley(int i, int n) {
  auto b = static_cast<std::uint32_t>(i);
  b = (b << 16) | (b >> 16);
  b = ((b & 0x00ff00ffu) << 8) | ((b & 0xff00ff00u) >> 8);
  b = ((b & 0x0f0f0f0fu) << 4) | ((b & 0xf0f0f0f0u) >> 4);
  b = ((b & 0x33333333u) << 2) | ((b & 0xccccccccu) >> 2);
  b = ((b & 0x55555555u) << 1) | ((b & 0xaaaaaaaau) >> 1);
  return {(static_cast<float>(i) + 0.5f) / static_cast<float>(n),
          std::min(static_cast<float>(b) * 0x1p-32f, kOneMinusEpsilon)};
}

// Shirley and Chiu's concentric map.
template <class F>
Vec2T<F> unitDisc(const Vec2T<F>& u) {
  using lane_math::abs;
  const F a = 2.0f * u.x - 1.0f, b = 2.0f * u.y - 1.0f;
  const Mask<F> flat = abs(a) > abs(b);
  const F r = select(flat, a, b), other = select(flat, b, a);
  const F turn = kPiF / 4 * other / select(r == 0.0f, F(1.0f), r);
  F sine, cosine;
  sinCos(turn, sine, cosine);
  return {r * select(flat, cosine, sine), r * select(flat, sine, cosine)};
}

// Around +z, density cos / pi.
template <class F>
Vec3T<F> cosineHemisphere(const Vec2T<F>& u) {
  using namespace lane_math;
  const Vec2T<F> d = unitDisc(u);
  return {d.x, d.y, sqrt(max(1.0f - d.x * d.x - d.y * d.y, 1e-12f))};
}

// Uniform in a cone around +z; oneMinusCos of its half angle, exact for narrow cones. Density 1 / solid
// angle.
template <class F>
Vec3T<F> uniformCone(const Vec2T<F>& u, std::type_identity_t<F> oneMinusCos) {
  using namespace lane_math;
  const F h = u.x * oneMinusCos;
  const F r = sqrt(max(h * (2.0f - h), 0.0f));
  F sine, cosine;
  sinCos(2 * kPiF * u.y, sine, cosine);
  return {r * cosine, r * sine, 1.0f - h};
}
template <class F>
F coneSolidAngle(F oneMinusCos) {
  return 2 * kPiF * oneMinusCos;
}

// Barycentric weights of the second and third corner, uniform over the area (Heitz 2019).
template <class F>
Vec2T<F> uniformTriangle(const Vec2T<F>& u) {
  const Mask<F> above = u.y > u.x;
  const F low = 0.5f * select(above, u.x, u.y);
  return {select(above, low, u.x - low), select(above, u.y - low, low)};
}

}  // namespace idap::render
