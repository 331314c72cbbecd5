// What a boundary between two clear materials reflects, and what a thin sheet of one does.
// Unpolarized light; cosines of the angle to the normal, 0..1; ior relative (inside / outside).
#pragma once

#include <algorithm>
#include <cmath>

namespace idap::render {

struct FresnelTerms {
  float s = 1.0f, p = 1.0f;   // reflectance of the two polarizations
  float cosineInside = 0.0f;  // 0 with s == p == 1: total reflection
};

inline FresnelTerms fresnelTerms(float cosine, float ior) {
  const float sin2 = (1 - cosine * cosine) / (ior * ior);
  if (sin2 >= 1) return {};
  const float inside = std::sqrt(1 - sin2);
  const float rs = (cosine - ior * inside) / (cosine + ior * inside);
  const float rp = (ior * cosine - inside) / (ior * cosine + inside);
  return {rs * rs, rp * rp, inside};
}

inline float fresnelDielectric(float cosine, float ior) {
  const FresnelTerms r = fresnelTerms(cosine, ior);
  return 0.5f * (r.s + r.p);
}

// A sheet too thin to shift the ray, with every inter-reflection between its faces: 2R / (1 + R), each
// polarization by itself.
inline float fresnelSheet(float cosine, float ior) {
  const FresnelTerms r = fresnelTerms(cosine, ior);
  return r.s / (1 + r.s) + r.p / (1 + r.p);
}

// The sheet at normal incidence, of the reflectance f0 of one face.
inline float sheetF0(float f0) { return 2 * f0 / (1 + f0); }

// Schlick's (1 - cosine)^5.
inline float schlickWeight(float cosine) {
  const float a = std::clamp(1 - cosine, 0.0f, 1.0f);
  const float a2 = a * a;
  return a2 * a2 * a;
}

}  // namespace idap::render
