#include "render/sampling/sampler.h"

#include <array>

namespace idap::render {

namespace {

std::uint32_t reverseBits(std::uint32_t v) {
  v = __builtin_bswap32(v);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v >> 4) & 0x0f0f0f0fu);
  v = ((v & 0x33333333u) << 2) | ((v >> 2) & 0x33333333u);
  return ((v & 0x55555555u) << 1) | ((v >> 1) & 0x55555555u);
}

// Carries information only from low bits to high ones, which on reversed bits is an Owen scramble. Constants
// of N. Vegdahl's variant of the Laine-Karras hash.
std::uint32_t nestedHash(std::uint32_t v, std::uint32_t seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

std::uint32_t mixBits(std::uint64_t v) {
  v ^= v >> 31;
  v *= 0x7fb5d329728ea185u;
  v ^= v >> 27;
  v *= 0x81dadef4bc2dd44du;
  v ^= v >> 33;
  return static_cast<std::uint32_t>(v);
}

std::uint64_t join(std::uint32_t high, std::uint32_t low) { return (std::uint64_t{high} << 32) | low; }

// Every second bit.
std::uint32_t spread(std::uint32_t v) {
  v &= 0xffffu;
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

// The second Sobol dimension (its direction numbers are Pascal's triangle modulo 2), a byte at a time and
// with the result's bits reversed, as the scramble wants them.
struct SecondDimension {
  std::array<std::array<std::uint32_t, 256>, 4> table{};
  constexpr SecondDimension() {
    std::uint32_t direction[32] = {};
    direction[0] = 0x80000000u;
    for (int i = 1; i < 32; ++i) direction[i] = direction[i - 1] ^ (direction[i - 1] >> 1);
    for (std::size_t byte = 0; byte < 4; ++byte)
      for (std::size_t value = 0; value < 256; ++value) {
        std::uint32_t sum = 0;
        for (std::size_t bit = 0; bit < 8; ++bit)
          if ((value >> bit) & 1u) sum ^= direction[8 * byte + bit];
        std::uint32_t reversed = 0;
        for (int bit = 0; bit < 32; ++bit) reversed |= ((sum >> bit) & 1u) << (31 - bit);
        table[byte][value] = reversed;
      }
  }
  std::uint32_t reversed(std::uint32_t i) const {
    return table[0][i & 255u] ^ table[1][(i >> 8) & 255u] ^ table[2][(i >> 16) & 255u] ^ table[3][i >> 24];
  }
};
constexpr SecondDimension kSecond;

float toUnit(std::uint32_t v) { return static_cast<float>(v >> 8) * 0x1p-24f; }

}  // namespace

Sampler::Sampler(int x, int y, std::uint32_t sample, int log2Samples, std::uint64_t seed) {
  const auto bits = static_cast<std::uint32_t>(log2Samples);
  const std::uint32_t epoch = sample >> bits;
  const std::uint32_t within = sample & ((1u << bits) - 1u);
  // The Z curve has room for a square of 2^(16 - bits/2) pixels; beyond it another seed starts.
  const std::uint32_t side = 16 - (bits + 1) / 2;
  const std::uint32_t mask = (1u << side) - 1u;
  const auto px = static_cast<std::uint32_t>(x), py = static_cast<std::uint32_t>(y);
  const std::uint32_t z = spread(px & mask) | (spread(py & mask) << 1);
  index_ = (z << bits) | within;
  seed_ = mixBits(join(mixBits(seed), mixBits(join(epoch, ((px >> side) << 16) ^ (py >> side)))));
}

Vec2f Sampler::get2D() {
  const std::uint32_t h0 = mixBits(join(seed_, dimension_++));
  const std::uint32_t h1 = h0 * 0x9e3779b1u + 0x7f4a7c15u, h2 = (h1 ^ (h1 >> 15)) * 0x85ebca6bu;
  // Shuffling scrambles the index, whose nesting runs from high to low bits: reverse, hash, reverse back.
  const std::uint32_t reversed = nestedHash(reverseBits(index_), h0);
  // The first Sobol dimension is the reversed index, so its reverse is the index itself.
  const std::uint32_t i = reverseBits(reversed);
  return {toUnit(reverseBits(nestedHash(i, h1))),
          toUnit(reverseBits(nestedHash(kSecond.reversed(i), h2 ^ (h2 >> 13))))};
}

// The first of a pair alone.
float Sampler::get1D() {
  const std::uint32_t h0 = mixBits(join(seed_, dimension_++));
  const std::uint32_t h1 = h0 * 0x9e3779b1u + 0x7f4a7c15u;
  return toUnit(reverseBits(nestedHash(reverseBits(nestedHash(reverseBits(index_), h0)), h1)));
}

}  // namespace idap::render
