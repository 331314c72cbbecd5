#include "pictures/picture_kind.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/file.h"
#include "render/film/picture_file.h"

namespace idap {
namespace {

namespace fs = std::filesystem;

Image8 gradient(int width, int height) {
  Image8 image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = &image.rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
      p[0] = std::uint8_t(255 * x / width), p[1] = std::uint8_t(255 * y / height), p[2] = 90;
    }
  return image;
}

class PictureKindTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_ = fs::path(testing::TempDir()) / "picture_kind_test";
};

TEST_F(PictureKindTest, GoesByTheEndOfTheName) {
  EXPECT_EQ(pictureKindOf("a/b.PNG"), PictureKind::Png);
  EXPECT_EQ(pictureKindOf("b.jpeg"), PictureKind::Jpeg);
  EXPECT_EQ(pictureKindOf("b.gif"), PictureKind::Gif);
  EXPECT_EQ(pictureKindOf("b.tiff"), std::nullopt);
  EXPECT_EQ(pictureKindOf("png"), std::nullopt);
}

TEST_F(PictureKindTest, EveryKindThatIsReadAgainLooksLikeThePicture) {
  const Image8 image = gradient(67, 41);
  for (const PictureKind kind : {PictureKind::Png, PictureKind::Jpeg, PictureKind::Gif}) {
    fs::path file = folder_ / "picture";
    for (const PictureKindInfo& info : pictureKinds())
      if (info.kind == kind) file += info.extension;
    writePicture(file, kind, image);
    const Image8 back = render::loadPicture(file);
    ASSERT_EQ(back.width, image.width) << file;
    ASSERT_EQ(back.height, image.height) << file;
    double error = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i) error += std::abs(image.rgb[i] - back.rgb[i]);
    EXPECT_LT(error / double(image.rgb.size()), 6) << file;
  }
}

TEST_F(PictureKindTest, AnExrIsNotMadeOfAFinishedPicture) {
  EXPECT_THROW(writePicture(folder_ / "a.exr", PictureKind::Exr, gradient(2, 2)), Error);
  EXPECT_FALSE(fs::exists(folder_ / "a.exr"));
}

TEST_F(PictureKindTest, AFolderThatIsNotThereIsSaid) {
  EXPECT_THROW(writePicture(folder_ / "no/a.gif", PictureKind::Gif, gradient(2, 2)), IoError);
}

}  // namespace
}  // namespace idap
