// What a hit needs of its instance, all in one place, and the surface point made of it.
#pragma once

#include <cstdint>

#include "geometry/transform.h"
#include "render/accel/interaction.h"
#include "render/accel/mesh_accel.h"
#include "render/accel/ray.h"
#include "render/material/surface_data.h"

namespace idap::render {

struct HitInstance {
  const Vec3f* positions = nullptr;
  const Vec3f* worldPositions = nullptr;  // in scenes of one level; null in others
  const Vec3f* normals = nullptr;
  const Vec2f* uvs = nullptr;
  const HitTriangle* triangles = nullptr;
  const std::uint32_t* surfaces = nullptr;
  const std::uint32_t* triangleMap[2] = {};
  Transformf toWorld;
  Transformf normalToWorld;  // cofactor matrix, signed so that fronts stay fronts in a mirror
  float mirrored = 1.0f;     // -1 where it is negative
  float translation = 0.0f;  // the largest coordinate of the transform's origin
  std::uint32_t objectId = 0;
  std::uint16_t lightGroup = 0;

  std::uint32_t triangleOf(unsigned geometry, unsigned primitive) const {
    const std::uint32_t* map = triangleMap[geometry & 1u];
    return map ? map[primitive] : primitive;
  }
  std::uint32_t surfaceOf(std::uint32_t triangle) const { return surfaces[triangles[triangle].slot()]; }
};

inline Vec2f interpolate(Vec2f a, Vec2f b, Vec2f c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}
inline Vec3f interpolate(Vec3f a, Vec3f b, Vec3f c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

// A hit's position is off by some ulps of the coordinates it was computed from; new rays start this many
// ulps (2^-23) away. 48 ulps at 10 m are 0.06 mm.
inline constexpr float kOffsetUlps = 48.0f * 1.1920929e-7f;

// Tilts a shading normal just so far that the mirror image of wo about it stays above the surface.
template <class F>
Vec3T<F> bend(const Vec3T<F>& ns, const Vec3T<F>& ng, const Vec3T<F>& wo) {
  using namespace lane_math;
  const Vec3T<F> mirrored = ns * F(2.0f * dot(ns, wo)) - wo;
  const F threshold = 0.02f * min(2.0f * dot(ng, wo), 1.0f);
  const F height = dot(mirrored, ng);
  const Mask<F> sinks = height < threshold;
  if (!any(sinks)) return ns;
  const Vec3T<F> half = normalized(mirrored + ng * F(threshold - height)) + wo;
  const F l2 = dot(half, half);
  const Vec3T<F> bent = half * F(1.0f / sqrt(max(l2, 1e-8f)));
  return select(sinks, select(l2 > 1e-8f, bent, ng), ns);
}

// surfaces: those of the scene.
Interaction interactionOn(const HitInstance& instance, const SurfaceData* surfaces, const Ray& ray,
                          const Hit& hit);

}  // namespace idap::render
