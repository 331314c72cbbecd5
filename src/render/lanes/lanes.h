// Many paths at once, side by side in the lanes of vector registers: numbers, masks and vectors of lanes, by
// the standard's data-parallel types (ISO/IEC TS 19570:2018, section 9). What is written with Mask, select()
// and any() instead of branches works on single numbers and on lanes alike.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

#include "light/rgb.h"

#if defined(__AVX512F__) || defined(__AVX2__)
#include <immintrin.h>
#endif

namespace idap::render {

namespace simd = std::experimental;

// What is one or two instructions is never to be called.
#define IDAP_INLINE [[gnu::always_inline]] inline

using Floats = simd::native_simd<float>;
using Ints = simd::rebind_simd_t<std::int32_t, Floats>;
using Words = simd::rebind_simd_t<std::uint32_t, Floats>;
using LaneMask = Floats::mask_type;
inline constexpr int kLanes = static_cast<int>(Floats::size());
using LaneVec = Vec3T<Floats>;
using LaneVec2 = Vec2T<Floats>;

// The types that go with F, a float or Floats.
template <class F>
struct LaneTypes {
  using Mask = bool;
  using Int = std::int32_t;
  using Word = std::uint32_t;
};
template <>
struct LaneTypes<Floats> {
  using Mask = LaneMask;
  using Int = Ints;
  using Word = Words;
};
template <class F>
using Mask = typename LaneTypes<F>::Mask;
template <class F>
using Int = typename LaneTypes<F>::Int;
template <class F>
using Word = typename LaneTypes<F>::Word;
template <class F>
inline constexpr bool kIsLanes = std::is_same_v<F, Floats>;

inline bool any(bool m) { return m; }
IDAP_INLINE bool any(LaneMask m) { return simd::any_of(m); }
inline bool every(bool m) { return m; }
IDAP_INLINE bool every(LaneMask m) { return simd::all_of(m); }

// Comparisons of whole numbers give masks of their own kind; these turn one into the other. (In the technical
// specification only masks of simd_abi::fixed_size can be; libstdc++ offers the rest as an extension.)
inline bool toMask(bool m) { return m; }
template <class T, class Abi>
IDAP_INLINE LaneMask toMask(const simd::simd_mask<T, Abi>& m) {
  return simd::__proposed::static_simd_cast<LaneMask>(m);
}
template <class T>
IDAP_INLINE typename T::mask_type maskOf(LaneMask m) {
  return simd::__proposed::static_simd_cast<typename T::mask_type>(m);
}

inline float select(bool m, float a, float b) { return m ? a : b; }
inline std::int32_t select(bool m, std::int32_t a, std::int32_t b) { return m ? a : b; }
inline std::uint32_t select(bool m, std::uint32_t a, std::uint32_t b) { return m ? a : b; }
IDAP_INLINE Floats select(LaneMask m, Floats a, Floats b) {
  where(m, b) = a;
  return b;
}
IDAP_INLINE Ints select(LaneMask m, Ints a, Ints b) {
  where(maskOf<Ints>(m), b) = a;
  return b;
}
IDAP_INLINE Words select(LaneMask m, Words a, Words b) {
  where(maskOf<Words>(m), b) = a;
  return b;
}
template <class F>
IDAP_INLINE Vec3T<F> select(const std::type_identity_t<Mask<F>>& m, const Vec3T<F>& a, const Vec3T<F>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
// a where the mask is set, else 0.
inline float only(bool m, float a) { return m ? a : 0.0f; }
IDAP_INLINE Floats only(LaneMask m, Floats a) {
  where(!m, a) = 0.0f;
  return a;
}
template <class F>
IDAP_INLINE Vec3T<F> only(const std::type_identity_t<Mask<F>>& m, const Vec3T<F>& a) {
  return {only(m, a.x), only(m, a.y), only(m, a.z)};
}

inline std::int32_t toInt(float v) { return static_cast<std::int32_t>(v); }
IDAP_INLINE Ints toInt(Floats v) { return simd::static_simd_cast<Ints>(v); }
inline float toFloats(std::int32_t v) { return static_cast<float>(v); }
IDAP_INLINE Floats toFloats(Ints v) { return simd::static_simd_cast<Floats>(v); }
// 0 <= v < 2^31.
inline float toFloats(std::uint32_t v) { return static_cast<float>(static_cast<std::int32_t>(v)); }
IDAP_INLINE Floats toFloats(Words v) {
  return simd::static_simd_cast<Floats>(simd::static_simd_cast<Ints>(v));
}

// The same value in every lane.
IDAP_INLINE Floats broadcast(float v) {
#if defined(__AVX512F__)
  return Floats(_mm512_set1_ps(v));
#elif defined(__AVX2__)
  return Floats(_mm256_set1_ps(v));
#else
  return Floats(v);
#endif
}

// Names that std and the lanes share, for code on either.
namespace lane_math {
using simd::abs;
using simd::copysign;
using simd::floor;
using simd::max;
using simd::min;
using simd::sqrt;
inline float abs(float v) { return std::fabs(v); }
inline float copysign(float a, float b) { return std::copysign(a, b); }
inline float floor(float v) { return std::floor(v); }
inline float sqrt(float v) { return std::sqrt(v); }
inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
IDAP_INLINE Floats min(Floats a, float b) { return simd::min(a, broadcast(b)); }
IDAP_INLINE Floats max(Floats a, float b) { return simd::max(a, broadcast(b)); }
template <class F>
IDAP_INLINE F clamp(F v, float low, float high) {
  return min(max(v, low), high);
}
}  // namespace lane_math

// base[index], lane by lane. Every index must be one that can be read.
inline float gather(const float* base, std::int32_t index) { return base[index]; }
IDAP_INLINE Floats gather(const float* base, Ints index) {
#if defined(__AVX512F__)
  return Floats(_mm512_i32gather_ps(static_cast<__m512i>(index), base, 4));
#elif defined(__AVX2__)
  return Floats(_mm256_i32gather_ps(base, static_cast<__m256i>(index), 4));
#else
  return Floats([&](auto k) { return base[index[k]]; });
#endif
}

IDAP_INLINE Floats luminance(const LaneVec& c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }
IDAP_INLINE Floats maxComponent(const LaneVec& c) { return simd::max(c.x, simd::max(c.y, c.z)); }

// Numbers that are written one by one and read as lanes.
struct alignas(sizeof(Floats)) LaneArray {
  float value[kLanes];
  float& operator[](int k) { return value[k]; }
  LaneArray() = default;
  LaneArray(Floats v) { v.copy_to(value, simd::element_aligned); }
  operator Floats() const { return Floats(value, simd::element_aligned); }
};
struct LaneArray3 {
  LaneArray x, y, z;
  LaneArray3() = default;
  LaneArray3(const LaneVec& v) : x(v.x), y(v.y), z(v.z) {}
  void set(int k, Vec3f v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
  operator LaneVec() const { return {x, y, z}; }
};
// A bit for every lane that the mask has, the first lane's lowest.
IDAP_INLINE std::uint32_t bitsOf(LaneMask mask) {
#if defined(__AVX512F__)
  return _mm512_cmplt_ps_mask(static_cast<__m512>(only(mask, Floats(-1.0f))), _mm512_setzero_ps());
#elif defined(__AVX2__)
  return static_cast<std::uint32_t>(_mm256_movemask_ps(static_cast<__m256>(only(mask, Floats(-1.0f)))));
#else
  std::uint32_t bits = 0;
  for (int k = 0; k < kLanes; ++k) bits |= static_cast<std::uint32_t>(mask[static_cast<std::size_t>(k)]) << k;
  return bits;
#endif
}
// f(lane) for every lane that the mask has, in order.
template <class Function>
void forLanes(LaneMask mask, Function&& f) {
  for (std::uint32_t bits = bitsOf(mask); bits != 0; bits &= bits - 1) f(std::countr_zero(bits));
}
inline LaneVec toLanes(Vec3f v) { return {broadcast(v.x), broadcast(v.y), broadcast(v.z)}; }
inline float lane(const Floats& v, int k) { return v[static_cast<std::size_t>(k)]; }
inline std::int32_t lane(const Ints& v, int k) { return v[static_cast<std::size_t>(k)]; }
inline std::uint32_t lane(const Words& v, int k) { return v[static_cast<std::size_t>(k)]; }
inline bool lane(const LaneMask& v, int k) { return v[static_cast<std::size_t>(k)]; }
inline Vec3f lane(const LaneVec& v, int k) { return {lane(v.x, k), lane(v.y, k), lane(v.z, k)}; }

// A vector with the same value in every lane, or itself.
template <class F>
IDAP_INLINE Vec3T<F> spread(Vec3f v) {
  if constexpr (kIsLanes<F>)
    return {broadcast(v.x), broadcast(v.y), broadcast(v.z)};
  else
    return v;
}

}  // namespace idap::render
