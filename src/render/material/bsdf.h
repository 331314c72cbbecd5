// How a point of a surface scatters light (BSDF): a GGX mirror layer (dielectric or metal) with what it loses
// between its facets given back, over a diffuse or translucent base, clear sheets, and solid glass. Opacity
// is not its business: by then the ray has met the surface. Radiance travels along the directions' reverse:
// wo points to where light goes, wi to where it comes from. World space.
#pragma once

#include "render/accel/interaction.h"
#include "render/material/surface_data.h"
#include "render/sampling/frame.h"

namespace idap::render {

struct BsdfValue {
  Rgb value{};       // f(wo, wi) * |cos(wi, ns)|, 1/sr
  float pdf = 0.0f;  // of sample() giving wi, 1/sr; delta lobes not counted
};

struct BsdfSample {
  Vec3f wi;
  Rgb weight{};      // f * |cos| / pdf; of a delta lobe likewise
  float pdf = 0.0f;  // 0: nothing was sampled
  bool delta = false;
  bool straight = false;  // goes on as if nothing were there, but weaker (clear sheet)
  float etaScale = 1.0f;  // what refraction did to radiance by squeezing it, (n/n')^2
};

class Bsdf {
 public:
  Bsdf(const Interaction& at, const SurfaceValues& values, Vec3f wo);

  BsdfValue eval(Vec3f wi) const;
  BsdfSample sample(float lobe, Vec2f u) const;

  // False when all is delta lobes: no light can be sampled.
  bool scatters() const {
    return share_[kGlossy] * float(!smooth_) + share_[kDiffuse] + share_[kThrough] +
               share_[kGlass] * float(!smooth_) >
           0;
  }
  // True when light from behind the surface can reach wo other than by a delta lobe.
  bool seesBehind() const { return share_[kThrough] > 0 || (share_[kGlass] > 0 && !smooth_); }
  // The share of samples that go to the diffuse base, on either side.
  float diffuseShare() const { return share_[kDiffuse] + share_[kThrough]; }
  // True when most light passes or mirrors sharply, so that a picture shows other things in it.
  bool mostlySharp() const;
  // The directional reflectance towards wo, roughly; for denoising.
  Rgb albedo() const;

 private:
  enum Lobe { kGlossy, kDiffuse, kThrough, kStraight, kGlass, kLobes };

  BsdfValue evalLocal(Vec3f wo, Vec3f wi) const;
  BsdfValue evalGlass(Vec3f wo, Vec3f wi) const;
  BsdfSample sampleGlass(float lobe, Vec2f u) const;
  Rgb fresnel(float cosine) const { return f0_ + (f90_ - f0_) * schlick(cosine); }
  static float schlick(float cosine);

  Frame frame_;
  Vec3f ng_;
  Vec3f wo_;  // local
  float alpha_;
  float roughness_;
  bool smooth_;
  float eta_;           // index on wo's side over that beyond; solid glass
  Rgb f0_, f90_;        // of the whole mirror layer, weights of its parts included
  float sheetIor_ = 1;  // of the clear sheet
  float sheet_ = 0;     // weight of the clear sheet's exact reflection, smooth only
  Rgb reflectColor_;    // diffuse base that leaves on wo's side, and on the other
  Rgb throughColor_;
  Rgb metalColor_;            // light that bounced between facets more than once
  float layerF0_, layerF90_;  // of the dielectric layer over the base
  float baseScale_;           // (1 - E(wo)) / (1 - Eavg) of that layer, over pi
  float metalScale_;          // the same of the metal
  Rgb straight_;
  Rgb glass_;
  float share_[kLobes] = {};  // probabilities of the lobes
};

}  // namespace idap::render
