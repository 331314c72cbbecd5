#include "film/video_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"
#include "film/film_test_support.h"

namespace idap {
namespace {

using test::FilmFile;
using test::Folder;

Image8 grey(int width, int height, int value) {
  Image8 image(width, height);
  std::fill(image.rgb.begin(), image.rgb.end(), static_cast<std::uint8_t>(value));
  return image;
}

TEST(VideoWriter, WritesAFilmThatReadsBack) {
  const Folder folder;
  VideoWriter writer(folder / "a.mp4", 64, 48, 25);
  for (int i = 0; i < 30; ++i) writer.add(grey(64, 48, 8 * i));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.mp4")) << "half a film";
  writer.finish();
  const FilmFile film = test::readFilm(folder / "a.mp4");
  EXPECT_EQ(film.width, 64);
  EXPECT_EQ(film.height, 48);
  EXPECT_EQ(film.frames, 30);
  EXPECT_DOUBLE_EQ(film.framesPerSecond, 25);
  EXPECT_NEAR(film.seconds, 1.2, 0.001);
  EXPECT_TRUE(film.everyFrameAsLong);
  EXPECT_TRUE(film.bt709);
  if (writer.remark().empty()) {
    EXPECT_EQ(film.codec, "h264");
  }
  EXPECT_EQ(folder.files(), 1u);
}

TEST(VideoWriter, TheIndexIsInFront) {
  const Folder folder;
  VideoWriter writer(folder / "a.mp4", 64, 48, 25);
  writer.add(grey(64, 48, 100));
  writer.finish();
  std::ifstream in(folder / "a.mp4", std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST(VideoWriter, OddSizesBecomeEven) {
  const Folder folder;
  VideoWriter writer(folder / "a.mp4", 65, 49, 10);
  writer.add(grey(65, 49, 100));
  writer.finish();
  EXPECT_EQ(test::readFilm(folder / "a.mp4").width, 64);
  EXPECT_EQ(test::readFilm(folder / "a.mp4").height, 48);
}

TEST(VideoWriter, GivenUpLeavesTheOldFileAndNothingElse) {
  const Folder folder;
  std::ofstream(folder / "a.mp4") << "old";
  {
    VideoWriter writer(folder / "a.mp4", 64, 48, 25);
    writer.add(grey(64, 48, 100));
  }
  EXPECT_EQ(folder.files(), 1u);
  std::string left;
  std::ifstream(folder / "a.mp4") >> left;
  EXPECT_EQ(left, "old");
}

TEST(VideoWriter, SaysWhyItCannotWrite) {
  const Folder folder;
  const auto reason = [](const std::filesystem::path& file) -> std::string {
    try {
      VideoWriter(file, 64, 48, 25);
    } catch (const IoError& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(reason(folder / "none/a.mp4"), testing::HasSubstr("No such file or directory"));
  EXPECT_THAT(reason(folder.path()), testing::HasSubstr("directory"));
  EXPECT_THROW(VideoWriter(folder / "a.mp4", 4, 4, 25), IoError);
  EXPECT_THROW(VideoWriter(folder / "a.mp4", 64, 48, 0), IoError);
  EXPECT_EQ(folder.files(), 0u);
}

}  // namespace
}  // namespace idap
