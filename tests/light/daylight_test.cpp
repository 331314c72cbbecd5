#include "light/daylight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "light/atmosphere.h"

namespace idap {
namespace {

Daylight at(double altitude, Weather weather = Weather::Clear, double azimuth = 0) {
  const double a = altitude * kPi / 180;
  DaylightConditions c;
  c.sunDirection =
      toFloat(Vec3{std::cos(a) * std::cos(azimuth), std::cos(a) * std::sin(azimuth), std::sin(a)});
  c.weather = weather;
  return daylightFor(c, 128, 64);
}

float zenith(const Daylight& d) { return luminance(d.skyRadiance[0]); }

TEST(Daylight, OutsideTheAirTheSunGivesAHundredAndThirtyKilolux) {
  Bands all;
  all.v.fill(1);
  EXPECT_NEAR(sunlight(all).y, 133'000, 4'000);
}

TEST(Daylight, AClearNoon) {
  const Daylight d = at(55);
  EXPECT_GT(luminance(d.sunIlluminance), 90'000);
  EXPECT_LT(luminance(d.sunIlluminance), 105'000);
  EXPECT_GT(luminance(d.skyIlluminance), 10'000);
  EXPECT_LT(luminance(d.skyIlluminance), 20'000);
  EXPECT_GT(zenith(d), 2'500);
  EXPECT_LT(zenith(d), 6'000);
  EXPECT_GT(d.skyRadiance[0].z, 1.3f * d.skyRadiance[0].x) << "the sky is blue";
}

TEST(Daylight, AnOvercastNoon) {
  const Daylight d = at(55, Weather::Overcast);
  EXPECT_EQ(luminance(d.sunIlluminance), 0);
  EXPECT_GT(luminance(d.skyIlluminance), 10'000);
  EXPECT_LT(luminance(d.skyIlluminance), 25'000);
  EXPECT_NEAR(luminance(d.skyIlluminance) / zenith(d), 7 * kPi / 9, 0.05);
  EXPECT_NEAR(d.skyRadiance[0].z / d.skyRadiance[0].x, 1, 0.15) << "clouds are grey";
}

TEST(Daylight, OvercastFollowsTheMeasuredFitWithinAThird) {
  for (double altitude : {10.0, 20.0, 35.0, 50.0, 65.0}) {
    const double fit = 300 + 21'000 * std::sin(altitude * kPi / 180);
    EXPECT_NEAR(luminance(at(altitude, Weather::Overcast).skyIlluminance) / fit, 1, 0.36) << altitude;
  }
}

TEST(Daylight, PartlyCloudyLiesBetween) {
  const Daylight clear = at(40), partly = at(40, Weather::Partly);
  EXPECT_LT(luminance(partly.sunIlluminance), luminance(clear.sunIlluminance));
  EXPECT_GT(luminance(partly.sunIlluminance), 0.5f * luminance(clear.sunIlluminance));
  EXPECT_GT(luminance(partly.skyIlluminance), luminance(clear.skyIlluminance));
}

TEST(Daylight, TheLowSunIsRedAndWeak) {
  const Rgb low = at(4).sunIlluminance, high = at(60).sunIlluminance;
  EXPECT_LT(luminance(low), 0.2f * luminance(high));
  EXPECT_GT(low.x / low.z, 4 * high.x / high.z);
}

TEST(Daylight, LightFadesSteadilyIntoTheNight) {
  float last = 1e9f;
  for (double altitude : {20.0, 10.0, 5.0, 2.0, 0.0, -2.0, -4.0, -6.0, -9.0, -12.0, -18.0, -40.0}) {
    const Daylight d = at(altitude);
    const float e =
        luminance(d.skyIlluminance) +
        luminance(d.sunIlluminance) * static_cast<float>(std::sin(std::max(altitude, 0.0) * kPi / 180));
    EXPECT_LE(e, last) << altitude;
    last = e;
  }
  // A moonless night near a town.
  EXPECT_GT(last, 0.0005f);
  EXPECT_LT(last, 0.05f);
  EXPECT_EQ(luminance(at(-5).sunIlluminance), 0);
  const float sunset = luminance(at(-0.8).skyIlluminance);
  EXPECT_GT(sunset, 200);
  EXPECT_LT(sunset, 1000);
}

TEST(Daylight, TheSkyIsBrightestAroundTheSun) {
  const Daylight d = at(30, Weather::Clear, kPi / 2);
  std::size_t brightest = 0;
  for (std::size_t i = 0; i < d.skyRadiance.size(); ++i) {
    if (luminance(d.skyRadiance[i]) > luminance(d.skyRadiance[brightest])) brightest = i;
  }
  // Row 0 is the zenith; a quarter of the way round from +X is +Y.
  EXPECT_NEAR(static_cast<double>(brightest / 128), 64 * 60.0 / 180, 1.5);
  EXPECT_NEAR(static_cast<double>(brightest % 128), 32, 1.5);
}

TEST(Daylight, TheGroundSendsBackItsShareOfTheLight) {
  DaylightConditions c;
  c.sunDirection = {0, 0.6f, 0.8f};
  c.groundAlbedo = 0.5f;
  const Daylight d = daylightFor(c, 64, 32);
  const float expected =
      0.5f * (luminance(d.skyIlluminance) + 0.8f * luminance(d.sunIlluminance)) / static_cast<float>(kPi);
  EXPECT_NEAR(luminance(d.skyRadiance.back()) / expected, 1, 0.01);
}

TEST(Daylight, SkyIlluminanceIsThatOfTheTable) {
  const Daylight d = at(25);
  double sum = 0;
  for (int y = 0; y < 32; ++y) {
    const double top = std::cos(kPi * y / 64), bottom = std::cos(kPi * (y + 1) / 64);
    for (int x = 0; x < 128; ++x) {
      sum += static_cast<double>(luminance(d.skyRadiance[static_cast<std::size_t>(y * 128 + x)])) * kPi /
             128 * (top * top - bottom * bottom);
    }
  }
  EXPECT_NEAR(sum / static_cast<double>(luminance(d.skyIlluminance)), 1, 1e-3);
}

TEST(Daylight, HazeDimsTheSunAndBrightensTheSky) {
  DaylightConditions c;
  c.sunDirection = {0.6f, 0, 0.8f};
  c.turbidity = 2;
  const Daylight clean = daylightFor(c, 64, 32);
  c.turbidity = 5;
  const Daylight hazy = daylightFor(c, 64, 32);
  EXPECT_LT(luminance(hazy.sunIlluminance), luminance(clean.sunIlluminance));
  EXPECT_GT(luminance(hazy.skyIlluminance), luminance(clean.skyIlluminance));
}

TEST(Daylight, EverythingIsFiniteAndRefusesNonsense) {
  for (double altitude : {-90.0, -18.0, -0.3, 0.0, 0.1, 90.0}) {
    for (const Rgb& c : at(altitude).skyRadiance) {
      ASSERT_TRUE(isFinite(toDouble(c)));
      ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0f);
    }
  }
  DaylightConditions c;
  EXPECT_THROW(daylightFor(c, 2, 2), Error);
  EXPECT_THROW(daylightFor(c, 64, 33), Error);
  c.sunDirection = {0, 0, 0};
  EXPECT_THROW(daylightFor(c), Error);
}

}  // namespace
}  // namespace idap
