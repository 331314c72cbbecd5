#include "light/cie_sky.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace idap {
namespace {

const Vec3 kZenith{0, 0, 1};
Vec3 at(double elevation, double azimuth = 0) {
  const double e = elevation * kPi / 180, a = azimuth * kPi / 180;
  return {std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

TEST(CieSky, TheTraditionalOvercastSkyGivesSevenNinthsOfPi) {
  EXPECT_NEAR(horizontalIlluminance({16}, kZenith), 7 * kPi / 9, 1e-3);
}

TEST(CieSky, TheZenithIsTheUnit) {
  for (int type = 1; type <= 16; ++type)
    EXPECT_NEAR(relativeLuminance({type}, kZenith, at(40)), 1, 1e-9) << type;
}

TEST(CieSky, OvercastHorizonsAreAThirdAsBright) {
  EXPECT_NEAR(relativeLuminance({16}, at(0), kZenith), 1.0 / 3, 1e-9);
  EXPECT_NEAR(relativeLuminance({1}, at(0.01), kZenith), 1 / (1 + 4 * std::exp(-0.7)), 1e-3);
  EXPECT_NEAR(relativeLuminance({5}, at(10), kZenith), 1, 1e-9);
  EXPECT_NEAR(horizontalIlluminance({5}, kZenith), kPi, 1e-6);
}

TEST(CieSky, ClearSkiesAreBrightestTowardsTheSun) {
  const Vec3 sun = at(30, 90);
  EXPECT_GT(relativeLuminance({12}, at(35, 90), sun), 3 * relativeLuminance({12}, at(35, -90), sun));
}

TEST(CieSky, NothingShinesBelowTheHorizonAndTypesAreChecked) {
  EXPECT_EQ(relativeLuminance({1}, at(-1), kZenith), 0);
  EXPECT_THROW(relativeLuminance({0}, kZenith, kZenith), Error);
  EXPECT_THROW(relativeLuminance({17}, kZenith, kZenith), Error);
}

}  // namespace
}  // namespace idap
