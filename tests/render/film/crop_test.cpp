#include "render/film/crop.h"

#include <gtest/gtest.h>

namespace idap::render {
namespace {

TEST(Crop, APartIsPastedWhereItWasTaken) {
  std::vector<int> layer(20);
  for (int i = 0; i < 20; ++i) layer[static_cast<std::size_t>(i)] = i;
  const PixelRegion region{1, 2, 3, 2};  // of 5 x 4
  const std::vector<int> part = cropped(layer, 5, region);
  EXPECT_EQ(part, (std::vector<int>{11, 12, 13, 16, 17, 18}));
  std::vector<int> other(20, -1);
  paste(part, other, 5, region);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(other[static_cast<std::size_t>(i)], region.has(i % 5, i / 5) ? i : -1);
}

TEST(Crop, FilmsKeepTheirSamples) {
  Film film(5, 4);
  film.color[12] = {3, 2, 1};
  film.weight[12] = 2;
  const Film part = cropped(film, {2, 2, 2, 1});
  EXPECT_EQ(part.width, 2);
  EXPECT_EQ(part.pixels(), 2u);
  EXPECT_EQ(part.meanColor(0), (Rgb{1.5f, 1, 0.5f}));
  EXPECT_EQ(part.square.size(), 2u);
}

}  // namespace
}  // namespace idap::render
