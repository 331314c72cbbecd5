#include "render/denoise/denoise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "base/error.h"

namespace idap::render {
namespace {

constexpr DenoiseMethod kNetwork = DenoiseMethod::Network, kFilter = DenoiseMethod::Filter;

struct Picture {
  Film film;
  std::vector<Rgb> truth;
  std::vector<Rgb> noisy;
};

// A floor with a checked pattern, a wall, and a shadow with a soft edge, under Monte Carlo noise: few samples
// of an exponential spread, so that the mean is right and single pixels are far off.
Picture room(int w, int h, float brightness = 50) {
  Picture p{Film(w, h), {}, {}};
  std::mt19937 random(7);
  std::exponential_distribution<float> spread(1);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const std::size_t i = p.film.index(x, y);
      const bool wall = y < h / 2;
      const bool dark = ((x * 12 / w) + (y * 10 / h)) % 2 == 0;
      p.film.albedo[i] = wall ? Rgb{0.8f, 0.78f, 0.7f} : dark ? Rgb{0.3f, 0.2f, 0.1f} : Rgb{0.6f, 0.5f, 0.4f};
      p.film.normal[i] = wall ? Vec3f{0, -1, 0} : Vec3f{0, 0, 1};
      p.film.depth[i] = wall ? 5.0f : 5.0f * static_cast<float>(h) / static_cast<float>(2 * y + 2);
      const float across = static_cast<float>(x) / static_cast<float>(w);
      const float shadow = 0.25f + 0.75f / (1 + std::exp((across - 0.6f) * 40));
      const float light = brightness * shadow * (wall ? 0.7f + 0.3f * across : 1.0f);
      p.truth.push_back(p.film.albedo[i] * light);
      Rgb sum;
      for (int s = 0; s < 8; ++s) sum += p.truth.back() * spread(random);
      p.film.color[i] = sum;
      p.film.albedo[i] *= 8;
      p.film.normal[i] *= 8;
      p.film.depth[i] *= 8;
      p.film.weight[i] = 8;
    }
  }
  p.film.samples = 8;
  p.noisy = p.film.meanColors();
  return p;
}

double rmse(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(dot(a[i] - b[i], a[i] - b[i]));
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double mean(const std::vector<Rgb>& a) {
  double sum = 0;
  for (const Rgb& c : a) sum += static_cast<double>(luminance(c));
  return sum / static_cast<double>(a.size());
}

std::vector<Rgb> denoised(const Picture& p, DenoiseSettings settings) {
  static Denoiser denoiser;  // setting the networks up takes longer than running them
  std::vector<Rgb> color = p.noisy;
  denoiser.run(p.film, color, settings);
  return color;
}

struct Way {
  const char* name;
  DenoiseMethod method;
  bool fast;
};
void PrintTo(const Way& way, std::ostream* out) { *out << way.name; }

class Denoise : public ::testing::TestWithParam<Way> {
 protected:
  void SetUp() override {
    if (GetParam().method == kNetwork && !hasDenoiserNetwork()) {
      GTEST_SKIP() << "the network's weights are not installed; run dev/fetch-denoiser";
    }
  }
  DenoiseSettings settings(int threads = 2) const {
    return {.threads = threads, .fast = GetParam().fast, .method = GetParam().method};
  }
};

TEST_P(Denoise, TakesMostOfTheNoiseAway) {
  const Picture p = room(160, 120);
  EXPECT_LT(rmse(denoised(p, settings()), p.truth), 0.3 * rmse(p.noisy, p.truth));
}

TEST_P(Denoise, KeepsTheLight) {
  for (float brightness : {0.01f, 50.0f, 20000.0f}) {
    const Picture p = room(128, 96, brightness);
    EXPECT_NEAR(mean(denoised(p, settings())) / mean(p.noisy), 1, 0.01) << brightness;
  }
}

TEST_P(Denoise, KeepsThePatternOfTheFloor) {
  // Contrast of neighbouring checks that differ by albedo alone.
  const Picture p = room(240, 160);
  const std::vector<Rgb> color = denoised(p, settings());
  const auto at = [&](const std::vector<Rgb>& c, int x, int y) { return luminance(c[p.film.index(x, y)]); };
  const double before = static_cast<double>(at(p.truth, 18, 104) / at(p.truth, 22, 104));
  const double after = static_cast<double>(at(color, 18, 104) / at(color, 22, 104));
  EXPECT_NEAR(after / before, 1, 0.15);
}

TEST_P(Denoise, SpreadsSpecksWithoutLosingTheirLight) {
  // Every thirtieth pixel holds ten times the light, the others what is left.
  Picture p = room(120, 90);
  double before = 0;
  for (std::size_t i = 0; i < p.noisy.size(); ++i) {
    p.noisy[i] = p.truth[i] * ((i * 2654435761u >> 8) % 30 == 0 ? 10.0f : 0.7f);
    before += static_cast<double>(luminance(p.noisy[i]));
  }
  const std::vector<Rgb> color = denoised(p, settings());
  EXPECT_NEAR(mean(color) * static_cast<double>(color.size()) / before, 1, 0.06);
  EXPECT_LT(rmse(color, p.truth), 0.25 * rmse(p.noisy, p.truth));
}

TEST_P(Denoise, IsDeterministic) {
  const Picture p = room(75, 50);
  EXPECT_EQ(denoised(p, settings(1)), denoised(p, settings(1)));
  EXPECT_EQ(denoised(p, settings(2)), denoised(p, settings(2)));
}

TEST_P(Denoise, TakesAnySize) {
  for (const auto& [w, h] : {std::pair{37, 53}, {1, 1}, {1, 40}, {17, 2}}) {
    const Picture p = room(w, h);
    const std::vector<Rgb> color = denoised(p, settings());
    ASSERT_EQ(color.size(), p.noisy.size());
    for (const Rgb& c : color) {
      ASSERT_TRUE(isFinite(toDouble(c))) << w << " x " << h;
      ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0f);
    }
  }
}

