#include "render/sampling/distribution.h"

#include <bit>

#include "render/sampling/warp.h"

namespace idap::render {

namespace {

// A row of cumulative sums and where to begin in it.
template <class F>
struct Row {
  const float* cdf;
  const std::int32_t* guide;
  Int<F> firstSum, firstGuide;
  int cells;
};

// The last of the cells whose sum below is at most u.
template <class F>
Int<F> cellAt(const Row<F>& row, F u) {
  using namespace lane_math;
  const Int<F> step = toInt(min(F(u * static_cast<float>(row.cells)), static_cast<float>(row.cells - 1)));
  Int<F> cell =
      std::bit_cast<Int<F>>(gather(reinterpret_cast<const float*>(row.guide), row.firstGuide + step));
  for (;;) {
    const Int<F> next = cell + 1;
    const Mask<F> inside = toMask(next < row.cells);
    const Mask<F> below = inside && gather(row.cdf, row.firstSum + select(inside, next, cell)) <= u;
    if (!any(below)) return cell;
    cell = select(below, next, cell);
  }
}

// Inverts the sums: a point in [0,1), its cell and density.
template <class F>
struct Found {
  F x, pdf;
  Int<F> cell;
};
template <class F>
Found<F> invert(const Row<F>& row, F u) {
  using namespace lane_math;
  const Int<F> cell = cellAt<F>(row, u), at = row.firstSum + cell;
  const F low = gather(row.cdf, at), span = gather(row.cdf, at + 1) - low;
  const F within = select(span > 0.0f, clamp(F((u - low) / span), 0.0f, kOneMinusEpsilon), F(0.5f));
  const float n = static_cast<float>(row.cells);
  return {min((toFloats(cell) + within) * (1 / n), kOneMinusEpsilon), span * n, cell};
}

}  // namespace

Distribution2D::Distribution2D(std::span<const float> weights, int width, int height)
    : width_(width), height_(height) {
  const auto w = static_cast<std::size_t>(width);
  std::vector<float> sums;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
    sums.push_back(addRow(weights.subspan(y * w, w)));
  mean_ = addRow(sums);
}

float Distribution2D::addRow(std::span<const float> weights) {
  double sum = 0;
  for (const float w : weights) sum += static_cast<double>(w);
  const auto n = static_cast<double>(weights.size());
  double running = 0;
  const auto first = static_cast<std::ptrdiff_t>(cdf_.size());
  cdf_.push_back(0.0f);
  for (const float w : weights) {
    running += sum > 0 ? static_cast<double>(w) / sum : 1 / n;
    cdf_.push_back(static_cast<float>(running));
  }
  // Cells of weight 0 at the end must stay empty: lift them to 1 together with the last one that has weight.
  const float last = cdf_.back();
  for (auto it = cdf_.end(); it != cdf_.begin() + first && *(it - 1) == last; --it) *(it - 1) = 1.0f;
  const auto cells = static_cast<std::int32_t>(weights.size());
  std::int32_t cell = 0;
  for (std::int32_t step = 0; step < cells; ++step) {
    // A hair less, lest rounding lead past a cell.
    const float u = static_cast<float>(step) / static_cast<float>(cells) * (1 - 1e-6f);
    while (cell + 1 < cells && cdf_[static_cast<std::size_t>(first + cell + 1)] <= u) ++cell;
    guide_.push_back(cell);
  }
  return static_cast<float>(sum / n);
}

template <class F>
auto Distribution2D::sample(const Vec2T<F>& u) const -> Sample<F> {
  const Row<F> rows{cdf_.data(), guide_.data(), height_ * (width_ + 1), height_ * width_, height_};
  const Found<F> y = invert<F>(rows, u.y);
  const Row<F> row{cdf_.data(), guide_.data(), y.cell * (width_ + 1), y.cell * width_, width_};
  const Found<F> x = invert<F>(row, u.x);
  return {{x.x, y.x}, x.pdf * y.pdf};
}

template <class F>
F Distribution2D::pdf(const Vec2T<F>& p) const {
  using namespace lane_math;
  const float w = static_cast<float>(width_), h = static_cast<float>(height_);
  const Int<F> x = toInt(clamp(F(p.x * w), 0.0f, w - 1)), y = toInt(clamp(F(p.y * h), 0.0f, h - 1));
  const float* cdf = cdf_.data();
  const Int<F> inRow = y * (width_ + 1) + x, ofRows = y + height_ * (width_ + 1);
  return (gather(cdf, inRow + 1) - gather(cdf, inRow)) * (gather(cdf, ofRows + 1) - gather(cdf, ofRows)) *
         (w * h);
}

template Distribution2D::Sample<float> Distribution2D::sample(const Vec2f&) const;
template Distribution2D::Sample<Floats> Distribution2D::sample(const LaneVec2&) const;
template float Distribution2D::pdf(const Vec2f&) const;
template Floats Distribution2D::pdf(const LaneVec2&) const;

}  // namespace idap::render
