#include "light/photometry.h"

#include <gtest/gtest.h>

#include "light/glass.h"

namespace idap {
namespace {

TEST(Photometry, ABulbOfSixtyWattsShinesSixtyFourCandela) {
  EXPECT_NEAR(isotropicIntensity(kEfficacyIncandescent * 60), 64, 0.5);
}

TEST(Photometry, ACosineLampOfOneKilocandelaLightsTheFloorBelow) {
  // CIE 171 case 5.2: 1000 cd, 3 m up.
  EXPECT_NEAR(illuminance(lambertianIntensity(1000 * kPi), 3), 111.11, 0.01);
}

TEST(Photometry, ASpotsIntensityAddsUpToItsLumens) {
  for (double beam : {0.2, 0.6, 1.2, 2.0}) {
    const double n = spotExponent(beam);
    EXPECT_NEAR(std::pow(std::cos(beam / 2), n), 0.5, 1e-9);
    double lumens = 0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) lumens += 2 * kPi * std::pow((i + 0.5) / kSteps, n) / kSteps;
    EXPECT_NEAR(lumens * spotIntensity(500, beam), 500, 1) << beam;
  }
}

TEST(Photometry, APanelOfLumens) { EXPECT_NEAR(surfaceLuminance(3600, 0.36), 3183, 1); }

TEST(Glass, AClearPaneLetsThroughWhatFresnelSays) {
  const auto at = [](double degrees) {
    return paneOptics(static_cast<float>(std::cos(degrees * kPi / 180)));
  };
  EXPECT_NEAR(at(0).transmittance, 0.9183, 2e-4);
  EXPECT_NEAR(at(60).transmittance, 0.8435, 2e-4);
  EXPECT_NEAR(at(75).transmittance, 0.6148, 2e-4);
}

TEST(Glass, ClearGlassKeepsAllLight) {
  for (float c = 0; c <= 1; c += 0.05f) {
    const PaneOptics pane = paneOptics(c);
    EXPECT_NEAR(pane.transmittance + pane.reflectance, 1, 1e-4) << c;
  }
  EXPECT_NEAR(paneOptics(0).reflectance, 1, 1e-4);
}

TEST(Glass, TintedGlassTakesTheMoreTheLongerTheWay) {
  const PaneOptics straight = paneOptics(1, 1.52f, 0.5f), slanted = paneOptics(0.5f, 1.52f, 0.5f);
  EXPECT_NEAR(straight.transmittance, 0.5 * 0.9183, 0.005);
  EXPECT_LT(slanted.transmittance, 0.5f * paneOptics(0.5f).transmittance);
}

TEST(Glass, DiffuseLightLosesMoreThanStraightLight) {
  EXPECT_NEAR(diffusePaneOptics().transmittance, 0.84, 0.01);
}

}  // namespace
}  // namespace idap
