#include "render/film/develop.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/error.h"

namespace idap::render {
namespace {

// Grey surfaces of albedo 0.5 under light of one colour.
Film greyUnder(Rgb light, int w = 32, int h = 24) {
  Film film(w, h);
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    film.color[i] = light * (10.0f + static_cast<float>(i % 7));
    film.albedo[i] = {0.5f, 0.5f, 0.5f};
    film.normal[i] = {0, 0, 1};
    film.depth[i] = 2;
    film.weight[i] = 1;
  }
  return film;
}

double saturation(const Image8& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    sum += std::abs(int{image.rgb[i]} - int{image.rgb[i + 2]});
  }
  return sum / static_cast<double>(image.rgb.size() / 3);
}

const Rgb kWarm{1.6f, 0.92f, 0.3f};  // about 2700 K

TEST(Develop, IsDeterministic) {
  const Film film = greyUnder(kWarm);
  EXPECT_EQ(develop(film), develop(film));
}

TEST(Develop, ExposureDoublesTheLightForEveryStop) {
  const Film film = greyUnder({1, 1, 1});
  const DevelopSettings at8{.ev = 8, .whiteBalance = 0, .denoise = false};
  const DevelopSettings at7{.ev = 7, .whiteBalance = 0, .denoise = false};
  EXPECT_NEAR(developLinear(film, at7)[5].y, 2 * developLinear(film, at8)[5].y, 1e-6);
  const DevelopSettings raised{.ev = 8, .compensation = 1, .whiteBalance = 0, .denoise = false};
  EXPECT_FLOAT_EQ(developLinear(film, raised)[5].y, developLinear(film, at7)[5].y);
}

TEST(Develop, WhiteBalanceTakesTheOrangeOutByTheShareAsked) {
  const Film film = greyUnder(kWarm);
  const auto with = [&](float share) {
    return saturation(develop(film, {.whiteBalance = share, .denoise = false}));
  };
  EXPECT_GT(with(0), 60);
  EXPECT_LT(with(0.6f), 0.6 * with(0));
  EXPECT_LT(with(1), 5);  // the light is a little off the line of lamps and daylight
}

TEST(Develop, WhiteBalanceKeepsTheBrightness) {
  const WhiteBalance balance(kWarm, 1);
  EXPECT_NEAR(luminance(balance(kWarm)), luminance(kWarm), 0.01);
}

TEST(Develop, ColouredWallsDoNotFoolTheWhiteBalance) {
  Film film = greyUnder({1, 1, 1});
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    film.albedo[i] = {0.6f, 0.3f, 0.1f};
    film.color[i] = film.albedo[i] * 20.0f;
  }
  const Rgb light = estimateIlluminant(film);
  EXPECT_NEAR(light.x, 1, 0.01);
  EXPECT_NEAR(light.z, 1, 0.01);
}

TEST(Develop, WithoutSurfacesTheLightCountsAsWhite) {
  EXPECT_EQ(estimateIlluminant(Film(4, 4)), (Rgb{1, 1, 1}));
}

TEST(Develop, ClassicShowsColoursAsTheyAre) {
  Film film(2, 1);
  film.color = {{1, 0, 0.2140411f}, {2, 2, 2}};
  film.weight = {1, 1};
  const Image8 image = develop(film, {.ev = 20, .toneMap = ToneMap::Classic});
  EXPECT_EQ(image.pixel(0, 0)[0], 255);
  EXPECT_EQ(image.pixel(0, 0)[1], 0);
  EXPECT_NEAR(image.pixel(0, 0)[2], 127, 1);
  EXPECT_EQ(image.pixel(1, 0)[1], 255);
}

TEST(Develop, DitherBreaksBandsWithoutChangingTheMean) {
  // A tone halfway between two codes must use both of them.
  const float tone = srgbToLinear(100.5f / 255);
  const Image8 image = toImage(std::vector<Rgb>(64 * 64, {tone, tone, tone}), 64, 64, ToneMap::Linear);
  double sum = 0;
  std::set<int> codes;
  for (std::uint8_t v : image.rgb) {
    sum += v;
    codes.insert(v);
  }
  EXPECT_EQ(codes, (std::set<int>{100, 101}));
  EXPECT_NEAR(sum / static_cast<double>(image.rgb.size()), 100.5, 0.02);
}

TEST(Develop, BlackAndWhiteStayPure) {
  const Image8 black = toImage(std::vector<Rgb>(256), 16, 16, ToneMap::PbrNeutral);
  const Image8 white = toImage(std::vector<Rgb>(256, {1, 1, 1}), 16, 16, ToneMap::Linear);
  for (std::uint8_t v : black.rgb) EXPECT_EQ(v, 0);
  for (std::uint8_t v : white.rgb) EXPECT_EQ(v, 255);
}

TEST(Develop, RefusesAPictureOfAnotherSize) {
  EXPECT_THROW(toImage(std::vector<Rgb>(5), 2, 2, ToneMap::Linear), RenderError);
}

TEST(Develop, WhatTheSkyShinesThroughIsSeeThrough) {
  Film film(2, 1);
  film.color = {{100, 100, 100}, {50, 50, 50}};  // the second is half sky
  film.weight = {1, 1};
  film.coverage = {1, 0.5f};
  DevelopSettings settings{.ev = 8.0f, .denoise = false};
  settings.illuminant = Rgb{1, 1, 1};
  const Texture picture = developTransparent(film, settings);
  EXPECT_EQ(picture.rgba[3], 255);
  EXPECT_NEAR(picture.rgba[7], 128, 1);
  EXPECT_NEAR(picture.rgba[0], picture.rgba[4], 2);
}

}  // namespace
}  // namespace idap::render
