// The random numbers of one pixel sample: Sobol points, Owen-scrambled by hashing, every pair of dimensions
// shuffled by itself. Pixels take consecutive stretches of one sequence along a shuffled Z curve, so that
// neighbours' errors are spread as blue noise. Sources: Burley 2020, "Practical hash-based Owen scrambling";
// Ahmed and Wonka 2020, "Screen-space blue-noise diffusion of Monte Carlo sampling error via hierarchical
// ordering of pixels". A sampler is a value; equal arguments give equal numbers, alone or in a lane.
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

// F: float, or Floats for one sampler a lane.
template <class F>
struct SamplerT {
  Word<F> reversedIndex;  // of the point in the sequence, its bits reversed
  Word<F> seed;
  Word<F> dimension;

  Vec2T<F> get2D();
  F get1D();
};

struct Sampler : SamplerT<float> {
  // log2Samples: how many samples a pixel will take, 0..16; further ones start afresh, independently.
  Sampler(int x, int y, std::uint32_t sample, int log2Samples, std::uint64_t seed);
};
using LaneSampler = SamplerT<Floats>;
// Sampler(x, y, sample, log2Samples, seed) for every lane's pixel. x, y: at least 0.
LaneSampler samplersOf(const Ints& x, const Ints& y, std::uint32_t sample, int log2Samples,
                       std::uint64_t seed);

extern template struct SamplerT<float>;
extern template struct SamplerT<Floats>;

}  // namespace idap::render
