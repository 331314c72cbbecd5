#include "render/sampling/sampler.h"

namespace idap::render {

namespace {

template <class W>
W reverseBits(W v) {
#if defined(__AVX512F__) && defined(__AVX512BW__) && defined(__GFNI__)
  if constexpr (std::is_same_v<W, Words>) {
    // The bits of every byte by a product of matrices, then the bytes.
    const __m512i bits =
        _mm512_gf2p8affine_epi64_epi8(static_cast<__m512i>(v), _mm512_set1_epi64(0x8040201008040201), 0);
    const __m512i bytes = _mm512_set4_epi32(0x0c0d0e0f, 0x08090a0b, 0x04050607, 0x00010203);
    return Words(_mm512_shuffle_epi8(bits, bytes));
  }
#endif
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00ff00ffu) << 8) | ((v >> 8) & 0x00ff00ffu);
  v = ((v & 0x0f0f0f0fu) << 4) | ((v >> 4) & 0x0f0f0f0fu);
  v = ((v & 0x33333333u) << 2) | ((v >> 2) & 0x33333333u);
  return ((v & 0x55555555u) << 1) | ((v >> 1) & 0x55555555u);
}

// Carries information only from low bits to high ones, which on reversed bits is an Owen scramble. Constants
// of N. Vegdahl's variant of the Laine-Karras hash.
template <class W>
W nestedHash(W v, W seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

// Every bit of the result depends on every bit of v. Constants found by search: C. Wellons and TheIronBorn,
// "Prospecting for hash functions".
template <class W>
W mixWord(W v) {
  v ^= v >> 16;
  v *= 0x21f0aaadu;
  v ^= v >> 15;
  v *= 0xd35a2d97u;
  v ^= v >> 15;
  return v;
}

// The second Sobol dimension of a point, its bits reversed, as the scramble wants them. Its direction numbers
// are Pascal's triangle modulo 2, where C(i, j) is odd if all bits of j are set in i (Lucas 1878): bit j of
// the result is the parity of all bits of v whose places contain j's.
template <class W>
W secondReversed(W v) {
  v ^= (v >> 16) & 0x0000ffffu;
  v ^= (v >> 8) & 0x00ff00ffu;
  v ^= (v >> 4) & 0x0f0f0f0fu;
  v ^= (v >> 2) & 0x33333333u;
  v ^= (v >> 1) & 0x55555555u;
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
template <class W>
W spreadBits(W v) {
  v &= 0xffffu;
  v = (v | (v << 8)) & 0x00ff00ffu;
  v = (v | (v << 4)) & 0x0f0f0f0fu;
  v = (v | (v << 2)) & 0x33333333u;
  return (v | (v << 1)) & 0x55555555u;
}

template <class F>
F toUnit(Word<F> v) {
  return toFloats(Word<F>(v >> 8)) * 0x1p-24f;
}

// A pixel's place in the sequences.
struct Curve {
  int bits;  // of a pixel's samples
  // The Z curve has room for a square of 2^(16 - bits/2) pixels; beyond it another seed starts.
  int side;
  std::uint32_t epoch, within;
  std::uint64_t pictureSeed;

  Curve(std::uint32_t sample, int log2Samples, std::uint64_t picture)
      : bits(log2Samples),
        side(16 - (log2Samples + 1) / 2),
        epoch(sample >> bits),
        within(sample & ((1u << bits) - 1u)),
        pictureSeed(picture) {}
  template <class W>
  W reversedIndex(W x, W y) const {
    const std::uint32_t mask = (1u << side) - 1u;
    const W z = spreadBits(W(x & mask)) | (spreadBits(W(y & mask)) << 1);
    return reverseBits(W((z << bits) | within));
  }
  template <class W>
  W square(W x, W y) const {
    return ((x >> side) << 16) ^ (y >> side);
  }
  std::uint32_t seedOf(std::uint32_t square) const {
    return mixBits(join(mixBits(pictureSeed), mixBits(join(epoch, square))));
  }
};

}  // namespace

Sampler::Sampler(int x, int y, std::uint32_t sample, int log2Samples, std::uint64_t pictureSeed) {
  const Curve curve(sample, log2Samples, pictureSeed);
  const auto px = static_cast<std::uint32_t>(x), py = static_cast<std::uint32_t>(y);
  dimension = 0;
  reversedIndex = curve.reversedIndex(px, py);
  seed = curve.seedOf(curve.square(px, py));
}

LaneSampler samplersOf(const Ints& x, const Ints& y, std::uint32_t sample, int log2Samples,
                       std::uint64_t pictureSeed) {
  const Curve curve(sample, log2Samples, pictureSeed);
  const Words px = simd::static_simd_cast<Words>(x), py = simd::static_simd_cast<Words>(y);
  const Words square = curve.square(px, py);
  LaneSampler s{curve.reversedIndex(px, py), curve.seedOf(lane(square, 0)), 0u};
  if (!simd::all_of(square == lane(square, 0)))
    s.seed = Words([&](auto k) { return curve.seedOf(lane(square, k)); });
  return s;
}

template <class F>
Vec2T<F> SamplerT<F>::get2D() {
  using W = Word<F>;
  const W h0 = mixWord(W(seed + dimension * 0x9e3779b9u));
  dimension += 1u;
  const W h1 = h0 * 0x9e3779b1u + 0x7f4a7c15u, h2 = (h1 ^ (h1 >> 15)) * 0x85ebca6bu;
  // Shuffling scrambles the index, whose nesting runs from high to low bits: hash it reversed, reverse back.
  // The first Sobol dimension is the reversed index, so its reverse is the index itself.
  const W i = reverseBits(nestedHash(reversedIndex, h0));
  return {toUnit<F>(reverseBits(nestedHash(i, h1))),
          toUnit<F>(reverseBits(nestedHash(secondReversed(i), W(h2 ^ (h2 >> 13)))))};
}

// The first of a pair alone.
template <class F>
F SamplerT<F>::get1D() {
  using W = Word<F>;
  const W h0 = mixWord(W(seed + dimension * 0x9e3779b9u));
  dimension += 1u;
  const W h1 = h0 * 0x9e3779b1u + 0x7f4a7c15u;
  return toUnit<F>(reverseBits(nestedHash(reverseBits(nestedHash(reversedIndex, h0)), h1)));
}

template struct SamplerT<float>;
template struct SamplerT<Floats>;

}  // namespace idap::render
