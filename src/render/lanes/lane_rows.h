// Rows of sixteen numbers, one a lane, read as sixteen times one number of all lanes.
#pragma once

#include <array>

#include "render/lanes/lanes.h"

namespace idap::render {

// Row: of 16 numbers of four bytes, aligned to 64 bytes.
template <class Row>
std::array<Floats, 16> fetchWords(const std::array<const Row*, kLanes>& rows) {
  static_assert(sizeof(Row) == 16 * sizeof(float) && alignof(Row) == 64);
  std::array<Floats, 16> words;
#if defined(__AVX512F__)
  // A transposition of 16 by 16, by ever larger parts.
  const auto low = [](__m512 a, __m512 b) { return _mm512_maskz_unpacklo_ps(0xffff, a, b); };
  const auto high = [](__m512 a, __m512 b) { return _mm512_maskz_unpackhi_ps(0xffff, a, b); };
  const auto low2 = [](__m512 a, __m512 b) {
    return _mm512_castpd_ps(_mm512_maskz_unpacklo_pd(0xff, _mm512_castps_pd(a), _mm512_castps_pd(b)));
  };
  const auto high2 = [](__m512 a, __m512 b) {
    return _mm512_castpd_ps(_mm512_maskz_unpackhi_pd(0xff, _mm512_castps_pd(a), _mm512_castps_pd(b)));
  };
  __m512 r[16], s[16];
  for (std::size_t k = 0; k < 16; ++k) r[k] = _mm512_load_ps(static_cast<const void*>(rows[k]));
  for (std::size_t k = 0; k < 16; k += 2) s[k] = low(r[k], r[k + 1]), s[k + 1] = high(r[k], r[k + 1]);
  // r[4 g + w] has, in its part of four numbers p, the word 4 p + w of the lanes 4 g to 4 g + 3.
  for (std::size_t g = 0; g < 16; g += 4) {
    r[g] = low2(s[g], s[g + 2]), r[g + 1] = high2(s[g], s[g + 2]);
    r[g + 2] = low2(s[g + 1], s[g + 3]), r[g + 3] = high2(s[g + 1], s[g + 3]);
  }
  for (std::size_t w = 0; w < 4; ++w) {
    const __m512 a = _mm512_maskz_shuffle_f32x4(0xffff, r[w], r[w + 4], 0x44),
                 b = _mm512_maskz_shuffle_f32x4(0xffff, r[w + 8], r[w + 12], 0x44),
                 c = _mm512_maskz_shuffle_f32x4(0xffff, r[w], r[w + 4], 0xee),
                 d = _mm512_maskz_shuffle_f32x4(0xffff, r[w + 8], r[w + 12], 0xee);
    words[w] = Floats(_mm512_maskz_shuffle_f32x4(0xffff, a, b, 0x88));
    words[w + 4] = Floats(_mm512_maskz_shuffle_f32x4(0xffff, a, b, 0xdd));
    words[w + 8] = Floats(_mm512_maskz_shuffle_f32x4(0xffff, c, d, 0x88));
    words[w + 12] = Floats(_mm512_maskz_shuffle_f32x4(0xffff, c, d, 0xdd));
  }
#else
  for (std::size_t w = 0; w < words.size(); ++w)
    words[w] =
        Floats([&](auto k) { return reinterpret_cast<const float*>(rows[static_cast<std::size_t>(k)])[w]; });
#endif
  return words;
}

}  // namespace idap::render
