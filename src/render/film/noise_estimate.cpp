#include "render/film/noise_estimate.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace idap::render {

namespace {

constexpr int kReach = 3;         // pixels
constexpr float kDarkest = 0.1f;  // of the picture's mean

}  // namespace

std::vector<float> noiseEstimate(const Film& film) {
  const std::size_t n = film.pixels();
  // Of one sample: the mean's own falls with the samples, which differ from pixel to pixel.
  std::vector<float> variance(n), brightness(n);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const float error = film.standardError(i);
    variance[i] = error * error * film.weight[i];
    brightness[i] = luminance(film.meanColor(i));
    sum += static_cast<double>(brightness[i]);
  }
  const float darkest =
      std::max(kDarkest * static_cast<float>(sum / static_cast<double>(std::max<std::size_t>(n, 1))), 1e-20f);
  std::vector<float> estimate(n);
  tbb::parallel_for(0, film.height, [&](int y) {
    const int y0 = std::max(y - kReach, 0), y1 = std::min(y + kReach, film.height - 1);
    std::vector<float> v(static_cast<std::size_t>(film.width)), b(v.size());  // sums of columns
    for (int x = 0; x < film.width; ++x)
      for (int row = y0; row <= y1; ++row) {
        v[static_cast<std::size_t>(x)] += variance[film.index(x, row)];
        b[static_cast<std::size_t>(x)] += brightness[film.index(x, row)];
      }
    for (int x = 0; x < film.width; ++x) {
      const int x0 = std::max(x - kReach, 0), x1 = std::min(x + kReach, film.width - 1);
      float vSum = 0, bSum = 0;
      for (int column = x0; column <= x1; ++column) {
        vSum += v[static_cast<std::size_t>(column)];
        bSum += b[static_cast<std::size_t>(column)];
      }
      const auto count = static_cast<float>((x1 - x0 + 1) * (y1 - y0 + 1));
      const std::size_t i = film.index(x, y);
      estimate[i] =
          std::sqrt(vSum / count / std::max(film.weight[i], 1.0f)) / std::max(bSum / count, darkest);
    }
  });
  return estimate;
}

float noiseLevel(const Film& film) {
  if (film.samples < 2) return 0;
  std::vector<float> noise = noiseEstimate(film);
  for (float& v : noise)
    if (!(v >= 0)) v = 0;
  const auto at = noise.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(noise.size() - 1));
  std::ranges::nth_element(noise, at);
  return *at;
}

}  // namespace idap::render
