// Between what is printed on a lamp's box (lumens, watts) and what a renderer needs (candela, cd/m2).
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/vec.h"

namespace idap {

// lm/W of lamps by kind, for when only the power is known: typical shop values of household lamps.
inline constexpr double kEfficacyIncandescent = 13.4;  // 60 W: 806 lm
inline constexpr double kEfficacyHalogen = 18;
inline constexpr double kEfficacyFluorescent = 65;
inline constexpr double kEfficacyLed = 100;
// lm/W of daylight, to turn irradiance measured or forecast in W/m2 into lux. @cite littlefair1985efficacy
inline constexpr double kEfficacySunlight = 105;
inline constexpr double kEfficacyClearSky = 130;
inline constexpr double kEfficacyOvercastSky = 115;

// Intensity in cd of a lamp of so many lumens:
inline double isotropicIntensity(double lumens) { return lumens / (4 * kPi); }
// ... along the axis of one whose intensity falls with the cosine (a flat shining disc);
inline double lambertianIntensity(double lumens) { return lumens / kPi; }

// ... along the axis of a spot whose intensity falls as a power of the cosine, to one half at half the beam
// angle (the full angle, radians).
inline double spotExponent(double beamAngle) {
  const double c = std::cos(std::clamp(beamAngle, 0.02, kPi - 0.02) / 2);
  return std::log(0.5) / std::log(c);
}
inline double spotIntensity(double lumens, double beamAngle) {
  return lumens * (spotExponent(beamAngle) + 1) / (2 * kPi);
}

// Luminance in cd/m2 of a surface that sends lumens evenly (Lambertian) from an area in m2, all its sides
// counted.
inline double surfaceLuminance(double lumens, double area) { return area > 0 ? lumens / (kPi * area) : 0; }

// Lux on a surface in so many metres, tilted away by an angle with this cosine.
inline double illuminance(double candela, double metres, double cosine = 1) {
  return candela * std::max(cosine, 0.0) / (metres * metres);
}

}  // namespace idap
