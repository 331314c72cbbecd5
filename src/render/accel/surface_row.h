// The numbers of a surface that shading needs at every hit, so laid out that those of many hits are fetched
// together.
#pragma once

#include <array>

#include "render/lanes/lane_rows.h"
#include "render/material/surface_data.h"

namespace idap::render {

// F: float, or Floats for a surface a lane. Flags: 0 or 1.
template <class F>
struct SurfaceRowT {
  Vec3T<F> baseColor;
  F roughness, metalness, ior, f0, f90, transmission, translucency, opacity;
  F thin, emits, mayPass, hasMaps;
  F unused;  // to fill the row
};
struct alignas(64) SurfaceRow : SurfaceRowT<float> {};
static_assert(sizeof(SurfaceRow) == 16 * sizeof(float));

inline SurfaceRow surfaceRow(const SurfaceData& s) {
  const auto flag = [](bool set) { return set ? 1.0f : 0.0f; };
  return {{s.baseColor, s.roughness, s.metalness, s.ior, s.f0, s.f90, s.transmission, s.translucency,
           s.opacity, flag(s.thin), flag(s.emits), flag(s.mayPass), flag(s.hasMaps), 0.0f}};
}

// One row a lane.
inline SurfaceRowT<Floats> fetchRows(const std::array<const SurfaceRow*, kLanes>& rows) {
  return std::bit_cast<SurfaceRowT<Floats>>(fetchWords(rows));
}

}  // namespace idap::render
