#include "light/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>

#include "light/civil_time.h"

namespace idap {
namespace {

constexpr double kDegree = kPi / 180;
// The worked example of NREL's Solar Position Algorithm.
constexpr double kLatitude = 39.742476 * kDegree, kLongitude = -105.1786 * kDegree;
const std::int64_t kUtc = utcFromCivil({2003, 10, 17, 19, 30, 30}, "UTC");

TEST(SunPosition, MatchesNrelsExample) {
  const SunPosition sun = sunPosition(kLatitude, kLongitude, kUtc, 820, 11);
  EXPECT_NEAR(90 - sun.altitude / kDegree, 50.1116, 0.01);
  EXPECT_NEAR(sun.azimuth / kDegree, 194.3402, 0.01);
}

TEST(SunPosition, RisesAndSetsAsInNrelsExample) {
  const std::int64_t midnight = utcFromCivil({2003, 10, 17, 7, 0, 0}, "UTC");  // UTC-7
  const std::int64_t dayBefore = midnight - 24 * 3'600'000;
  const auto seconds = [](int h, int m, int s) { return h * 3600.0 + m * 60.0 + s; };
  const std::optional<std::int64_t> sunrise = sunTimes(kLatitude, kLongitude, midnight).sunrise;
  // SPA wraps its times into the day of Greenwich, so the sunset it prints is the evening before.
  const std::optional<std::int64_t> sunset = sunTimes(kLatitude, kLongitude, dayBefore).sunset;
  ASSERT_TRUE(sunrise && sunset);
  EXPECT_NEAR(static_cast<double>(*sunrise - midnight) / 1000, seconds(6, 12, 43), 5);
  EXPECT_NEAR(static_cast<double>(*sunset - dayBefore) / 1000, seconds(17, 20, 19), 5);
}

TEST(SunPosition, MidsummerHasNoSunsetInTheFarNorthAndMidwinterNoSunrise) {
  const double north = 75 * kDegree;
  const SunTimes summer = sunTimes(north, 0, utcFromCivil({2024, 6, 21}, "UTC"));
  EXPECT_FALSE(summer.sunrise || summer.sunset);
  EXPECT_GT(sunPosition(north, 0, utcFromCivil({2024, 6, 21}, "UTC")).altitude, 0);
  EXPECT_LT(sunPosition(north, 0, utcFromCivil({2024, 12, 21, 12}, "UTC")).altitude, 0);
}

TEST(SunPosition, StandsInTheNorthAtNoonInTheSouth) {
  const SunPosition sun =
      sunPosition(-33.9 * kDegree, 151.2 * kDegree, utcFromCivil({2024, 3, 1, 13}, "Australia/Sydney"));
  EXPECT_LT(std::fabs(std::remainder(sun.azimuth, 2 * kPi)), 5 * kDegree);
}

TEST(SunPosition, RefractionLiftsTheLowSunByHalfADegree) {
  const std::int64_t sunset = *sunTimes(kLatitude, kLongitude, kUtc - 12 * 3'600'000).sunset;
  const double airless = sunPosition(kLatitude, kLongitude, sunset, 0).altitude;
  const double seen = sunPosition(kLatitude, kLongitude, sunset).altitude;
  EXPECT_NEAR((seen - airless) / kDegree, 0.6, 0.15);
}

TEST(SunPosition, DirectionTurnsWithThePlansNorth) {
  const SunPosition east{kPi / 2, 0};
  const Vec3f d = sunDirection(east, 0);
  EXPECT_NEAR(d.x, 1, 1e-6);
  EXPECT_NEAR(d.y, 0, 1e-6);
  // True north along the plan's -x: then east is along +y.
  const Vec3f turned = sunDirection(east, kPi / 2);
  EXPECT_NEAR(turned.y, 1, 1e-6);
  const Vec3f high = sunDirection({0, kPi / 6}, 0);
  EXPECT_NEAR(high.y, std::cos(kPi / 6), 1e-6);
  EXPECT_NEAR(high.z, 0.5, 1e-6);
}

}  // namespace
}  // namespace idap
