#include "render/denoise/feature_filter.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace idap::render {

namespace {

constexpr int kPasses = 5;
constexpr float kLightTolerance = 3.0f;  // standard deviations
// Share of the variance counted as left after a pass. Independent samples would keep 0.07, but light bounces
// in blotches, and specks were spread.
constexpr float kNoiseLeft = 0.4f;
constexpr float kMinAlbedo = 0.02f;  // nothing is divided by less

// What a pixel shows, finite.
struct Guide {
  Vec3f normal;
  Rgb albedo;
  float depth = 0;
  float slope = 0;  // change of depth from one pixel to the next
};

class Filter {
 public:
  Filter(const Film& film, const std::vector<Rgb>& color)
      : width_(film.width),
        height_(film.height),
        guides_(color.size()),
        light_(color.size()),
        noise_(color.size()) {
    for (std::size_t i = 0; i < color.size(); ++i) {
      Guide& g = guides_[i];
      const Vec3f n = film.meanNormal(i);
      if (isFinite(toDouble(n))) g.normal = n;
      const Rgb a = film.meanAlbedo(i);
      if (isFinite(toDouble(a))) g.albedo = {std::max(a.x, 0.0f), std::max(a.y, 0.0f), std::max(a.z, 0.0f)};
      if (const float z = film.meanDepth(i); std::isfinite(z)) g.depth = z;
      light_[i] = color[i] / divisor(g);
    }
    rows([&](int x, int y) {
      Guide& g = guides_[index(x, y)];
      const auto z = [&](int i, int j) { return guides_[index(i, j)].depth; };
      const float dx =
          std::min(std::fabs(z(clampX(x + 1), y) - g.depth), std::fabs(g.depth - z(clampX(x - 1), y)));
      const float dy =
          std::min(std::fabs(z(x, clampY(y + 1)) - g.depth), std::fabs(g.depth - z(x, clampY(y - 1))));
      g.slope = std::max(dx, dy);
    });
    // Measured with the specks in: shared out, they look like light with soft edges.
    rows([&](int x, int y) { noise_[index(x, y)] = varianceAround(x, y); });
    spreadSpecks();
  }

  std::vector<Rgb> run() {
    std::vector<Rgb> light(light_.size());
    std::vector<float> noise(noise_.size());
    for (int pass = 0; pass < kPasses; ++pass) {
      const int step = 1 << pass;
      rows([&](int x, int y) { average(x, y, step, light[index(x, y)], noise[index(x, y)]); });
      light.swap(light_);
      noise.swap(noise_);
    }
    for (std::size_t i = 0; i < light_.size(); ++i) light_[i] = light_[i] * divisor(guides_[i]);
    return std::move(light_);
  }

 private:
  static Rgb divisor(const Guide& g) {
    // Black surfaces and the sky show light that no albedo explains.
    if (maxComponent(g.albedo) < kMinAlbedo) return {1, 1, 1};
    const auto usable = [](float a) { return std::max(a, kMinAlbedo); };
    return {usable(g.albedo.x), usable(g.albedo.y), usable(g.albedo.z)};
  }

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }
  int clampX(int x) const { return std::clamp(x, 0, width_ - 1); }
  int clampY(int y) const { return std::clamp(y, 0, height_ - 1); }

  template <class F>
  void rows(const F& f) const {
    tbb::parallel_for(tbb::blocked_range<int>(0, height_), [&](const tbb::blocked_range<int>& range) {
      for (int y = range.begin(); y < range.end(); ++y) {
        for (int x = 0; x < width_; ++x) f(x, y);
      }
    });
  }

  // The exponent, 0 or less, of how alike two pixels' surfaces are; distance in pixels.
  static float likeness(const Guide& a, const Guide& b, float distance) {
    const float dz = (a.depth - b.depth) / (a.slope * distance + 0.005f * a.depth + 1e-4f);
    const Vec3f dn = a.normal - b.normal;
    const Vec3f da = a.albedo - b.albedo;
    return -(std::min(dz * dz, 50.0f) + 16.0f * dot(dn, dn) + 40.0f * dot(da, da));
  }

