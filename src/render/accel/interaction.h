// The point of a surface that a ray has reached, with what shading needs to know of it. World space, metres.
#pragma once

#include <cstdint>

#include "render/lanes/lanes.h"

namespace idap::render {

struct SurfaceData;

struct Interaction {
  Vec3f position;
  Vec3f ng;  // geometric normal, unit, on the side the ray came from
  Vec3f ns;  // shading normal, unit, same side; bent so that no reflection dives under
  Vec2f uv;
  const SurfaceData* surface = nullptr;
  std::uint32_t surfaceIndex = 0;  // into Scene::surfaces
  std::uint32_t objectId = 0;
  std::uint16_t lightGroup = 0;
  bool frontFace = true;  // the ray came from the side the triangle's winding faces
  bool smooth = false;    // ns may differ from ng
  float offset = 0.0f;    // how far along ng a new ray must start to be clear of rounding errors

  // A safe start for a ray towards d.
  Vec3f originTowards(Vec3f d) const { return position + ng * (dot(d, ng) >= 0 ? offset : -offset); }
};

// Smooth normals on coarse meshes would cut the light off along triangle edges; fade it out instead (Chiang,
// Li and Burley 2019, "Taming the shadow terminator").
template <class F>
F terminator(const Vec3T<F>& ng, const Vec3T<F>& ns, const Vec3T<F>& wi) {
  const F g = dot(ng, wi), s = dot(ns, wi), n = dot(ng, ns);
  const F q = g / (s * n);
  const Mask<F> fades = s * g > 0.0f && q > 0.0f && q < 1.0f;
  return select(fades, q * (1.0f + q * (1.0f - q)), F(1.0f));
}

}  // namespace idap::render
