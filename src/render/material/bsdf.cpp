#include "render/material/bsdf.h"

#include "render/material/albedo_table.h"
#include "render/material/fresnel.h"
#include "render/material/ggx.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr float kInversePi = 1 / kPiF;
template <class F>
Vec3T<F> grey(F v) {
  return {v, v, v};
}
template <class F>
Vec3T<F> squareRoot(const Vec3T<F>& c) {
  using lane_math::sqrt;
  return {sqrt(c.x), sqrt(c.y), sqrt(c.z)};
}

}  // namespace

ShadingPoint<float> shadingPoint(const Interaction& at, const SurfaceValues& values) {
  const SurfaceData& s = *at.surface;
  return {at.ng, at.ns, values.baseColor, values.roughness, s.metalness, s.ior,
          s.f0,  s.f90, s.transmission,   s.translucency,   s.thin,      at.frontFace};
}

template <class F>
BsdfT<F>::BsdfT(const ShadingPoint<F>& s, const V& wo) : frame_(s.ns), ng_(s.ng), wo_(frame_.toLocal(wo)) {
  using namespace lane_math;
  const M averted = wo_.z < 1e-3f;
  if (any(averted)) {
    // The shading normal has turned away from the viewer: take the nearest direction that it does see.
    const F l2 = wo_.x * wo_.x + wo_.y * wo_.y, inverse = inverseSqrt(max(l2, 1e-30f));
    const V low = normalized(V{wo_.x * inverse, wo_.y * inverse, F(1e-3f)});
    wo_ = select(averted, select(l2 > 0.0f, low, spread<F>({0, 0, 1})), wo_);
  }
  const F cosine = min(wo_.z, 1.0f);
  alpha_ = s.roughness * s.roughness;
  smooth_ = alpha_ < kSmoothAlpha;
  roughness_ = only(!smooth_, s.roughness);
  eta_ = select(s.frontFace, reciprocal(s.ior), s.ior);

  const V c = s.baseColor;
  const F metal = s.metalness;
  const F clear = (1.0f - metal) * s.transmission;
  const F solid = only(!s.thin, clear), sheet = only(s.thin, clear);
  const F base = (1.0f - metal) * (1.0f - s.transmission);

  layerF0_ = s.f0;
  layerF90_ = s.f90;
  AlbedoTermsT<F> e{}, mean{};
  const M layered = s.f90 > 0.0f || metal > 0.0f;
  if (any(layered)) {
    const AlbedoTable& table = AlbedoTable::get();
    mean = table.average(roughness_);
    e = table.directional(cosine, roughness_);
    const F edge = schlickWeight(cosine);
    e.base = select(smooth_, 1.0f - edge, e.base);
    e.edge = select(smooth_, edge, e.edge);
  }

  // The mirror layer of all parts together. A smooth sheet reflects exactly; a rough one by Schlick's curve.
  const F sheetGlossy = only(!smooth_, sheet);
  const F dielectricF0 = base * s.f0 + sheetGlossy * sheetF0(s.f0);
  f0_ = grey(dielectricF0) + c * metal;
  f90_ = grey(F((base + sheetGlossy) * s.f90 + metal));
  V glossy = f0_ * e.base + f90_ * e.edge;
  sheetIor_ = s.ior;
  sheet_ = only(smooth_, sheet);
  straight_ = spread<F>({0, 0, 0});
  if (any(sheet > 0.0f)) {
    F reflected = sheetF0(s.f0) * e.base + s.f90 * e.edge;
    if (any(sheet_ > 0.0f)) {
      reflected = select(smooth_, fresnelSheet(cosine, s.ior), reflected);
      glossy += grey(F(sheet_ * reflected));
    }
    straight_ = c * F(sheet * (1.0f - reflected));
  }

  // What the layer lets through reaches the base; (1 - E) on the way in and on the way out.
  const F layerAlbedo = s.f0 * e.base + s.f90 * e.edge;
  const F layerMean = s.f0 * mean.base + s.f90 * mean.edge;
  baseScale_ = kInversePi * (1.0f - layerAlbedo) * reciprocal(1.0f - layerMean);
  reflectColor_ = c * F(base * (1.0f - s.translucency));
  throughColor_ = c * F(base * s.translucency);
  metalScale_ = 0.0f;
  metalColor_ = spread<F>({0, 0, 0});
  if (any(metal > 0.0f && !smooth_)) {
    const F lost = 1.0f - e.base - e.edge, lostMean = max(1.0f - mean.base - mean.edge, 1e-6f);
    metalScale_ = only(metal > 0.0f && !smooth_, kInversePi * lost / lostMean);
    const V f = c + (grey(F(1.0f)) - c) * F(1 / 21.0f);  // mean of Schlick's curve
    const V den = grey(F(1.0f)) - f * lostMean;
    metalColor_ = f * f * F(1.0f - lostMean) / den * metal;
  }
  glass_ = squareRoot(c) * solid;  // a ray passes two faces: in and out

  share_[kGlossy] = luminance(glossy);
  share_[kDiffuse] =
      luminance(reflectColor_) * (1.0f - layerAlbedo) + luminance(metalColor_) * metalScale_ * (kPiF * 0.5f);
  share_[kThrough] = luminance(throughColor_) * (1.0f - layerAlbedo);
  share_[kStraight] = luminance(straight_);
  share_[kGlass] = luminance(glass_);
  F sum = share_[0];
  for (int i = 1; i < kLobes; ++i) sum += share_[i];
  const F inverse = only(sum > 0.0f, reciprocal(max(sum, 1e-30f)));
  for (F& share : share_) share *= inverse;
}

