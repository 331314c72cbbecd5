// What a boundary between two clear materials reflects, and what a thin sheet of one does.
// Unpolarized light; cosines of the angle to the normal, 0..1; ior relative (inside / outside).
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

template <class F>
struct FresnelTermsT {
  F s, p;          // reflectance of the two polarizations
  F cosineInside;  // 0 with s == p == 1: total reflection
};
using FresnelTerms = FresnelTermsT<float>;

template <class F>
FresnelTermsT<F> fresnelTerms(F cosine, F ior) {
  using namespace lane_math;
  const F sin2 = (1.0f - cosine * cosine) / (ior * ior);
  const Mask<F> total = sin2 >= 1.0f;
  const F inside = sqrt(max(1.0f - sin2, 0.0f));
  const F rs = (cosine - ior * inside) / (cosine + ior * inside);
  const F rp = (ior * cosine - inside) / (ior * cosine + inside);
  return {select(total, F(1.0f), rs * rs), select(total, F(1.0f), rp * rp), only(!total, inside)};
}

template <class F>
F fresnelDielectric(F cosine, F ior) {
  const FresnelTermsT<F> r = fresnelTerms(cosine, ior);
  return 0.5f * (r.s + r.p);
}

// A sheet too thin to shift the ray, with every inter-reflection between its faces: 2R / (1 + R), each
// polarization by itself.
template <class F>
F fresnelSheet(F cosine, F ior) {
  const FresnelTermsT<F> r = fresnelTerms(cosine, ior);
  return r.s / (1.0f + r.s) + r.p / (1.0f + r.p);
}

// The sheet at normal incidence, of the reflectance f0 of one face.
template <class F>
F sheetF0(F f0) {
  return 2.0f * f0 / (1.0f + f0);
}

// Schlick's (1 - cosine)^5.
template <class F>
F schlickWeight(F cosine) {
  const F a = lane_math::clamp(F(1.0f - cosine), 0.0f, 1.0f);
  const F a2 = a * a;
  return a2 * a2 * a;
}

}  // namespace idap::render
