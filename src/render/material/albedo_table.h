// How much light one bounce off a GGX mirror layer returns, so that what is lost between its facets, and what
// passes to the base below, can be accounted for. With Schlick's Fresnel term the albedo is linear:
// albedo(F0, F90) = F0 * base + F90 * edge. Sources: Kulla and Conty 2017, "Revisiting physically based
// shading at Imageworks"; Karis 2013, "Real shading in Unreal Engine 4" (the split into two terms).
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

template <class F>
struct AlbedoTermsT {
  F base = 0.0f, edge = 0.0f;
};
using AlbedoTerms = AlbedoTermsT<float>;

class AlbedoTable {
 public:
  // Made on first use (some milliseconds), shared by all.
  static const AlbedoTable& get();

  // For light from one direction.
  template <class F>
  AlbedoTermsT<F> directional(F cosine, F roughness) const;
  // The cosine-weighted mean over the hemisphere.
  template <class F>
  AlbedoTermsT<F> average(F roughness) const;

 private:
  AlbedoTable();
  static constexpr int kSize = 32;
  std::uint32_t directional_[kSize][kSize];  // [roughness][cosine], both in even steps over 0..1; packed
  AlbedoTerms average_[kSize];
};

}  // namespace idap::render
