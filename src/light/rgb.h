// Light and reflectance in linear RGB with the sRGB (Rec. 709) primaries. Photometric throughout: a
// radiance's luminance() is in cd/m2, an irradiance's in lux.
#pragma once

#include "geometry/vec.h"

namespace idap {

using Rgb = Vec3f;  // x red, y green, z blue; linear

inline float luminance(Rgb c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
inline float maxComponent(Rgb c) { return std::fmax(c.x, std::fmax(c.y, c.z)); }

// sRGB transfer curve, one channel, 0..1 (IEC 61966-2-1).
inline float srgbToLinear(float v) {
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}
inline float linearToSrgb(float v) {
  return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
}

}  // namespace idap
