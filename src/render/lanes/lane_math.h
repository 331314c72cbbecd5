// Functions on single numbers and lanes alike. Angles in radians.
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

// 1 / sqrt(x) within an ulp or two, for x from 1e-30 to 1e30.
inline float inverseSqrt(float x) { return 1.0f / std::sqrt(x); }
IDAP_INLINE Floats inverseSqrt(Floats x) {
#if defined(__AVX512F__)
  // The processor's estimate, and a step of Newton's.
  const Floats y(_mm512_rsqrt14_ps(static_cast<__m512>(x)));
  return y * (1.5f - 0.5f * x * y * y);
#else
  return 1.0f / simd::sqrt(x);
#endif
}

// 1 / x within an ulp or two, for |x| from 1e-36 to 1e36.
inline float reciprocal(float x) { return 1.0f / x; }
IDAP_INLINE Floats reciprocal(Floats x) {
#if defined(__AVX512F__)
  const Floats y(_mm512_rcp14_ps(static_cast<__m512>(x)));
  return y * (2.0f - x * y);
#else
  return 1.0f / x;
#endif
}

// Of lengths from 1e-15 to 1e15.
IDAP_INLINE LaneVec normalized(const LaneVec& v) { return v * inverseSqrt(dot(v, v)); }

// Sine and cosine for |x| up to some hundreds; off by less than 2e-7.
template <class F>
void sinCos(F x, F& sine, F& cosine) {
  using namespace lane_math;
  // To [-pi/4, pi/4] by quarter turns (Cody and Waite 1980), then Chebyshev fits of Cephes' single precision.
  const F turns = floor(x * 0.63661977236f + 0.5f);
  const Int<F> quadrant = toInt(turns);
  F r = x - turns * 1.5703125f;
  r = r - turns * 4.837512969970703125e-4f;
  r = r - turns * 7.549789948768648e-8f;
  const F r2 = r * r;
  const F s = r + r * r2 * (-1.6666654611e-1f + r2 * (8.3321608736e-3f - r2 * 1.9515295891e-4f));
  const F c = 1.0f - 0.5f * r2 +
              r2 * r2 * (4.166664568298827e-2f + r2 * (-1.388731625493765e-3f + r2 * 2.443315711809948e-5f));
  const Mask<F> odd = toMask((quadrant & 1) != 0);
  const F a = select(odd, c, s), b = select(odd, s, c);
  sine = select(toMask((quadrant & 2) != 0), -a, a);
  cosine = select(toMask(((quadrant + 1) & 2) != 0), -b, b);
}

// Source of the fits: Abramowitz and Stegun 1964, 4.4.46 and 4.4.49, both within 3e-8.
template <class F>
F arcCosine(F x) {
  using namespace lane_math;
  const F a = abs(x);
  F p = -0.0012624911f * a + 0.0066700901f;
  p = p * a - 0.0170881256f;
  p = p * a + 0.0308918810f;
  p = p * a - 0.0501743046f;
  p = p * a + 0.0889789874f;
  p = p * a - 0.2145988016f;
  p = p * a + 1.5707963050f;
  const F r = p * sqrt(max(1.0f - a, 0.0f));
  return select(x < 0.0f, 3.14159265359f - r, r);
}

template <class F>
F arcTangent2(F y, F x) {
  using namespace lane_math;
  const F ax = abs(x), ay = abs(y);
  const F t = min(ax, ay) / max(max(ax, ay), 1e-30f), t2 = t * t;
  F p = 0.0028662257f * t2 - 0.0161657367f;
  p = p * t2 + 0.0429096138f;
  p = p * t2 - 0.0752896400f;
  p = p * t2 + 0.1065626393f;
  p = p * t2 - 0.1420889944f;
  p = p * t2 + 0.1999355085f;
  p = p * t2 - 0.3333314528f;
  F angle = (p * t2 + 1.0f) * t;
  angle = select(ay > ax, 1.57079632679f - angle, angle);
  angle = select(x < 0.0f, 3.14159265359f - angle, angle);
  return copysign(angle, y);
}

}  // namespace idap::render
