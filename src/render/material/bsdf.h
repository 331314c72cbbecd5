// How a point of a surface scatters light (BSDF): a GGX mirror layer (dielectric or metal) with what it loses
// between its facets given back, over a diffuse or translucent base, clear sheets, and solid glass. Opacity
// is not its business: by then the ray has met the surface. Radiance travels along the directions' reverse:
// wo points to where light goes, wi to where it comes from. World space. For one point (Bsdf) or for the
// points of many paths, one a lane.
#pragma once

#include "render/accel/interaction.h"
#include "render/material/surface_data.h"
#include "render/sampling/frame.h"

namespace idap::render {

template <class F>
struct BsdfValueT {
  Vec3T<F> value{F(0.0f), F(0.0f), F(0.0f)};  // f(wo, wi) * |cos(wi, ns)|, 1/sr
  F pdf = 0.0f;                               // of sample() giving wi, 1/sr; delta lobes not counted
};
using BsdfValue = BsdfValueT<float>;

template <class F>
struct BsdfSampleT {
  Vec3T<F> wi;
  Vec3T<F> weight;                        // f * |cos| / pdf; of a delta lobe likewise
  F pdf = 0.0f;                           // 0: nothing was sampled
  Mask<F> delta{false}, straight{false};  // straight: goes on as if nothing were there (clear sheet)
  F etaScale = 1.0f;                      // what refraction did to radiance by squeezing it, (n/n')^2
};
using BsdfSample = BsdfSampleT<float>;

// What of a surface and its point the scattering depends on.
template <class F>
struct ShadingPoint {
  Vec3T<F> ng, ns;  // see Interaction
  Vec3T<F> baseColor;
  F roughness, metalness, ior, f0, f90, transmission, translucency;  // see SurfaceData
  Mask<F> thin, frontFace;
};
ShadingPoint<float> shadingPoint(const Interaction& at, const SurfaceValues& values);

template <class F>
class BsdfT {
  using V = Vec3T<F>;
  using M = Mask<F>;

 public:
  BsdfT(const ShadingPoint<F>& at, const V& wo);
  // Of one point. (A template, lest it be made for lanes, too.)
  template <std::same_as<Interaction> At>
  BsdfT(const At& at, const SurfaceValues& values, Vec3f wo) : BsdfT(shadingPoint(at, values), wo) {}

  BsdfValueT<F> eval(const V& wi) const;
  BsdfSampleT<F> sample(F lobe, const Vec2T<F>& u) const;

  // False when all is delta lobes: no light can be sampled.
  M scatters() const {
    return only(!smooth_, share_[kGlossy] + share_[kGlass]) + share_[kDiffuse] + share_[kThrough] > 0.0f;
  }
  // True when light from behind the surface can reach wo other than by a delta lobe.
  M seesBehind() const { return share_[kThrough] > 0.0f || (share_[kGlass] > 0.0f && !smooth_); }
  // The share of samples that go to the diffuse base, on either side.
  F diffuseShare() const { return share_[kDiffuse] + share_[kThrough]; }
  // True when most light passes or mirrors sharply, so that a picture shows other things in it.
  M mostlySharp() const { return share_[kStraight] + only(smooth_, share_[kGlossy] + share_[kGlass]) > 0.5f; }
  // The directional reflectance towards wo, roughly; for denoising.
  V albedo() const;

 private:
  enum Lobe { kGlossy, kDiffuse, kThrough, kStraight, kGlass, kLobes };

  BsdfValueT<F> evalLocal(const V& wo, const V& wi) const;
  BsdfValueT<F> evalGlass(const V& wo, const V& wi) const;
  V sampleGlass(F lobe, const V& h, F& etaScale) const;
  V fresnel(F cosine) const;

  FrameT<F> frame_;
  V ng_;
  V wo_;  // local
  F alpha_;
  F roughness_;
  M smooth_;
  F eta_;           // index on wo's side over that beyond; solid glass
  V f0_, f90_;      // of the whole mirror layer, weights of its parts included
  F sheetIor_;      // of the clear sheet
  F sheet_;         // weight of the clear sheet's exact reflection, smooth only
  V reflectColor_;  // diffuse base that leaves on wo's side, and on the other
  V throughColor_;
  V metalColor_;          // light that bounced between facets more than once
  F layerF0_, layerF90_;  // of the dielectric layer over the base
  F baseScale_;           // (1 - E(wo)) / (1 - Eavg) of that layer, over pi
  F metalScale_;          // the same of the metal
  V straight_;
  V glass_;
  F share_[kLobes];  // probabilities of the lobes
};
using Bsdf = BsdfT<float>;

extern template class BsdfT<float>;
extern template class BsdfT<Floats>;

}  // namespace idap::render
