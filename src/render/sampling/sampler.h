// The random numbers of one pixel sample: Sobol points, Owen-scrambled by hashing, every pair of dimensions
// shuffled by itself. Pixels take consecutive stretches of one sequence along a shuffled Z curve, so that
// neighbours' errors are spread as blue noise. Sources: Burley 2020, "Practical hash-based Owen scrambling";
// Ahmed and Wonka 2020, "Screen-space blue-noise diffusion of Monte Carlo sampling error via hierarchical
// ordering of pixels". A sampler is a value; equal arguments give equal numbers.
#pragma once

#include <cstdint>

#include "geometry/vec.h"

namespace idap::render {

class Sampler {
 public:
  // log2Samples: how many samples a pixel will take, 0..16; further ones start afresh, independently.
  Sampler(int x, int y, std::uint32_t sample, int log2Samples, std::uint64_t seed);

  Vec2f get2D();
  float get1D();

 private:
  std::uint32_t index_;
  std::uint32_t seed_;
  std::uint32_t dimension_ = 0;
};

}  // namespace idap::render