  // A pixel much brighter than almost all around it is a stray path that carries the light of many others
  // that found none: what it has too much is shared out among the like pixels around, so that no light is
  // lost.
  void spreadSpecks() {
    constexpr int kLook = 2, kSpread = 6, kBrightNeighbours = 3;
    constexpr float kTooBright = 2;
    std::vector<Rgb> surplus(light_.size());
    rows([&](int x, int y) {
      const std::size_t p = index(x, y);
      const Guide& g = guides_[p];
      std::array<float, kBrightNeighbours> brightest{};  // descending
      for (int j = std::max(y - kLook, 0); j <= std::min(y + kLook, height_ - 1); ++j) {
        for (int i = std::max(x - kLook, 0); i <= std::min(x + kLook, width_ - 1); ++i) {
          if ((i == x && j == y) || likeness(g, guides_[index(i, j)], kLook) < -3) continue;
          float l = luminance(light_[index(i, j)]);
          for (float& b : brightest) {
            if (l > b) std::swap(l, b);
          }
        }
      }
      // What stands alone with few of its like, a distant lamp, is left as it is.
      const float l = luminance(light_[p]), limit = kTooBright * brightest.back();
      if (brightest.back() > 0 && l > limit) surplus[p] = light_[p] * (1 - limit / l);
    });
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const std::size_t p = index(x, y);
        if (luminance(surplus[p]) <= 0) continue;
        // Light per albedo is shared such that its product with the albedo, what is seen, keeps its sum.
        std::array<float, (2 * kSpread + 1) * (2 * kSpread + 1)> weights;
        Rgb total;
        const auto forNear = [&](const auto& f) {
          std::size_t k = 0;
          for (int j = std::max(y - kSpread, 0); j <= std::min(y + kSpread, height_ - 1); ++j) {
            for (int i = std::max(x - kSpread, 0); i <= std::min(x + kSpread, width_ - 1); ++i)
              f(index(i, j), k++);
          }
        };
        forNear([&](std::size_t q, std::size_t k) {
          const float e = likeness(guides_[p], guides_[q], kSpread);
          weights[k] = e < -8 ? 0.0f : std::exp(e);
          total += divisor(guides_[q]) * weights[k];
        });
        const Rgb share = surplus[p] * divisor(guides_[p]) / total;
        light_[p] = light_[p] - surplus[p];
        forNear([&](std::size_t q, std::size_t k) { light_[q] += share * weights[k]; });
      }
    }
  }

  // Variance of the light's luminance over the like pixels of 7 x 7.
  float varianceAround(int x, int y) const {
    constexpr int kRadius = 3;
    const Guide& g = guides_[index(x, y)];
    float weight = 0, sum = 0, squares = 0;
    for (int j = std::max(y - kRadius, 0); j <= std::min(y + kRadius, height_ - 1); ++j) {
      for (int i = std::max(x - kRadius, 0); i <= std::min(x + kRadius, width_ - 1); ++i) {
        const std::size_t q = index(i, j);
        const float e =
            likeness(g, guides_[q], static_cast<float>(std::max(std::abs(i - x), std::abs(j - y))));
        if (e < -8) continue;
        const float w = std::exp(e), l = luminance(light_[q]);
        weight += w;
        sum += w * l;
        squares += w * l * l;
      }
    }
    const float mean = sum / weight;
    return std::max(squares / weight - mean * mean, 0.0f);
  }

  // Noise of the neighbourhood, smoothed: of a single pixel it is itself too noisy.
  float deviation(int x, int y) const {
    float sum = 0;
    for (int j = -1; j <= 1; ++j) {
      for (int i = -1; i <= 1; ++i) {
        const float w = static_cast<float>((2 - std::abs(i)) * (2 - std::abs(j)));
        sum += w * noise_[index(clampX(x + i), clampY(y + j))];
      }
    }
    return std::sqrt(sum / 16);
  }

  void average(int x, int y, int step, Rgb& light, float& noise) const {
    constexpr float kKernel[3] = {3.0f / 8, 1.0f / 4, 1.0f / 16};  // B3 spline
    const std::size_t p = index(x, y);
    const Guide& g = guides_[p];
    const float l = luminance(light_[p]);
    const float scale = 1 / (kLightTolerance * deviation(x, y) + 1e-4f * l + 1e-12f);
    float weight = 0, noiseSum = 0;
    Rgb sum;
    for (int j = -2; j <= 2; ++j) {
      const int yy = y + j * step;
      if (yy < 0 || yy >= height_) continue;
      for (int i = -2; i <= 2; ++i) {
        const int xx = x + i * step;
        if (xx < 0 || xx >= width_) continue;
        const std::size_t q = index(xx, yy);
        const float distance = static_cast<float>(step * std::max(std::abs(i), std::abs(j)));
        const float e = likeness(g, guides_[q], distance) - std::fabs(luminance(light_[q]) - l) * scale;
        if (e < -12) continue;
        const float w = kKernel[std::abs(i)] * kKernel[std::abs(j)] * std::exp(e);
        weight += w;
        sum += light_[q] * w;
        noiseSum += noise_[q] * w;
      }
    }
    light = sum / weight;
    noise = kNoiseLeft * noiseSum / weight;
  }

  int width_, height_;
  std::vector<Guide> guides_;
  std::vector<Rgb> light_;
  std::vector<float> noise_;
};

}  // namespace

void filterByFeatures(const Film& film, std::vector<Rgb>& color, int threads) {
  tbb::task_arena arena(threads);
  arena.execute([&] { color = Filter(film, color).run(); });
}

}  // namespace idap::render
