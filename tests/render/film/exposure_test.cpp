#include "render/film/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

namespace idap::render {
namespace {

// A room of evenly lit surfaces of one albedo and luminance (cd/m2), with a share of its pixels the sky.
Film room(float wall, float albedo, float skyShare, float sky) {
  Film film(64, 64);
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const bool outside = static_cast<float>(i) < skyShare * static_cast<float>(film.pixels());
    const float l = outside ? sky : wall;
    film.color[i] = {l, l, l};
    film.weight[i] = 1;
    if (!outside) {
      film.albedo[i] = {albedo, albedo, albedo};
      film.depth[i] = 3;
      film.objectId[i] = 1;
    }
  }
  return film;
}

float shownWall(const Film& film, float wall) { return wall * exposureMultiplier(autoExposure(film)); }

TEST(Exposure, FollowsThePhotographersDefinition) {
  EXPECT_FLOAT_EQ(exposureMultiplier(0), 1 / 1.2f);
  EXPECT_FLOAT_EQ(exposureMultiplier(10), 1 / (1.2f * 1024));
  EXPECT_NEAR(ev100FromMultiplier(exposureMultiplier(7.3f)), 7.3f, 1e-5);
}

TEST(Exposure, ALivingRoomInTheEveningIsAboutEvSeven) {
  // 200 lx on surfaces of 0.5: 32 cd/m2.
  EXPECT_NEAR(autoExposure(room(32, 0.5f, 0, 0)), 7, 0.5);
}

TEST(Exposure, TheRoomLandsOnAMidToneWhateverTheLight) {
  for (float wall : {0.5f, 32.0f, 2000.0f}) {
    const float shown = shownWall(room(wall, 0.55f, 0, 0), wall);
    EXPECT_GT(shown, 0.25f);
    EXPECT_LT(shown, 0.35f);
  }
}

TEST(Exposure, AWhiteRoomComesOutBrighterThanADarkOne) {
  EXPECT_GT(shownWall(room(50, 0.8f, 0, 0), 50), 1.5f * shownWall(room(50, 0.3f, 0, 0), 50));
}

TEST(Exposure, BrightWindowsDoNotMakeTheRoomMurky) {
  EXPECT_GT(shownWall(room(40, 0.5f, 0.4f, 8000), 40), 0.8f * shownWall(room(40, 0.5f, 0, 0), 40));
}

TEST(Exposure, TheNightOutsideDoesNotWashTheRoomOut) {
  EXPECT_LT(shownWall(room(40, 0.5f, 0.4f, 0.001f), 40), 1.25f * shownWall(room(40, 0.5f, 0, 0), 40));
}

TEST(Exposure, ASunnyMeadowAroundTheHomeDoesNotDarkenIt) {
  Film film = room(40, 0.5f, 0, 0);
  for (std::size_t i = 0; i < film.pixels() * 7 / 10; ++i) {
    film.color[i] = {2000, 2000, 2000};
    film.objectId[i] = 0;
  }
  EXPECT_GT(shownWall(film, 40), 0.6f * shownWall(room(40, 0.5f, 0, 0), 40));
}

TEST(Exposure, AViewOfTheSkyAloneIsExposedToo) {
  const float shown = 3000 * exposureMultiplier(autoExposure(room(0, 0, 1, 3000)));
  EXPECT_GT(shown, 0.15f);
  EXPECT_LT(shown, 0.4f);
}

TEST(Exposure, NoiseDoesNotMakeItBrighter) {
  // One path in sixteen brings all the light.
  Film noisy(320, 240), clean(320, 240);
  for (std::size_t i = 0; i < noisy.pixels(); ++i) {
    for (Film* film : {&noisy, &clean}) {
      film->weight[i] = 1;
      film->depth[i] = 3;
      film->albedo[i] = {0.5f, 0.5f, 0.5f};
    }
    clean.color[i] = {40, 40, 40};
    const float l = (i * 2654435761u >> 8) % 16 == 0 ? 640.0f : 0.0f;
    noisy.color[i] = {l, l, l};
  }
  EXPECT_NEAR(autoExposure(noisy), autoExposure(clean), 0.7);
}

TEST(Exposure, StaysInBoundsWithoutLightAndWithBrokenPixels) {
  EXPECT_FLOAT_EQ(autoExposure(Film(4, 4)), 8);
  EXPECT_FLOAT_EQ(autoExposure(room(1e-4f, 0.5f, 0, 0)), kMinEv);
  EXPECT_FLOAT_EQ(autoExposure(room(1e9f, 0.5f, 0, 0)), kMaxEv);
  Film film = room(32, 0.5f, 0, 0);
  film.color[7] = {NAN, INFINITY, -1};
  EXPECT_NEAR(autoExposure(film), autoExposure(room(32, 0.5f, 0, 0)), 0.01);
}

}  // namespace
}  // namespace idap::render
