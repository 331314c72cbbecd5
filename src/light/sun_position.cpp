#include "light/sun_position.h"

#include <libnova/dynamical_time.h>
#include <libnova/ln_types.h>
#include <libnova/nutation.h>
#include <libnova/sidereal_time.h>
#include <libnova/solar.h>

#include <cmath>

namespace idap {

namespace {

constexpr double kDegree = kPi / 180;
constexpr double kUnixEpoch = 2440587.5;  // Julian day
constexpr double kMsPerDay = 86'400'000.0;
constexpr double kParallax = 8.794 / 3600 * kDegree;  // at one astronomical unit

double julianDay(std::int64_t utc) { return kUnixEpoch + static_cast<double>(utc) / kMsPerDay; }

// The sun's apparent place for the equinox of date. libnova's longitude counts from the equinox of 2000;
// precession, nutation and aberration are added here. @cite meeus1998
struct Place {
  double rightAscension, declination;  // radians
};

Place apparentPlace(double day) {
  constexpr double kArcSecond = kDegree / 3600;
  const double dynamicalDay = ln_get_jde(day);
  ln_helio_posn sun{};
  ln_get_solar_geom_coords(dynamicalDay, &sun);
  ln_nutation nutation{};
  ln_get_nutation(dynamicalDay, &nutation);
  const double t = (dynamicalDay - 2451545.0) / 36525;
  const double precession = (5029.0966 * t + 1.11113 * t * t) * kArcSecond;
  const double aberration = -20.4898 * kArcSecond / sun.R;
  const double longitude = sun.L * kDegree + precession + nutation.longitude * kDegree + aberration;
  const double obliquity = (nutation.ecliptic + nutation.obliquity) * kDegree;
  // The sun leaves the ecliptic of date by a second of arc at most.
  return {std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude)),
          std::asin(std::sin(obliquity) * std::sin(longitude))};
}

SunPosition airless(double latitude, double longitude, std::int64_t utc) {
  const double day = julianDay(utc);
  const auto [rightAscension, declination] = apparentPlace(day);
  const double siderealTime = ln_get_apparent_sidereal_time(day) * 15 * kDegree;  // hours -> radians
  const double hourAngle = siderealTime + longitude - rightAscension;
  const double sinAltitude = std::sin(latitude) * std::sin(declination) +
                             std::cos(latitude) * std::cos(declination) * std::cos(hourAngle);
  SunPosition sun;
  sun.altitude = std::asin(std::fmin(std::fmax(sinAltitude, -1.0), 1.0));
  sun.altitude -= kParallax * std::cos(sun.altitude);
  const double east = -std::cos(declination) * std::sin(hourAngle);
  const double north = std::sin(declination) * std::cos(latitude) -
                       std::cos(declination) * std::sin(latitude) * std::cos(hourAngle);
  sun.azimuth = std::atan2(east, north);
  if (sun.azimuth < 0) sun.azimuth += 2 * kPi;
  return sun;
}

}  // namespace

SunPosition sunPosition(double latitude, double longitude, std::int64_t utc, double pressure,
                        double temperature) {
  SunPosition sun = airless(latitude, longitude, utc);
  // Of what is well below the horizon no light arrives straight; the formula means nothing there. @cite
  // meeus1998
  const double degrees = sun.altitude / kDegree;
  if (pressure > 0 && degrees > -1) {
    const double minutes = 1.02 / std::tan((degrees + 10.3 / (degrees + 5.11)) * kDegree);
    sun.altitude += std::fmax(minutes, 0.0) / 60 * kDegree * pressure / 1010 * 283 / (273 + temperature);
  }
  return sun;
}

Vec3f sunDirection(const SunPosition& sun, double north) {
  const double angle = kPi / 2 + north - sun.azimuth;  // counter-clockwise from +x
  return toFloat(Vec3{std::cos(sun.altitude) * std::cos(angle), std::cos(sun.altitude) * std::sin(angle),
                      std::sin(sun.altitude)});
}

SunTimes sunTimes(double latitude, double longitude, std::int64_t dayStart) {
  // The usual convention: the centre 50 arc minutes below the horizon, 34 for refraction and 16 for the disc.
  constexpr double kEdge = -50.0 / 60 * kDegree;
  constexpr std::int64_t kDay = 86'400'000, kStep = 600'000;
  const auto height = [&](std::int64_t t) { return airless(latitude, longitude, t).altitude - kEdge; };
  SunTimes times;
  double before = height(dayStart);
  for (std::int64_t t = dayStart; t < dayStart + kDay; t += kStep) {
    const double after = height(t + kStep);
    if ((before < 0) != (after < 0)) {
      std::int64_t low = t, high = t + kStep;
      while (high - low > 100) {
        const std::int64_t middle = low + (high - low) / 2;
        ((height(middle) < 0) == (before < 0) ? low : high) = middle;
      }
      std::optional<std::int64_t>& found = before < 0 ? times.sunrise : times.sunset;
      if (!found) found = low;
    }
    before = after;
  }
  return times;
}

}  // namespace idap
