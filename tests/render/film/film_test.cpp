#include "render/film/film.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"

namespace idap::render {
namespace {

TEST(Film, StartsBlackWithALayerForEveryLightGroup) {
  const Film film(3, 2, 2);
  EXPECT_EQ(film.pixels(), 6u);
  EXPECT_EQ(film.groups.size(), 2u);
  EXPECT_EQ(film.groups[1].size(), 6u);
  EXPECT_EQ(film.meanColor(5), Rgb{});
}

TEST(Film, MeansDivideByThePixelsOwnSamples) {
  Film film(2, 1, 1);
  film.color[1] = {6, 3, 9};
  film.groups[0][1] = {2, 2, 2};
  film.depth[1] = 12;
  film.weight[1] = 3;
  EXPECT_FLOAT_EQ(film.meanColor(1).z, 3);
  EXPECT_FLOAT_EQ(film.meanGroup(0, 1).x, 2.0f / 3);
  EXPECT_FLOAT_EQ(film.meanDepth(1), 4);
  EXPECT_EQ(film.meanColor(0), Rgb{});
}

TEST(Film, RefusesWhatNoMemoryHoldsAndSaysHowMuchItWouldTake) {
  try {
    const Film film(40'000, 40'000);
    FAIL() << "such a film must be refused";
  } catch (const RenderError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("40000 x 40000"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("GB"));
  }
  EXPECT_THROW(Film(2'000'000'000, 2'000'000'000), RenderError);
  EXPECT_THROW(Film(0, 10), RenderError);
  EXPECT_THROW(Film(10, -1), RenderError);
}

TEST(Film, ClearKeepsTheLayers) {
  Film film(2, 2, 1);
  film.color[0] = {1, 1, 1};
  film.weight[0] = 1;
  film.samples = 4;
  film.clear();
  EXPECT_EQ(film.samples, 0);
  EXPECT_EQ(film.meanColor(0), Rgb{});
  EXPECT_EQ(film.groups.size(), 1u);
}

}  // namespace
}  // namespace idap::render
