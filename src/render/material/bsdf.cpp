#include "render/material/bsdf.h"

#include <algorithm>

#include "render/material/albedo_table.h"
#include "render/material/fresnel.h"
#include "render/material/ggx.h"
#include "render/sampling/warp.h"

namespace idap::render {

namespace {

constexpr float kInversePi = 1 / kPiF;
Rgb grey(float v) { return {v, v, v}; }
Rgb squareRoot(Rgb c) { return {std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)}; }

}  // namespace

float Bsdf::schlick(float cosine) { return schlickWeight(cosine); }

Bsdf::Bsdf(const Interaction& at, const SurfaceValues& values, Vec3f wo)
    : frame_(at.ns), ng_(at.ng), wo_(frame_.toLocal(wo)) {
  const SurfaceData& s = *at.surface;
  if (wo_.z < 1e-3f) {
    // The shading normal has turned away from the viewer: take the nearest direction that it does see.
    wo_.z = 0;
    const float l2 = dot(wo_, wo_);
    wo_ = l2 > 0 ? normalized(wo_ * (1 / std::sqrt(l2)) + Vec3f{0, 0, 1e-3f}) : Vec3f{0, 0, 1};
  }
  const float cosine = std::min(wo_.z, 1.0f);
  roughness_ = values.roughness;
  alpha_ = roughness_ * roughness_;
  smooth_ = alpha_ < kSmoothAlpha;
  if (smooth_) roughness_ = 0;
  eta_ = at.frontFace ? 1 / s.ior : s.ior;

  const Rgb c = values.baseColor;
  const float metal = s.metalness;
  const float clear = (1 - metal) * s.transmission;
  const float solid = s.thin ? 0.0f : clear, sheet = s.thin ? clear : 0.0f;
  const float base = (1 - metal) * (1 - s.transmission);

  layerF0_ = s.f0;
  layerF90_ = s.f90;
  const bool layered = s.f90 > 0 || metal > 0;
  AlbedoTerms e{}, mean{};
  if (layered) {
    const AlbedoTable& table = AlbedoTable::get();
    mean = table.average(roughness_);
    e = smooth_ ? AlbedoTerms{1 - schlick(cosine), schlick(cosine)} : table.directional(cosine, roughness_);
  }

  // The mirror layer of all parts together. A smooth sheet reflects exactly; a rough one by Schlick's curve.
  const float sheetGlossy = smooth_ ? 0.0f : sheet;
  const float dielectricF0 = base * s.f0 + sheetGlossy * sheetF0(s.f0);
  f0_ = grey(dielectricF0) + c * metal;
  f90_ = grey((base + sheetGlossy) * s.f90 + metal);
  Rgb glossy = f0_ * e.base + f90_ * e.edge;
  float sheetReflected = 0;
  if (sheet > 0) {
    sheetIor_ = s.ior;
    sheetReflected = smooth_ ? fresnelSheet(cosine, s.ior) : sheetF0(s.f0) * e.base + s.f90 * e.edge;
    if (smooth_) {
      sheet_ = sheet;
      glossy += grey(sheet * sheetReflected);
    }
    straight_ = c * (sheet * (1 - sheetReflected));
  }

  // What the layer lets through reaches the base; (1 - E) on the way in and on the way out.
  const float layerAlbedo = s.f0 * e.base + s.f90 * e.edge;
  const float layerMean = s.f0 * mean.base + s.f90 * mean.edge;
  baseScale_ = kInversePi * (1 - layerAlbedo) / (1 - layerMean);
  reflectColor_ = c * (base * (1 - s.translucency));
  throughColor_ = c * (base * s.translucency);
  metalScale_ = 0;
  if (metal > 0 && !smooth_) {
    const float lost = 1 - e.base - e.edge, lostMean = std::max(1 - mean.base - mean.edge, 1e-6f);
    metalScale_ = kInversePi * lost / lostMean;
    const Rgb f = c + (grey(1) - c) * (1 / 21.0f);  // mean of Schlick's curve
    const Rgb den = grey(1) - f * lostMean;
    metalColor_ = f * f * (1 - lostMean) / den * metal;
  }
  glass_ = squareRoot(c) * solid;  // a ray passes two faces: in and out

  const float weights[kLobes] = {
      luminance(glossy),
      luminance(reflectColor_) * (1 - layerAlbedo) + luminance(metalColor_) * metalScale_ * kPiF * 0.5f,
      luminance(throughColor_) * (1 - layerAlbedo), luminance(straight_), luminance(glass_)};
  float sum = 0;
  for (const float w : weights) sum += w;
  if (sum > 0)
    for (int i = 0; i < kLobes; ++i) share_[i] = weights[i] / sum;
}

