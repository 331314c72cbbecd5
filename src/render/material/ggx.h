// The GGX (Trowbridge-Reitz) microfacet distribution, isotropic, with Smith's height-correlated shadowing.
// Directions in the local frame, z along the normal. Sources: Walter et al. 2007, "Microfacet models for
// refraction through rough surfaces"; Heitz 2014, "Understanding the masking-shadowing function";
// Dupuy and Benyoub 2023, "Sampling visible GGX normals with spherical caps".
#pragma once

#include <cmath>
#include <numbers>

#include "geometry/vec.h"

namespace idap::render {

struct Ggx {
  float alpha;

  float d(Vec3f h) const {
    const float a2 = alpha * alpha;
    const float k = (h.x * h.x + h.y * h.y) / a2 + h.z * h.z;
    return 1 / (std::numbers::pi_v<float> * a2 * k * k);
  }
  float lambda(Vec3f w) const {
    const float c2 = w.z * w.z;
    if (c2 <= 0) return 1e10f;
    return 0.5f * (std::sqrt(1 + alpha * alpha * (w.x * w.x + w.y * w.y) / c2) - 1);
  }
  float g1(Vec3f w) const { return 1 / (1 + lambda(w)); }
  float g2(Vec3f wo, Vec3f wi) const { return 1 / (1 + lambda(wo) + lambda(wi)); }
  // Density of sampleVisible() over half vectors; wo.z > 0.
  float visiblePdf(Vec3f wo, Vec3f h) const { return g1(wo) * d(h) * std::fmax(dot(wo, h), 0.0f) / wo.z; }
  // A microfacet normal that wo (z > 0) sees.
  Vec3f sampleVisible(Vec3f wo, Vec2f u) const {
    const Vec3f v = normalized(Vec3f{alpha * wo.x, alpha * wo.y, wo.z});
    const float phi = 2 * std::numbers::pi_v<float> * u.x;
    const float z = (1 - u.y) * (1 + v.z) - v.z;
    const float r = std::sqrt(std::fmax(0.0f, 1 - z * z));
    const Vec3f h = Vec3f{r * std::cos(phi), r * std::sin(phi), z} + v;
    return normalized(Vec3f{alpha * h.x, alpha * h.y, std::fmax(h.z, 1e-7f)});
  }
};

}  // namespace idap::render
