// Sun and sky over a home as light in real units, for any height of the sun and three kinds of weather.
// Cloudless skies are computed from the physics of the air (light/atmosphere.h); takes some milliseconds.
#pragma once

#include <vector>

#include "light/rgb.h"

namespace idap {

enum class Weather { Clear, Partly, Overcast };

struct DaylightConditions {
  Vec3f sunDirection{0, 0, 1};  // unit, towards the sun, z up
  Weather weather = Weather::Clear;
  float turbidity = 2.2f;     // haze: 1 none, 2 very clear, 3 usual, 6 hazy
  float groundAlbedo = 0.2f;  // of what lies outside: 0.2 grass and stone, 0.7 snow
  float cityGlow = 0.001f;    // cd/m2 at the zenith by night; 0 far from towns
  friend bool operator==(const DaylightConditions&, const DaylightConditions&) = default;
};

struct Daylight {
  Vec3f sunDirection{0, 0, 1};
  Rgb sunIlluminance;  // lux on a surface that faces the sun; 0 below the horizon
  Rgb skyIlluminance;  // lux on level ground, without the sun
  int width = 0, height = 0;
  std::vector<Rgb>
      skyRadiance;  // cd/m2. Row 0 is the zenith, the last row the nadir (the lit ground); column c looks
                    // along azimuth 2 pi (c + 0.5) / width from +X towards +Y, as in render/scene.h
};

// height: even, so that the horizon lies between two rows. Throws Error for a size under 4 or a direction
// that is none.
Daylight daylightFor(const DaylightConditions& conditions, int width = 256, int height = 128);

}  // namespace idap
