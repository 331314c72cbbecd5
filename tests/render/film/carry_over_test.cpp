#include "render/film/carry_over.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/error.h"

namespace idap::render {
namespace {

constexpr int kWidth = 160, kHeight = 100;

// A wall of one colour, everywhere alike.
Features wall() {
  Features f;
  f.width = kWidth, f.height = kHeight;
  const std::size_t n = kWidth * kHeight;
  f.albedo.assign(n, {0.6f, 0.5f, 0.4f});
  f.normal.assign(n, {0, -1, 0});
  f.depth.assign(n, 3.0f);
  f.distance.assign(n, 3.0f);
  f.objectId.assign(n, 1);
  f.slot.assign(n, 0);
  return f;
}

// What one path a pixel makes of light of the given strengths: one in four brings it all.
template <class Strength>
Film noisy(int width, int height, Strength&& strength) {
  Film film(width, height);
  std::mt19937 random(7);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = film.index(x, y);
      const bool meets = random() % 4 == 0;
      film.color[i] = Rgb{1, 1, 1} * (meets ? 4 * strength(x, y) : 0.0f);
      film.albedo[i] = {0.6f, 0.5f, 0.4f};
      film.normal[i] = {0, -1, 0};
      film.depth[i] = 3;
      film.weight[i] = film.coverage[i] = 1;
    }
  film.samples = 1;
  return film;
}

double meanOf(const std::vector<Rgb>& color, int x0, int x1) {
  double sum = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = x0; x < x1; ++x)
      sum += static_cast<double>(luminance(color[static_cast<std::size_t>(y * kWidth + x)]));
  return sum / (kHeight * (x1 - x0));
}

const CleanPicture kBefore{kWidth, kHeight, std::vector<Rgb>(kWidth* kHeight, Rgb{100, 100, 100})};
const std::vector<Rgb> kDenoised(kWidth* kHeight, Rgb{110, 110, 110});  // as far off as denoisers are

TEST(CarryOver, WhatHasNotChangedStaysAsCleanAsItWas) {
  const Film film = noisy(kWidth, kHeight, [](int, int) { return 100.0f; });
  const CleanPicture shown = carriedOver(kBefore, wall(), film, wall(), kDenoised, 1);
  ASSERT_EQ(shown.color.size(), kBefore.color.size());
  for (const Rgb& c : shown.color) EXPECT_NEAR(luminance(c), 100, 4);
}

TEST(CarryOver, LightThatHasChangedInAPartOfThePictureIsFollowedThere) {
  const Film film = noisy(kWidth, kHeight, [](int x, int) { return x < kWidth / 2 ? 100.0f : 40.0f; });
  std::vector<Rgb> denoised(kDenoised);
  for (std::size_t i = 0; i < denoised.size(); ++i)
    if (i % kWidth >= kWidth / 2) denoised[i] = {42, 42, 42};
  const CleanPicture shown = carriedOver(kBefore, wall(), film, wall(), denoised, 1);
  EXPECT_NEAR(meanOf(shown.color, 0, kWidth / 2 - 20), 100, 4);
  EXPECT_NEAR(meanOf(shown.color, kWidth / 2 + 20, kWidth), 42, 4);
}

TEST(CarryOver, ASmallFilmTellsOfTheSameChanges) {
  const Film film = noisy(80, 50, [](int x, int) { return x < 40 ? 100.0f : 40.0f; });
  const CleanPicture shown = carriedOver(kBefore, wall(), film, wall(), kDenoised, 1);
  EXPECT_NEAR(meanOf(shown.color, 0, kWidth / 2 - 20), 100, 4);
  EXPECT_NEAR(meanOf(shown.color, kWidth / 2 + 20, kWidth), 40, 5);
}

TEST(CarryOver, WhereSomethingElseIsSeenThePastIsForgotten) {
  const Film film = noisy(kWidth, kHeight, [](int, int) { return 100.0f; });
  Features sees = wall();
  for (int y = 40; y < 60; ++y)
    for (int x = 60; x < 90; ++x) sees.depth[sees.index(x, y)] = sees.distance[sees.index(x, y)] = 2.5f;
  const CleanPicture shown = carriedOver(kBefore, wall(), film, sees, kDenoised, 1);
  EXPECT_EQ(shown.color[sees.index(75, 50)], kDenoised[0]);
  EXPECT_NEAR(luminance(shown.color[sees.index(20, 50)]), 100, 4);
}

TEST(CarryOver, FadesWithItsShare) {
  const Film film = noisy(kWidth, kHeight, [](int, int) { return 100.0f; });
  const CleanPicture half = carriedOver(kBefore, wall(), film, wall(), kDenoised, 0.5f);
  EXPECT_NEAR(luminance(half.color[5000]), 105, 2.5);
  const CleanPicture none = carriedOver(kBefore, wall(), film, wall(), kDenoised, 0);
  EXPECT_EQ(none.color, kDenoised);
}

TEST(CarryOver, WhatHasMovedIsEnclosedByItsRegion) {
  EXPECT_TRUE(changedRegion(wall(), wall()).empty());
  Features sees = wall();
  for (int y = 40; y < 60; ++y)
    for (int x = 60; x < 90; ++x) sees.depth[sees.index(x, y)] = 2.5f;
  const PixelRegion region = changedRegion(wall(), sees);
  EXPECT_TRUE(region.has(60, 40) && region.has(89, 59));
  EXPECT_FALSE(region.has(140, 50));
}

TEST(CarryOver, RefusesViewsOfDifferentSize) {
  Features other = wall();
  other.width = 80, other.height = 200;
  const Film film = noisy(kWidth, kHeight, [](int, int) { return 100.0f; });
  EXPECT_THROW(carriedOver(kBefore, other, film, wall(), kDenoised, 1), RenderError);
}

TEST(CarryOver, ReducingKeepsTheMean) {
  CleanPicture picture{4, 2, {}};
  for (int i = 0; i < 8; ++i) picture.color.push_back(Rgb{1, 1, 1} * static_cast<float>(i));
  const std::vector<Rgb> half = reduced(picture, 2, 1);
  ASSERT_EQ(half.size(), 2u);
  EXPECT_FLOAT_EQ(half[0].x, (0 + 1 + 4 + 5) / 4.0f);
  EXPECT_FLOAT_EQ(half[1].x, (2 + 3 + 6 + 7) / 4.0f);
}

}  // namespace
}  // namespace idap::render
