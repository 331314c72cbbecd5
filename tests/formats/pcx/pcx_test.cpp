#include "formats/pcx/pcx.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"

namespace idap {
namespace {

Image8 fewColors(int w, int h) {
  const PaletteColor colors[] = {{0, 0, 0}, {255, 255, 255}, {132, 33, 0}, {8, 148, 206}};
  Image8 image(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) std::ranges::copy(colors[(x / 3 + y) % 4], image.pixel(x, y));
  }
  return image;
}

Image8 rainbow(int w, int h) {
  Image8 image(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(x * 255 / (w - 1));
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(y * 255 / (h - 1));
      image.pixel(x, y)[2] = static_cast<std::uint8_t>((x * y) % 256);
    }
  }
  return image;
}

int brightness(const PaletteColor& c) { return 30 * c[0] + 59 * c[1] + 11 * c[2]; }

TEST(Quantizer, FewColoursStayThemselves) {
  QuantizerStatistics statistics;
  const IndexedImage indexed = quantize(fewColors(20, 10), {}, &statistics);
  EXPECT_EQ(indexed.palette.size(), 4u);
  EXPECT_EQ(statistics.cells, 4);
  EXPECT_EQ(statistics.boxes, 4);
  EXPECT_LE(statistics.worstError, 7) << "five bits a channel";
}

TEST(Quantizer, ThePaletteRunsFromDarkToBright) {
  const IndexedImage indexed = quantize(rainbow(320, 200));
  EXPECT_EQ(indexed.palette.size(), 256u);
  for (std::size_t i = 1; i < indexed.palette.size(); ++i) {
    EXPECT_LE(brightness(indexed.palette[i - 1]), brightness(indexed.palette[i]));
  }
}

TEST(Quantizer, CutsTheMostPopulatedBoxAtTheMedianOfItsLongestAxis) {
  // Reds of 3, 1 and 2 pixels, 8 (cell 1), 128 (16) and 248 (31). Two boxes: the running sum reaches half at
  // the first, so it stands alone; the others share their weighted mean, (132 + 2 * 255) / 3.
  Image8 image(6, 1);
  const std::uint8_t reds[] = {8, 8, 8, 128, 248, 248};
  for (int x = 0; x < 6; ++x) image.pixel(x, 0)[0] = reds[x];
  const IndexedImage indexed = quantize(image, {.colors = 2});
  ASSERT_EQ(indexed.palette.size(), 2u);
  EXPECT_EQ(indexed.palette[0], (PaletteColor{8, 0, 0}));
  EXPECT_EQ(indexed.palette[1], (PaletteColor{214, 0, 0}));
  EXPECT_EQ(indexed.pixels, (std::vector<std::uint8_t>{0, 0, 0, 1, 1, 1}));
}

TEST(Quantizer, ErrorShrinksWithTheNumberOfColours) {
  double last = 1e9;
  for (int colors : {1, 2, 16, 64, 256}) {
    QuantizerStatistics s;
    quantize(rainbow(160, 100), {.colors = colors}, &s);
    EXPECT_EQ(s.boxes, colors);
    EXPECT_LT(s.meanError, last);
    EXPECT_GE(s.largestBox, s.smallestBox);
    EXPECT_GE(s.smallestBox, 1u);
    last = s.meanError;
  }
  EXPECT_LT(last, 14);
}

TEST(Quantizer, GammaBrightensTheMiddle) {
  Image8 grey(1, 1);
  std::ranges::fill(grey.rgb, std::uint8_t{64});
  // 255 (64 / 255)^(1 / 2.222) = 137, in five bits 17, widened 140.
  EXPECT_EQ(quantize(grey, {.gamma = true}).palette[0][0], 140);
}

TEST(Quantizer, RefusesNonsense) {
  EXPECT_THROW(quantize(Image8()), Error);
  EXPECT_THROW(quantize(fewColors(2, 2), {.colors = 257}), Error);
  EXPECT_THROW(quantize(fewColors(2, 2), {.colors = 0}), Error);
}

