#include "scene/thumbnail.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "scene/scene_test_support.h"

namespace idap {
namespace {

constexpr int kSide = 48;

// Wood and paint, not the ground or a shadow on it.
bool isColoured(const std::uint8_t* p) {
  return std::max({p[0], p[1], p[2]}) - std::min({p[0], p[1], p[2]}) > 10;
}

// Of what is coloured, in pixels.
struct Extent {
  int left = kSide, top = kSide, right = -1, bottom = -1, pixels = 0;
};
Extent extentOf(const Image8& picture) {
  Extent e;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      if (!isColoured(picture.pixel(x, y))) continue;
      e.left = std::min(e.left, x), e.right = std::max(e.right, x);
      e.top = std::min(e.top, y), e.bottom = std::max(e.bottom, y);
      ++e.pixels;
    }
  return e;
}

Image8 thumbnail(const char* id) {
  const CatalogPiecePtr piece = test::noLibraries().find(id);
  return piece ? renderThumbnail(test::noLibraries(), *piece, kSide) : Image8();
}

TEST(Thumbnail, FitsTheWholePieceWithAMargin) {
  for (const char* id : {"idap/chair-windsor", "idap/night-table-drawers", "idap/table-farmhouse"}) {
    const Extent e = extentOf(thumbnail(id));
    EXPECT_GT(e.pixels, kSide * kSide / 25) << id;
    EXPECT_GE(e.left, 1) << id;
    EXPECT_GE(e.top, 1) << id;
    EXPECT_LE(e.right, kSide - 2) << id;
    // Something fills the picture in one direction at least.
    EXPECT_GT(std::max(e.right - e.left, e.bottom - e.top), kSide * 7 / 10) << id;
  }
}

TEST(Thumbnail, StandsOnALightGreyGround) {
  const Image8 picture = thumbnail("idap/chair-windsor");
  const std::uint8_t* corner = picture.pixel(1, 1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(corner[k], 195);
    EXPECT_LT(corner[k], 245);
  }
}

TEST(Thumbnail, ShowsDoorsInAPieceOfWallAndPicturesOnOne) {
  EXPECT_GT(extentOf(thumbnail("idap/door-panelled")).pixels, kSide * kSide / 10);
  EXPECT_GT(extentOf(thumbnail("idap/picture-landscape")).pixels, kSide * kSide / 6);
}

TEST(Thumbnail, IsTheSameEveryTime) {
  EXPECT_EQ(thumbnail("idap/light-table"), thumbnail("idap/light-table"));
}

TEST(Thumbnail, StopsWhenAsked) {
  Progress progress;
  progress.cancel();
  const CatalogPiecePtr piece = test::noLibraries().find("idap/chair-windsor");
  EXPECT_THROW(renderThumbnail(test::noLibraries(), *piece, kSide, progress), Cancelled);
}

TEST(Thumbnail, RefusesAPieceThatTheCatalogDoesNotHave) {
  CatalogPiece unknown;
  unknown.id = "nowhere#chair";
  unknown.size = {1, 1, 1};
  EXPECT_THROW(renderThumbnail(test::noLibraries(), unknown, kSide), ParseError);
}

}  // namespace
}  // namespace idap
