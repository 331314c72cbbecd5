// Piecewise-constant densities over [0,1)^2, sampled by inverting their cumulative sums; for one number or
// for lanes of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/lanes/lanes.h"

namespace idap::render {

// Rows along y, columns along x.
class Distribution2D {
 public:
  Distribution2D() = default;
  // Weights >= 0; where all of a row, or all rows, are 0, the density is uniform there.
  Distribution2D(std::span<const float> weights, int width, int height);

  template <class F>
  struct Sample {
    Vec2T<F> point;
    F pdf;
  };
  template <class F>
  Sample<F> sample(const Vec2T<F>& u) const;
  template <class F>
  F pdf(const Vec2T<F>& point) const;
  bool empty() const { return height_ == 0; }
  float mean() const { return mean_; }  // of the weights

 private:
  // Adds the cumulative sums of the weights, from 0 to 1; returns their mean.
  float addRow(std::span<const float> weights);

  int width_ = 0, height_ = 0;
  float mean_ = 0.0f;
  std::vector<float> cdf_;  // width_ + 1 numbers a row, then height_ + 1 for the choice of the row
  // As many numbers as cells a row: for even steps of the random number, the cell where to begin to look for
  // it (Chen and Asau 1974, "On generating random variates from an empirical distribution").
  std::vector<std::int32_t> guide_;
};

}  // namespace idap::render