TEST(Pcx, ComesBackAsItWas) {
  for (const auto& [w, h] : {std::pair{1, 1}, {37, 23}, {320, 200}, {64, 3}}) {
    const IndexedImage indexed = quantize(rainbow(std::max(w, 2), std::max(h, 2)));
    const Image8 back = readPcx(writePcx(indexed), "a.pcx");
    ASSERT_EQ(back.width, indexed.width);
    ASSERT_EQ(back.height, indexed.height);
    for (std::size_t i = 0; i < indexed.pixels.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_EQ(back.rgb[3 * i + k], indexed.palette[indexed.pixels[i]][k]);
    }
  }
}

TEST(Pcx, HeaderAndPaletteAreThoseOfVersionFive) {
  const Bytes bytes = writePcx(fewColors(321, 200));
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  EXPECT_EQ(at(0), 10);
  EXPECT_EQ(at(1), 5);
  EXPECT_EQ(at(2), 1);
  EXPECT_EQ(at(3), 8);
  EXPECT_EQ(at(8) | at(9) << 8, 320);
  EXPECT_EQ(at(10) | at(11) << 8, 199);
  EXPECT_EQ(at(65), 1);
  EXPECT_EQ(at(66) | at(67) << 8, 322) << "lines have an even number of bytes";
  EXPECT_EQ(at(bytes.size() - 769), 12);
  EXPECT_TRUE(looksLikePcx(bytes));
}

TEST(Pcx, RunsAreShort) {
  // A single colour: runs of 63, two bytes each.
  EXPECT_EQ(writePcx(Image8(630, 10)).size(), 128 + 10 * 10 * 2 + 769);
  // Values from 192 on look like runs and must be coded as such.
  IndexedImage high{2, 1, std::vector<PaletteColor>(256, {9, 8, 7}), {200, 255}};
  EXPECT_EQ(writePcx(high).size(), 128 + 4 + 769);
  EXPECT_EQ(readPcx(writePcx(high), "a.pcx").rgb[5], 7);
}

TEST(Pcx, ReadsTrueColour) {
  Bytes bytes(128);
  const auto set = [&](std::size_t i, int v) { bytes[i] = static_cast<std::byte>(v); };
  set(0, 10);
  set(1, 5);
  set(2, 1);
  set(3, 8);
  set(8, 1);   // two pixels wide, one high
  set(65, 3);  // planes
  set(66, 2);
  for (int v : {10, 20, 30, 40, 50, 60}) bytes.push_back(static_cast<std::byte>(v));
  EXPECT_EQ(readPcx(bytes, "a.pcx").rgb, (std::vector<std::uint8_t>{10, 30, 50, 20, 40, 60}));
}

TEST(Pcx, DamageIsRefusedByName) {
  const Bytes whole = writePcx(rainbow(40, 30));
  for (std::size_t cut = 0; cut < whole.size(); cut += 13) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut));
    EXPECT_THROW(readPcx(part, "cut.pcx"), ParseError);
  }
  for (std::size_t i = 0; i < 200; ++i) {
    Bytes scrambled = whole;
    scrambled[i] ^= std::byte{0x5a};
    try {
      EXPECT_GT(readPcx(scrambled, "bad.pcx").width, 0);
    } catch (const ParseError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("bad.pcx"));
    }
  }
}

TEST(RawDump, FollowsTheLayoutOf1993) {
  Image8 image(2, 2);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(i);
  const Bytes bytes = writeRawDump(image);
  std::vector<int> values;
  for (std::byte b : bytes) values.push_back(std::to_integer<int>(b));
  EXPECT_EQ(values, (std::vector<int>{2, 0, 2, 0, 0, 0, 0, 3, 1, 4, 2, 5, 1, 0, 6, 9, 7, 10, 8, 11}));
  EXPECT_EQ(readRawDump(bytes, "a.raw"), image);
  EXPECT_THROW(readRawDump(Bytes(bytes.begin(), bytes.end() - 1), "a.raw"), ParseError);
  EXPECT_THROW(readRawDump({}, "a.raw"), ParseError);
}

}  // namespace
}  // namespace idap
