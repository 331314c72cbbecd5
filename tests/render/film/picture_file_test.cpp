#include "render/film/picture_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "render/film/texture_file.h"

namespace idap::render {
namespace {

class PictureFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("idap-picture-") + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

Image8 gradient(int w, int h) {
  Image8 image(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(x * 255 / w);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(y * 255 / h);
      image.pixel(x, y)[2] = 40;
    }
  }
  return image;
}

TEST_F(PictureFile, LosslessKindsComeBackAsTheyWere) {
  const Image8 image = gradient(37, 23);
  for (const char* name : {"a.png", "a.bmp", "A.PNG"}) {
    savePicture(folder_ / name, image);
    EXPECT_EQ(loadPicture(folder_ / name), image) << name;
  }
}

TEST_F(PictureFile, JpegIsCloseAndSmallerAtLowerQuality) {
  const Image8 image = gradient(64, 48);
  savePicture(folder_ / "a.jpg", image, 95);
  const Image8 back = loadPicture(folder_ / "a.jpg");
  ASSERT_EQ(back.rgb.size(), image.rgb.size());
  for (std::size_t i = 0; i < back.rgb.size(); ++i) ASSERT_NEAR(back.rgb[i], image.rgb[i], 12);
  EXPECT_LT(encodePicture(image, ".jpeg", 30).size(), encodePicture(image, "jpg", 98).size());
}

TEST_F(PictureFile, FailuresNameThePath) {
  const Image8 image = gradient(4, 4);
  for (const char* name : {"a.xyz", "noextension", "missing/a.png"}) {
    try {
      savePicture(folder_ / name, image);
      FAIL() << name;
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr((folder_ / name).string()));
    }
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_THROW(savePicture(folder_ / "empty.png", Image8()), IoError);
  EXPECT_THROW(loadPicture(folder_ / "none.png"), IoError);
}

TEST_F(PictureFile, LayersKeepRealUnitsAndNames) {
  Film film(5, 4, 2);
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    film.color[i] = {5000, 20, 0.5f};
    film.weight[i] = 2;
    film.objectId[i] = 70'001;
    film.depth[i] = 7;
    film.groups[1][i] = {8, 8, 8};
  }
  saveLayers(folder_ / "film.exr", film, {{"daylight"}, {"kitchen.lamp"}});
  const Bytes bytes = readFile(folder_ / "film.exr");
  const std::string_view text = asText(bytes);
  for (const char* channel :
       {"albedo.R", "normal.X", "depth.Z", "objectId", "daylight.R", "kitchen_lamp.B"}) {
    EXPECT_NE(text.find(channel), std::string_view::npos) << channel;
  }
}

TEST(Texture, GreyAlphaAndOpacityAreToldApart) {
  const TexturePtr opaque = decodeTexture(encodePicture(gradient(9, 5), "png"), true);
  EXPECT_EQ(opaque->width, 9);
  EXPECT_EQ(opaque->height, 5);
  EXPECT_FALSE(opaque->hasAlpha);
  EXPECT_TRUE(opaque->srgb);
  EXPECT_EQ(opaque->rgba[3], 255);
  EXPECT_EQ(opaque->rgba[2], 40);
  EXPECT_FALSE(decodeTexture(encodePicture(gradient(9, 5), "png"), false)->srgb);
}

TEST(Texture, AGifOfOnePixel) {
  const unsigned char gif[] = {'G', 'I',  'F', '8', '9', 'a', 1, 0, 1, 0, 0x80, 0, 0, 200,  100, 50, 0,   0,
                               0,   0x2c, 0,   0,   0,   0,   1, 0, 1, 0, 0,    2, 2, 0x44, 1,   0,  0x3b};
  Bytes bytes(sizeof gif);
  std::memcpy(bytes.data(), gif, sizeof gif);
  const TexturePtr texture = decodeTexture(bytes, true);
  EXPECT_EQ(texture->width, 1);
  EXPECT_EQ(texture->rgba[0], 200);
  EXPECT_EQ(texture->rgba[1], 100);
}

TEST(Texture, LargePicturesAreShrunkButKeepTheirTone) {
  Image8 checks(5000, 40);
  for (std::size_t i = 0; i < checks.rgb.size(); ++i) checks.rgb[i] = (i / 3) % 2 ? 255 : 0;
  const TexturePtr texture = decodeTexture(encodePicture(checks, "png"), true);
  EXPECT_EQ(texture->width, 2500);
  EXPECT_EQ(texture->height, 20);
  // Half black, half white light is 188 in sRGB, not 128.
  EXPECT_NEAR(texture->rgba[0], 188, 1);
}

TEST(Texture, JunkIsRefused) {
  EXPECT_THROW(decodeTexture({}, true), ParseError);
  Bytes junk(1000);
  for (std::size_t i = 0; i < junk.size(); ++i) junk[i] = static_cast<std::byte>(i * 89 + 3);
  EXPECT_THROW(decodeTexture(junk, true), ParseError);
}

TEST(Texture, CutAndScrambledPicturesNeverCrash) {
  for (const char* kind : {"png", "jpg", "bmp"}) {
    const Bytes whole = encodePicture(gradient(40, 30), kind);
    for (std::size_t cut = 0; cut < whole.size(); cut += 1 + whole.size() / 25) {
      Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut));
      Bytes scrambled = whole;
      for (std::size_t k = cut; k < std::min(cut + 3, whole.size()); ++k) scrambled[k] ^= std::byte{0xa5};
      for (const Bytes& bytes : {part, scrambled}) {
        try {
          EXPECT_LE(decodeTexture(bytes, true)->width, kMaxTextureSide);
        } catch (const ParseError&) {
        }
      }
    }
  }
}

}  // namespace
}  // namespace idap::render
