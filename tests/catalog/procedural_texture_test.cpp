#include "catalog/procedural_texture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/error.h"

namespace idap {
namespace {

class EveryPattern : public testing::TestWithParam<std::string> {
 protected:
  TextureRecipe recipe() const {
    TextureRecipe r;
    r.pattern = GetParam();
    r.width = r.height = 256;
    r.size = {0.6, 0.6};
    return r;
  }
};

// Mean absolute difference between two columns (or rows) of a picture.
double columnStep(const Image8& p, int a, int b) {
  long sum = 0;
  for (int y = 0; y < p.height; ++y)
    for (int c = 0; c < 3; ++c) sum += std::abs(p.pixel(a, y)[c] - p.pixel(b, y)[c]);
  return static_cast<double>(sum) / (3.0 * p.height);
}
double rowStep(const Image8& p, int a, int b) {
  long sum = 0;
  for (int x = 0; x < p.width; ++x)
    for (int c = 0; c < 3; ++c) sum += std::abs(p.pixel(x, a)[c] - p.pixel(x, b)[c]);
  return static_cast<double>(sum) / (3.0 * p.width);
}

TEST_P(EveryPattern, ComesOutTheSameEveryTime) {
  const ProceduralTexture a = makeTexture(recipe()), b = makeTexture(recipe());
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.normal, b.normal);
}

TEST_P(EveryPattern, TilesWithoutASeam) {
  if (GetParam() == "abstract" || GetParam() == "landscape") GTEST_SKIP() << "a painting does not tile";
  const Image8 p = makeTexture(recipe()).color;
  double widest = 0, tallest = 0;
  for (int i = 0; i + 1 < p.width; ++i) widest = std::max(widest, columnStep(p, i, i + 1));
  for (int i = 0; i + 1 < p.height; ++i) tallest = std::max(tallest, rowStep(p, i, i + 1));
  EXPECT_LE(columnStep(p, p.width - 1, 0), 1.25 * widest + 2);
  EXPECT_LE(rowStep(p, p.height - 1, 0), 1.25 * tallest + 2);
}

TEST_P(EveryPattern, HasAnAlbedoThatMatterCanHave) {
  const Rgb mean = meanReflectance(makeTexture(recipe()).color);
  EXPECT_GT(luminance(mean), 0.03f);
  EXPECT_LT(maxComponent(mean), 0.92f);
}

TEST_P(EveryPattern, IsNotOneFlatColour) {
  const Image8 p = makeTexture(recipe()).color;
  const auto [low, high] = std::minmax_element(p.rgb.begin(), p.rgb.end());
  EXPECT_GT(*high - *low, 10);
}

TEST_P(EveryPattern, IsFlatOnAverageWhereItHasRelief) {
  const Image8 n = makeTexture(recipe()).normal;
  if (n.width == 0) return;
  double x = 0, y = 0, z = 0;
  for (std::size_t i = 0; i < n.rgb.size(); i += 3) {
    x += n.rgb[i] - 127.5;
    y += n.rgb[i + 1] - 127.5;
    z += n.rgb[i + 2] - 127.5;
  }
  const double pixels = static_cast<double>(n.rgb.size()) / 3;
  EXPECT_NEAR(x / pixels, 0, 3);
  EXPECT_NEAR(y / pixels, 0, 3);
  EXPECT_GT(z / pixels, 60);
}

INSTANTIATE_TEST_SUITE_P(ProceduralTexture, EveryPattern, testing::ValuesIn(texturePatterns()),
                         [](const auto& tested) { return tested.param; });

TEST(ProceduralTexture, AnotherSeedGivesAnotherBoard) {
  TextureRecipe r;
  r.pattern = "wood";
  r.width = r.height = 64;
  const Image8 first = makeTexture(r).color;
  r.seed = 2;
  EXPECT_NE(makeTexture(r).color, first);
}

TEST(ProceduralTexture, RefusesWhatItDoesNotKnow) {
  TextureRecipe r;
  r.pattern = "unobtainium";
  EXPECT_THROW(makeTexture(r), Error);
  r.pattern = "wood";
  r.width = 0;
  EXPECT_THROW(makeTexture(r), Error);
}

TEST(ProceduralTexture, WritesABinaryPpm) {
  Image8 picture(2, 1);
  picture.rgb = {1, 2, 3, 255, 254, 253};
  const Bytes bytes = encodePpm(picture);
  EXPECT_EQ(asText(bytes).substr(0, 11), "P6\n2 1\n255\n");
  ASSERT_EQ(bytes.size(), 17u);
  EXPECT_EQ(std::to_integer<int>(bytes[14]), 255);
}

}  // namespace
}  // namespace idap
