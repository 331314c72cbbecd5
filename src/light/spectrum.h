// The eye's response to wavelengths, and from there to linear RGB.
#pragma once

#include "light/rgb.h"

namespace idap {

// CIE 1931 colour matching functions (x, y, z) at a wavelength in nm, by a multi-lobe fit. @cite wyman2013cie
Vec3 colorMatching(double nanometres);

// CIE XYZ -> linear Rec. 709, unclipped. Y = 1 of D65 white gives (1, 1, 1).
Vec3 rgbFromXyz(Vec3 xyz);

// The same with what the primaries cannot show pulled in: negative channels become 0, the luminance is kept.
Rgb displayableRgb(Vec3 xyz);

// Luminous efficacy of monochromatic radiation at 555 nm, lm/W.
inline constexpr double kMaxEfficacy = 683.002;

}  // namespace idap