TEST_P(Denoise, SurvivesNumbersThatAreNone) {
  Picture p = room(64, 48);
  const float bad[] = {NAN, INFINITY, -INFINITY, -5, 3e38f};
  for (std::size_t k = 0; k < std::size(bad); ++k) {
    const std::size_t i = p.film.index(static_cast<int>(10 + 9 * k), 20);
    p.noisy[i] = {bad[k], bad[k], 1};
    p.film.albedo[i] = p.film.normal[i] = {bad[k], bad[k], bad[k]};
    p.film.depth[i] = bad[k];
  }
  for (const Rgb& c : denoised(p, settings())) {
    ASSERT_TRUE(isFinite(toDouble(c)));
    ASSERT_GE(std::min({c.x, c.y, c.z}), 0.0f);
  }
}

TEST_P(Denoise, LeavesBlackBlack) {
  Picture p{Film(20, 20), {}, std::vector<Rgb>(400)};
  for (const Rgb& c : denoised(p, settings())) EXPECT_LT(luminance(c), 1e-3f);
}

INSTANTIATE_TEST_SUITE_P(All, Denoise,
                         ::testing::Values(Way{"Network", kNetwork, false},
                                           Way{"SmallNetwork", kNetwork, true},
                                           Way{"Filter", kFilter, false}),
                         [](const auto& way) { return way.param.name; });

TEST(Denoiser, GivesTheSameFromPictureToPicture) {
  const Picture a = room(64, 48), b = room(90, 31);
  Denoiser denoiser;
  for (const Picture* p : {&a, &b, &a}) {
    std::vector<Rgb> color = p->noisy;
    denoiser.run(p->film, color, {.threads = 2});
    std::vector<Rgb> alone = p->noisy;
    denoise(p->film, alone, {.threads = 2});
    EXPECT_EQ(color, alone);
  }
}

TEST(Denoiser, RefusesAPictureOfAnotherSize) {
  std::vector<Rgb> color(3);
  EXPECT_THROW(denoise(Film(2, 2), color), RenderError);
}

TEST(Denoiser, LargePicturesShowNoSeams) {
  if (!hasDenoiserNetwork())
    GTEST_SKIP() << "the network's weights are not installed; run dev/fetch-denoiser";
  // Wider than a tile: a smooth wall must stay smooth where two tiles meet.
  Picture p{Film(1400, 32), {}, {}};
  for (std::size_t i = 0; i < p.film.pixels(); ++i) {
    p.noisy.push_back({20, 20, 20});
    p.film.albedo[i] = {0.5f, 0.5f, 0.5f};
    p.film.normal[i] = {0, 0, 1};
    p.film.depth[i] = p.film.weight[i] = 1;
  }
  const std::vector<Rgb> color = denoised(p, {.threads = 2, .fast = true, .method = kNetwork});
  for (int x = 200; x < 1200; ++x) {
    EXPECT_NEAR(color[p.film.index(x, 16)].y, color[p.film.index(x + 1, 16)].y, 0.1) << x;
  }
}

TEST(Denoiser, LeavesAloneWhatIsQuiet) {
  // Fine texture that no layer announces, traced to the end: it must not be smoothed away.
  Film film(32, 32);
  film.samples = 256;
  for (std::size_t i = 0; i < film.pixels(); ++i) {
    const float l = (i + i / 32) % 2 ? 100.0f : 80.0f;
    film.weight[i] = 256;
    film.color[i] = Rgb{l, l, l} * 256;
    film.albedo[i] = Rgb{0.5f, 0.5f, 0.5f} * 256;
    film.normal[i] = Vec3f{0, 0, 256};
    film.square[i] = 256 * l * l * 1.0001f;
  }
  std::vector<Rgb> color = film.meanColors();
  Denoiser().run(film, color, {.method = DenoiseMethod::Filter});
  for (std::size_t i = 0; i < film.pixels(); ++i) EXPECT_NEAR(color[i].x, film.meanColor(i).x, 0.5f);
}

}  // namespace
}  // namespace idap::render
