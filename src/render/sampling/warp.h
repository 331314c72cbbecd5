// Maps from the unit square to directions and points, keeping stratification. Densities are per steradian or,
// for the triangle, uniform over its area.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "geometry/vec.h"

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
inline Vec2f unitDisc(Vec2f u) {
  const float a = 2 * u.x - 1, b = 2 * u.y - 1;
  if (a == 0 && b == 0) return {};
  float r, phi;
  if (std::fabs(a) > std::fabs(b)) {
    r = a;
    phi = kPiF / 4 * (b / a);
  } else {
    r = b;
    phi = kPiF / 2 - kPiF / 4 * (a / b);
  }
  return {r * std::cos(phi), r * std::sin(phi)};
}

// Around +z, density cos / pi.
inline Vec3f cosineHemisphere(Vec2f u) {
  const Vec2f d = unitDisc(u);
  return {d.x, d.y, std::sqrt(std::max(1e-12f, 1 - d.x * d.x - d.y * d.y))};
}

// Uniform in a cone around +z; oneMinusCos of its half angle, exact for narrow cones. Density 1 / solid
// angle.
inline Vec3f uniformCone(Vec2f u, float oneMinusCos) {
  const float h = u.x * oneMinusCos;
  const float r = std::sqrt(std::max(0.0f, h * (2 - h)));
  const float phi = 2 * kPiF * u.y;
  return {r * std::cos(phi), r * std::sin(phi), 1 - h};
}
inline float coneSolidAngle(float oneMinusCos) { return 2 * kPiF * oneMinusCos; }

// Barycentric weights of the second and third corner, uniform over the area (Heitz 2019).
inline Vec2f uniformTriangle(Vec2f u) {
  if (u.y > u.x) {
    const float x = u.x * 0.5f;
    return {x, u.y - x};
  }
  const float y = u.y * 0.5f;
  return {u.x - y, y};
}

}  // namespace idap::render