template <class F>
auto BsdfT<F>::fresnel(F cosine) const -> V {
  return f0_ + (f90_ - f0_) * schlickWeight(cosine);
}

template <class F>
auto BsdfT<F>::albedo() const -> V {
  using lane_math::min;
  V sum = reflectColor_ + throughColor_ + metalColor_ + straight_ + glass_;
  sum += only(share_[kGlossy] > 0.0f, f0_ + f90_ * F(0.5f * schlickWeight(wo_.z)));
  return {min(sum.x, 1.0f), min(sum.y, 1.0f), min(sum.z, 1.0f)};
}

// Reflection by facets and base; both directions local, wo above.
template <class F>
BsdfValueT<F> BsdfT<F>::evalLocal(const V& wo, const V& wi) const {
  using namespace lane_math;
  BsdfValueT<F> r;
  const F cosine = abs(wi.z);
  AlbedoTermsT<F> e{};
  if (any(layerF90_ > 0.0f || metalScale_ > 0.0f)) e = AlbedoTable::get().directional(cosine, roughness_);
  const F below = baseScale_ * (1.0f - layerF0_ * e.base - layerF90_ * e.edge) * cosine;
  const M above = wi.z > 0.0f;
  r.value = select(above, reflectColor_, throughColor_) * below;
  r.pdf = select(above, share_[kDiffuse], share_[kThrough]) * cosine * kInversePi;
  if (any(above && metalScale_ > 0.0f))
    r.value += only(above, metalColor_ * F(metalScale_ * (1.0f - e.base - e.edge) * cosine));
  const M facets = above && !smooth_ && share_[kGlossy] > 0.0f;
  if (any(facets)) {
    const GgxT<F> ggx{alpha_};
    const V h = normalized(wo + wi);
    const F d = ggx.d(h), lo = ggx.lambda(wo), scale = 4.0f * wo.z;
    r.value += only(facets, fresnel(dot(wo, h)) * F(d * reciprocal((1.0f + lo + ggx.lambda(wi)) * scale)));
    r.pdf += only(facets, share_[kGlossy] * d * reciprocal((1.0f + lo) * scale));
  }
  return r;
}

// Rough solid glass, Walter et al. 2007; both directions local, wo above.
template <class F>
BsdfValueT<F> BsdfT<F>::evalGlass(const V& wo, const V& wi) const {
  using namespace lane_math;
  const GgxT<F> ggx{alpha_};
  const F ior = 1.0f / eta_;  // of the far side relative to wo's
  const M above = wi.z > 0.0f;
  V h = wo + wi * select(above, F(1.0f), ior);
  const F l2 = dot(h, h);
  h = h * F(1.0f / sqrt(max(l2, 1e-30f)));
  h = select(h.z < 0.0f && !above, -h, h);
  const F ci = dot(wi, h), co = dot(wo, h);
  const M possible = above || (l2 >= 1e-12f && wi.z != 0.0f && ci * co < 0.0f && co > 0.0f);
  const F f = fresnelDielectric(min(co, 1.0f), ior);
  const F den = ci * ior + co;
  const F common =
      ggx.d(h) * select(above, f / (4.0f * wo.z), (1.0f - f) * abs(ci * co / (den * den * wo.z)));
  // Radiance is squeezed by the index squared; per solid angle the Jacobian of wi carries ior^2 in the
  // density.
  BsdfValueT<F> r;
  r.value = only(possible, glass_ * F(common * ggx.g2(wo, wi)));
  r.pdf = only(possible, share_[kGlass] * common * select(above, F(1.0f), ior * ior) * ggx.g1(wo));
  return r;
}