bool Bsdf::mostlySharp() const {
  const float sharp = share_[kStraight] + (smooth_ ? share_[kGlossy] + share_[kGlass] : 0.0f);
  return sharp > 0.5f;
}

Rgb Bsdf::albedo() const {
  Rgb sum = reflectColor_ + throughColor_ + metalColor_ + straight_ + glass_;
  if (share_[kGlossy] > 0) sum += f0_ + f90_ * (0.5f * schlick(wo_.z));
  return {std::min(sum.x, 1.0f), std::min(sum.y, 1.0f), std::min(sum.z, 1.0f)};
}

// Reflection by facets and base; both directions local, wo above.
BsdfValue Bsdf::evalLocal(Vec3f wo, Vec3f wi) const {
  BsdfValue r;
  const float cosine = std::fabs(wi.z);
  AlbedoTerms e{};
  if (layerF90_ > 0 || metalScale_ > 0) e = AlbedoTable::get().directional(cosine, roughness_);
  const float below = baseScale_ * (1 - layerF0_ * e.base - layerF90_ * e.edge) * cosine;
  if (wi.z <= 0) {
    r.value = throughColor_ * below;
    r.pdf = share_[kThrough] * cosine * kInversePi;
    return r;
  }
  r.value = reflectColor_ * below;
  if (metalScale_ > 0) r.value += metalColor_ * (metalScale_ * (1 - e.base - e.edge) * cosine);
  r.pdf = share_[kDiffuse] * cosine * kInversePi;
  if (!smooth_ && share_[kGlossy] > 0) {
    const Ggx ggx{alpha_};
    const Vec3f h = normalized(wo + wi);
    const float c = dot(wo, h);
    const float d = ggx.d(h), lo = ggx.lambda(wo);
    r.value += fresnel(c) * (d / ((1 + lo + ggx.lambda(wi)) * 4 * wo.z));
    r.pdf += share_[kGlossy] * d / ((1 + lo) * 4 * wo.z);
  }
  return r;
}

// Rough solid glass, Walter et al. 2007; both directions local, wo above.
BsdfValue Bsdf::evalGlass(Vec3f wo, Vec3f wi) const {
  BsdfValue r;
  const Ggx ggx{alpha_};
  const float ior = 1 / eta_;  // of the far side relative to wo's
  if (wi.z > 0) {
    const Vec3f h = normalized(wo + wi);
    const float f = fresnelDielectric(std::min(dot(wo, h), 1.0f), ior);
    const float common = f * ggx.d(h) / (4 * wo.z);
    r.value = glass_ * (common * ggx.g2(wo, wi));
    r.pdf = share_[kGlass] * common * ggx.g1(wo);
    return r;
  }
  Vec3f h = wo + wi * ior;
  const float l2 = dot(h, h);
  if (l2 < 1e-12f || wi.z == 0) return r;
  h = h * (1 / std::sqrt(l2));
  if (h.z < 0) h = -h;
  const float ci = dot(wi, h), co = dot(wo, h);
  if (ci * co >= 0 || co <= 0) return r;
  const float t = 1 - fresnelDielectric(std::min(co, 1.0f), ior);
  const float den = ci * ior + co;
  const float common = t * ggx.d(h) * std::fabs(ci * co / (den * den * wo.z));
  // Radiance is squeezed by the index squared; per solid angle the Jacobian of wi carries ior^2 in the
  // density.
  r.value = glass_ * (common * ggx.g2(wo, wi));
  r.pdf = share_[kGlass] * common * ior * ior * ggx.g1(wo);
  return r;
}

