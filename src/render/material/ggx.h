// The GGX (Trowbridge-Reitz) microfacet distribution, isotropic, with Smith's height-correlated shadowing.
// Directions in the local frame, z along the normal. Sources: Walter et al. 2007, "Microfacet models for
// refraction through rough surfaces"; Heitz 2014, "Understanding the masking-shadowing function";
// Dupuy and Benyoub 2023, "Sampling visible GGX normals with spherical caps".
#pragma once

#include "render/sampling/warp.h"

namespace idap::render {

template <class F>
struct GgxT {
  using V = Vec3T<F>;
  F alpha;

  F d(const V& h) const {
    const F a2 = alpha * alpha;
    const F k = h.x * h.x + h.y * h.y + a2 * h.z * h.z;
    return a2 * reciprocal(kPiF * k * k);
  }
  F lambda(const V& w) const {
    using namespace lane_math;
    const F c2 = w.z * w.z;
    const F inside = 1.0f + alpha * alpha * (w.x * w.x + w.y * w.y) * reciprocal(max(c2, 1e-30f));
    return select(c2 <= 0.0f, F(1e10f), 0.5f * (sqrt(inside) - 1.0f));
  }
  F g1(const V& w) const { return 1.0f / (1.0f + lambda(w)); }
  F g2(const V& wo, const V& wi) const { return 1.0f / (1.0f + lambda(wo) + lambda(wi)); }
  // Density of sampleVisible() over half vectors; wo.z > 0.
  F visiblePdf(const V& wo, const V& h) const {
    return g1(wo) * d(h) * lane_math::max(dot(wo, h), 0.0f) / wo.z;
  }
  // A microfacet normal that wo (z > 0) sees.
  V sampleVisible(const V& wo, const Vec2T<F>& u) const {
    using namespace lane_math;
    const V v = normalized(V{alpha * wo.x, alpha * wo.y, wo.z});
    const F z = (1.0f - u.y) * (1.0f + v.z) - v.z;
    const F r = sqrt(max(1.0f - z * z, 0.0f));
    F sine, cosine;
    sinCos(2 * kPiF * u.x, sine, cosine);
    const V h = V{r * cosine, r * sine, z} + v;
    return normalized(V{alpha * h.x, alpha * h.y, max(h.z, 1e-7f)});
  }
};
using Ggx = GgxT<float>;

}  // namespace idap::render
