#include <gtest/gtest.h>

#include <cmath>

#include "light/color_temperature.h"
#include "light/spectrum.h"

namespace idap {
namespace {

// CIE 1931 chromaticity of a linear Rec. 709 colour.
Vec2 chromaticity(Rgb c) {
  const Vec3 d = toDouble(c);
  const Vec3 xyz{0.4123908 * d.x + 0.3575843 * d.y + 0.1804808 * d.z,
                 0.2126390 * d.x + 0.7151687 * d.y + 0.0721923 * d.z,
                 0.0193308 * d.x + 0.1191948 * d.y + 0.9505322 * d.z};
  const double sum = xyz.x + xyz.y + xyz.z;
  return {xyz.x / sum, xyz.y / sum};
}

TEST(ColorTemperature, KeepsTheLuminance) {
  for (double t : {900.0, 1850.0, 2700.0, 4000.0, 4600.0, 6500.0, 20000.0, 1e9, double{NAN}}) {
    EXPECT_NEAR(luminance(rgbFromTemperature(t)), 1, 1e-4) << t;
  }
}

TEST(ColorTemperature, DaylightOf6504KIsTheDisplaysWhite) {
  const Rgb white = rgbFromTemperature(6504);
  EXPECT_NEAR(white.x, 1, 0.005);
  EXPECT_NEAR(white.y, 1, 0.005);
  EXPECT_NEAR(white.z, 1, 0.005);
}

TEST(ColorTemperature, LampsLieOnThePlanckianLocus) {
  // Published chromaticities: CIE illuminant A (2856 K), and 4000 K.
  EXPECT_NEAR(chromaticity(rgbFromTemperature(2856)).x, 0.4476, 0.002);
  EXPECT_NEAR(chromaticity(rgbFromTemperature(2856)).y, 0.4074, 0.002);
  EXPECT_NEAR(chromaticity(rgbFromTemperature(4000)).x, 0.3805, 0.002);
  EXPECT_NEAR(chromaticity(rgbFromTemperature(4000)).y, 0.3768, 0.002);
}

TEST(ColorTemperature, DaylightFollowsTheCieLocus) {
  EXPECT_NEAR(chromaticity(rgbFromTemperature(5000)).x, 0.3457, 0.001);
  EXPECT_NEAR(chromaticity(rgbFromTemperature(5000)).y, 0.3587, 0.001);
  EXPECT_NEAR(chromaticity(rgbFromTemperature(7500)).x, 0.2990, 0.001);
}

TEST(ColorTemperature, GetsBluerWithoutJumps) {
  float last = rgbFromTemperature(1500).z / rgbFromTemperature(1500).x;
  for (double t = 1520; t < 12000; t += 20) {
    const Rgb c = rgbFromTemperature(t);
    EXPECT_GE(c.z / c.x, last) << t;
    EXPECT_LT(c.z / c.x, last + 0.02f) << t;
    last = c.z / c.x;
  }
}

TEST(Spectrum, MatchingFunctionsPeakWhereTheyShould) {
  EXPECT_NEAR(colorMatching(555).y, 1, 0.02);
  EXPECT_NEAR(colorMatching(450).z, 1.772, 0.05);
  EXPECT_NEAR(colorMatching(600).x, 1.0622, 0.03);
}

TEST(Spectrum, ColoursOutsideTheDisplayKeepTheirLuminance) {
  const Rgb red = displayableRgb(colorMatching(650));
  EXPECT_GE(std::min({red.x, red.y, red.z}), 0.0f);
  EXPECT_NEAR(luminance(red), colorMatching(650).y, 1e-5);
}

}  // namespace
}  // namespace idap
