#include "render/sampling/distribution.h"

#include <algorithm>

#include "render/sampling/warp.h"

namespace idap::render {

Distribution1D::Distribution1D(std::span<const float> weights) : cdf_(weights.size() + 1, 0.0f) {
  double sum = 0;
  for (const float w : weights) sum += static_cast<double>(w);
  const auto n = static_cast<double>(weights.size());
  mean_ = static_cast<float>(sum / n);
  double running = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    running += sum > 0 ? static_cast<double>(weights[i]) / sum : 1 / n;
    cdf_[i + 1] = static_cast<float>(running);
  }
  // Cells of weight 0 at the end must stay empty: lift them to 1 together with the last one that has weight.
  const float last = cdf_.back();
  for (auto it = cdf_.rbegin(); it != cdf_.rend() && *it == last; ++it) *it = 1.0f;
}

Distribution1D::Sample Distribution1D::sample(float u) const {
  const auto it = std::upper_bound(cdf_.begin() + 1, cdf_.end() - 1, u);
  const auto cell = static_cast<int>(it - cdf_.begin()) - 1;
  const float low = cdf_[cell1(cell) - 1], span = cdf_[cell1(cell)] - low;
  const float within = span > 0 ? std::clamp((u - low) / span, 0.0f, kOneMinusEpsilon) : 0.5f;
  const auto n = static_cast<float>(size());
  return {std::min((static_cast<float>(cell) + within) / n, kOneMinusEpsilon), span * n, cell};
}

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height) {
  std::vector<float> sums;
  for (int y = 0; y < height; ++y) {
    rows_.emplace_back(weights.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(width),
                                       static_cast<std::size_t>(width)));
    sums.push_back(rows_.back().mean());
  }
  marginal_ = Distribution1D(sums);
}

Distribution2D::Sample Distribution2D::sample(Vec2f u) const {
  const Distribution1D::Sample y = marginal_.sample(u.y);
  const Distribution1D::Sample x = rows_[static_cast<std::size_t>(y.cell)].sample(u.x);
  return {{x.x, y.x}, x.pdf * y.pdf};
}

float Distribution2D::pdf(Vec2f p) const {
  const int y =
      std::clamp(static_cast<int>(p.y * static_cast<float>(marginal_.size())), 0, marginal_.size() - 1);
  const Distribution1D& row = rows_[static_cast<std::size_t>(y)];
  const int x = std::clamp(static_cast<int>(p.x * static_cast<float>(row.size())), 0, row.size() - 1);
  return row.pdf(x) * marginal_.pdf(y);
}

}  // namespace idap::render