BsdfValue Bsdf::eval(Vec3f worldWi) const {
  const Vec3f wi = frame_.toLocal(worldWi);
  // A normal from interpolation or a map may put wi on one side, the true surface on the other.
  if ((wi.z > 0) != (dot(worldWi, ng_) > 0) || wi.z == 0) return {};
  BsdfValue r = evalLocal(wo_, wi);
  if (share_[kGlass] > 0 && !smooth_) {
    const BsdfValue g = evalGlass(wo_, wi);
    r.value += g.value;
    r.pdf += g.pdf;
  }
  return r;
}

BsdfSample Bsdf::sampleGlass(float lobe, Vec2f u) const {
  BsdfSample r;
  const float ior = 1 / eta_;
  const Vec3f h = smooth_ ? Vec3f{0, 0, 1} : Ggx{alpha_}.sampleVisible(wo_, u);
  const float c = std::min(dot(wo_, h), 1.0f);
  if (c <= 0) return r;
  const FresnelTerms f = fresnelTerms(c, ior);
  const float reflected = 0.5f * (f.s + f.p);
  Vec3f wi;
  if (lobe < reflected) {
    wi = h * (2 * c) - wo_;
    if (wi.z <= 0) return r;
  } else {
    wi = h * (c * eta_ - f.cosineInside) - wo_ * eta_;
    wi = normalized(wi);
    if (wi.z >= 0) return r;
    r.etaScale = eta_ * eta_;
  }
  r.wi = frame_.toWorld(wi);
  if (smooth_) {
    r.delta = true;
    r.pdf = 1;
    r.weight = glass_ * (r.etaScale / share_[kGlass]);
  }
  return r;
}

BsdfSample Bsdf::sample(float lobe, Vec2f u) const {
  BsdfSample r;
  int chosen = 0;
  while (chosen < kLobes - 1 && lobe >= share_[chosen]) lobe -= share_[chosen++];
  const float share = share_[chosen];
  if (share <= 0) return r;
  switch (chosen) {
    case kGlossy: {
      const Vec3f h = smooth_ ? Vec3f{0, 0, 1} : Ggx{alpha_}.sampleVisible(wo_, u);
      const Vec3f wi = h * (2 * dot(wo_, h)) - wo_;
      if (wi.z <= 0) return r;
      r.wi = frame_.toWorld(wi);
      if (smooth_) {
        r.delta = true;
        r.pdf = 1;
        r.weight = fresnel(wo_.z);
        if (sheet_ > 0) r.weight += grey(sheet_ * fresnelSheet(std::min(wo_.z, 1.0f), sheetIor_));
        r.weight *= 1 / share;
      }
      break;
    }
    case kDiffuse:
    case kThrough: {
      Vec3f wi = cosineHemisphere(u);
      if (chosen == kThrough) wi.z = -wi.z;
      r.wi = frame_.toWorld(wi);
      break;
    }
    case kStraight:
      r.wi = -frame_.toWorld(wo_);
      r.delta = r.straight = true;
      r.pdf = 1;
      r.weight = straight_ * (1 / share);
      return r;
    default:
      r = sampleGlass(std::min(lobe / share, kOneMinusEpsilon), u);
      if (dot(r.wi, r.wi) == 0) return r;
  }
  if (r.delta) {
    const bool above = chosen == kGlossy || r.etaScale == 1.0f;
    if ((dot(r.wi, ng_) > 0) != above) r.pdf = 0;
    return r;
  }
  const BsdfValue v = eval(r.wi);
  if (!(v.pdf > 0)) {
    r.pdf = 0;
    return r;
  }
  r.pdf = v.pdf;
  r.weight = v.value * (1 / v.pdf);
  return r;
}

}  // namespace idap::render
