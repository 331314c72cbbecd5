#include "render/film/mix_preview.h"

#include <gtest/gtest.h>

namespace idap::render {
namespace {

// A grey wall lit by two lamps, one from the left and one from the right.
Film twoLamps(int w, int h) {
  Film film(w, h, 2);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const std::size_t i = film.index(x, y);
      const float t = static_cast<float>(x) / static_cast<float>(w);
      film.weight[i] = 4;
      film.groups[0][i] = Rgb{400, 400, 400} * (1 - t);
      film.groups[1][i] = Rgb{400, 300, 200} * t;
      film.color[i] = film.groups[0][i] + film.groups[1][i];
      film.albedo[i] = {2, 2, 2};
      film.normal[i] = {0, 0, 4};
      film.depth[i] = 8;
      film.objectId[i] = 1;
    }
  film.samples = 4;
  return film;
}

TEST(MixPreview, ALampSwitchedOffIsDarkOnItsSide) {
  const MixPreview preview(twoLamps(64, 32), {{"left", {1, 1, 1}}, {"right", {1.2f, 1, 0.6f}}});
  const Image8 all = preview.picture({}), without = preview.picture({{}, {.strength = 0}});
  EXPECT_LT(without.pixel(60, 16)[1], all.pixel(60, 16)[1] / 2);
  EXPECT_NEAR(without.pixel(2, 16)[1], all.pixel(2, 16)[1], 12);
  EXPECT_GT(preview.picture({}, ToneMap::PbrNeutral, 1).pixel(30, 16)[1], all.pixel(30, 16)[1]);
  EXPECT_NEAR(preview.shares()[0] + preview.shares()[1], 1, 1e-5f);
}

TEST(MixPreview, LargePicturesAreMixedSmall) {
  const Film film = twoLamps(400, 300);
  const Film small = reduced(film, 10'000);
  EXPECT_LE(small.pixels(), 10'000u);
  EXPECT_NEAR(small.meanColor(small.index(small.width / 2, 3)).x, film.meanColor(film.index(200, 30)).x, 3);
  EXPECT_EQ(reduced(film, 1'000'000).width, 400);
}

TEST(MixPreview, NeedsLightsAndCanBeBrokenOff) {
  EXPECT_THROW(MixPreview(Film(4, 4), {}), RenderError);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(MixPreview(twoLamps(64, 64), {}, 100'000, progress), Cancelled);
}

}  // namespace
}  // namespace idap::render
