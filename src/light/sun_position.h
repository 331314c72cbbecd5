// Where the sun stands at a place and time, by libnova's VSOP87 theory, with parallax and
// refraction. Within 0.01 degrees of NREL's SPA @cite reda2004spa for some centuries around now.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/vec.h"

namespace idap {

struct SunPosition {
  double azimuth = 0;   // radians clockwise from true north: east is pi / 2; 0 <= azimuth < 2 pi
  double altitude = 0;  // radians above the horizon, as seen through the air
};

// latitude, longitude: radians, north and east positive. utc: milliseconds since 1970. pressure in mbar and
// temperature in degrees Celsius set the refraction; pressure 0 turns it off.
SunPosition sunPosition(double latitude, double longitude, std::int64_t utc, double pressure = 1010,
                        double temperature = 10);

// Unit vector towards the sun in a plan, z up. north: radians counter-clockwise from the plan's +y to true
// north, as in model/site.h.
Vec3f sunDirection(const SunPosition& sun, double north);

// The sun's upper edge touching a flat horizon, milliseconds since 1970, in the 24 hours that start at
// dayStart (the local midnight, say). None where it does not rise or set then.
struct SunTimes {
  std::optional<std::int64_t> sunrise, sunset;
};
SunTimes sunTimes(double latitude, double longitude, std::int64_t dayStart);

}  // namespace idap
