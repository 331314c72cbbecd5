// Piecewise-constant densities over [0,1) and [0,1)^2, sampled by inverting their cumulative sums.
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace idap::render {

class Distribution1D {
 public:
  Distribution1D() = default;
  // Weights >= 0; where all are 0 the density is uniform.
  explicit Distribution1D(std::span<const float> weights);

  struct Sample {
    float x = 0.0f;
    float pdf = 0.0f;
    int cell = 0;
  };
  Sample sample(float u) const;
  float pdf(int cell) const {
    return (cdf_[cell1(cell)] - cdf_[cell1(cell) - 1]) * static_cast<float>(size());
  }
  int size() const { return static_cast<int>(cdf_.size()) - 1; }
  float mean() const { return mean_; }  // of the weights

 private:
  static std::size_t cell1(int cell) { return static_cast<std::size_t>(cell) + 1; }
  std::vector<float> cdf_;
  float mean_ = 0.0f;
};

// Rows along y, columns along x.
class Distribution2D {
 public:
  Distribution2D() = default;
  Distribution2D(std::span<const float> weights, int width, int height);

  struct Sample {
    Vec2f point;
    float pdf = 0.0f;
  };
  Sample sample(Vec2f u) const;
  float pdf(Vec2f point) const;
  bool empty() const { return rows_.empty(); }
  float mean() const { return marginal_.mean(); }

 private:
  std::vector<Distribution1D> rows_;
  Distribution1D marginal_;
};

}  // namespace idap::render
