#include "render/film/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace idap::render {
namespace {

constexpr ToneMap kAll[] = {ToneMap::PbrNeutral, ToneMap::AgX, ToneMap::Classic, ToneMap::Linear};

TEST(ToneMap, AllStayInRangeAndGrowWithTheLight) {
  for (ToneMap map : kAll) {
    float last = -1;
    for (float v = 1e-6f; v < 1e6f; v *= 1.3f) {
      const Rgb c = toneMapped({v, v, v}, map);
      EXPECT_GE(c.y, 0.0f);
      EXPECT_LE(c.y, 1.0f);
      EXPECT_GE(c.y, last - 1e-6f) << name(map) << " at " << v;
      last = c.y;
    }
  }
}

TEST(ToneMap, GreyStaysGrey) {
  for (ToneMap map : kAll) {
    for (float v : {0.02f, 0.18f, 0.7f, 3.0f}) {
      const Rgb c = toneMapped({v, v, v}, map);
      EXPECT_NEAR(c.x, c.y, 2e-3f);
      EXPECT_NEAR(c.z, c.y, 2e-3f);
    }
  }
}

TEST(ToneMap, BrokenLightIsBlackNotNoise) {
  for (ToneMap map : kAll) {
    const Rgb c = toneMapped({NAN, -INFINITY, -3}, map);
    EXPECT_GE(c.x, 0.0f);
    EXPECT_LT(c.x, 0.01f);
    EXPECT_LE(toneMapped({INFINITY, INFINITY, INFINITY}, map).x, 1.0f);
  }
}

TEST(ToneMap, NeutralShowsBaseColoursAsTheyAre) {
  // Below the shoulder only the usual dielectric's 4 % reflection is taken away.
  const Rgb c = toneMapped({0.54f, 0.34f, 0.24f}, ToneMap::PbrNeutral);
  EXPECT_NEAR(c.x, 0.50f, 1e-5f);
  EXPECT_NEAR(c.y, 0.30f, 1e-5f);
  EXPECT_NEAR(c.z, 0.20f, 1e-5f);
}

TEST(ToneMap, NeutralRollsHighlightsOff) {
  // 0.8 - 0.04 starts the shoulder: peak 2.04 - 0.04 = 2 becomes 1 - 0.24^2 / (2 + 0.24 - 0.76).
  const Rgb c = toneMapped({2.04f, 2.04f, 2.04f}, ToneMap::PbrNeutral);
  EXPECT_NEAR(c.x, 1 - 0.0576f / 1.48f, 1e-4f);
}

TEST(ToneMap, AgxKeepsMiddleGreyAndTurnsBlindingColoursWhite) {
  EXPECT_NEAR(toneMapped({0.18f, 0.18f, 0.18f}, ToneMap::AgX).y, std::pow(0.5f, 2.2f), 0.01f);
  const Rgb c = toneMapped({0, 0, 1000}, ToneMap::AgX);
  EXPECT_GT(c.x, 0.5f);
  EXPECT_GT(c.y, 0.5f);
}

TEST(ToneMap, ClassicClipsEachChannel) {
  EXPECT_EQ(toneMapped({0.25f, 1.5f, 0.75f}, ToneMap::Classic), (Rgb{0.25f, 1, 0.75f}));
}

TEST(ToneMap, FalseColourSaysStops) {
  const auto stops = [](float n) { return falseColor(0.18f * std::exp2(n)); };
  EXPECT_GT(stops(0).y, stops(0).x + stops(0).z);           // middle grey: green
  EXPECT_GT(stops(-4).z, stops(-4).x + stops(-4).y);        // deep shade: blue
  EXPECT_GT(stops(2.5f).x, stops(2.5f).y + stops(2.5f).z);  // the display's white: red
  EXPECT_EQ(stops(9), (Rgb{1, 1, 1}));
  EXPECT_EQ(falseColor(0), (Rgb{0, 0, 0}));
}

}  // namespace
}  // namespace idap::render