template <class F>
BsdfValueT<F> BsdfT<F>::eval(const V& worldWi) const {
  const V wi = frame_.toLocal(worldWi);
  BsdfValueT<F> r = evalLocal(wo_, wi);
  const M roughGlass = share_[kGlass] > 0.0f && !smooth_;
  if (any(roughGlass)) {
    const BsdfValueT<F> g = evalGlass(wo_, wi);
    r.value += only(roughGlass, g.value);
    r.pdf += only(roughGlass, g.pdf);
  }
  // A normal from interpolation or a map may put wi on one side, the true surface on the other.
  const F outside = dot(worldWi, ng_);
  const M agree = wi.z != 0.0f && ((wi.z > 0.0f && outside > 0.0f) || (wi.z <= 0.0f && outside <= 0.0f));
  r.value = only(agree, r.value);
  r.pdf = only(agree, r.pdf);
  return r;
}

// Local; h is the facet. 0 where the way is not there.
template <class F>
auto BsdfT<F>::sampleGlass(F lobe, const V& h, F& etaScale) const -> V {
  using lane_math::min;
  const F c = min(dot(wo_, h), 1.0f);
  const FresnelTermsT<F> f = fresnelTerms(c, F(1.0f / eta_));
  const M reflected = lobe < 0.5f * (f.s + f.p);
  const V mirrored = h * F(2.0f * c) - wo_;
  const V refracted = normalized(h * F(c * eta_ - f.cosineInside) - wo_ * eta_);
  etaScale = select(reflected, F(1.0f), eta_ * eta_);
  const M there = c > 0.0f && ((reflected && mirrored.z > 0.0f) || (!reflected && refracted.z < 0.0f));
  return only(there, select(reflected, mirrored, refracted));
}

template <class F>
BsdfSampleT<F> BsdfT<F>::sample(F lobe, const Vec2T<F>& u) const {
  BsdfSampleT<F> r;
  // Which lobe each lane takes, and what is left of its random number.
  M in[kLobes], open(true);
  F share = 0.0f;
  for (int i = 0; i < kLobes; ++i) {
    in[i] = i + 1 < kLobes ? M(open && lobe < share_[i]) : open;
    share = select(in[i], share_[i], share);
    open = open && !in[i];
    lobe = select(open, lobe - share_[i], lobe);
  }
  const F inverse = 1.0f / share;  // of no use where the share is 0

  V wi = cosineHemisphere(u);
  wi.z = select(in[kThrough], -wi.z, wi.z);
  const M facets = in[kGlossy] || in[kGlass];
  if (any(facets)) {
    V h = spread<F>({0, 0, 1});
    if (any(facets && !smooth_)) h = select(smooth_, h, GgxT<F>{alpha_}.sampleVisible(wo_, u));
    const V mirrored = h * F(2.0f * dot(wo_, h)) - wo_;
    wi = select(in[kGlossy], only(mirrored.z > 0.0f, mirrored), wi);
    if (any(in[kGlass])) {
      F etaScale = 1.0f;
      const V through = sampleGlass(lane_math::min(F(lobe * inverse), kOneMinusEpsilon), h, etaScale);
      wi = select(in[kGlass], through, wi);
      r.etaScale = select(in[kGlass], etaScale, r.etaScale);
    }
  }
  wi = select(in[kStraight], -wo_, wi);
  const M there = share > 0.0f && dot(wi, wi) > 0.0f;
  r.wi = frame_.toWorld(wi);
  r.straight = in[kStraight];
  r.delta = in[kStraight] || (smooth_ && facets);
  if (!every(r.delta)) {
    const BsdfValueT<F> v = eval(r.wi);
    r.pdf = only(there, v.pdf);
    r.weight = only(r.pdf > 0.0f, v.value * F(1.0f / v.pdf));
  }
  if (any(r.delta)) {
    V weight = straight_;
    if (any(in[kGlossy] && smooth_)) {
      V mirrored = fresnel(wo_.z);
      if (any(sheet_ > 0.0f))
        mirrored += grey(only(sheet_ > 0.0f, sheet_ * fresnelSheet(lane_math::min(wo_.z, 1.0f), sheetIor_)));
      weight = select(in[kGlossy], mirrored, weight);
    }
    weight = select(in[kGlass], glass_ * r.etaScale, weight);
    // On the true surface's other side there is nothing to mirror, or to pass into.
    const M above = in[kGlossy] || r.etaScale == 1.0f;
    const F outside = dot(r.wi, ng_);
    const M agree = r.straight || (above && outside > 0.0f) || (!above && outside <= 0.0f);
    r.pdf = select(r.delta, only(there && agree, F(1.0f)), r.pdf);
    r.weight = select(r.delta, weight * inverse, r.weight);
  }
  return r;
}

template class BsdfT<float>;
template class BsdfT<Floats>;

}  // namespace idap::render
