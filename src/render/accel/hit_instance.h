// What a hit needs of its instance, all in one place, and the surface point made of it.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/transform.h"
#include "render/accel/interaction.h"
#include "render/accel/ray.h"
#include "render/material/surface_data.h"

namespace idap::render {

struct HitInstance {
  const Vec3f* positions = nullptr;
  const Vec3f* normals = nullptr;
  const Vec2f* uvs = nullptr;
  const std::array<std::uint32_t, 3>* triangles = nullptr;
  const std::uint32_t* slots = nullptr;
  const std::uint32_t* surfaces = nullptr;
  const std::uint32_t* triangleMap[2] = {};
  Transformf toWorld;
  Transformf normalToWorld;  // cofactor matrix, signed so that fronts stay fronts in a mirror
  float translation = 0.0f;  // the largest coordinate of the transform's origin
  std::uint32_t objectId = 0;
  std::uint16_t lightGroup = 0;

  std::uint32_t triangleOf(unsigned geometry, unsigned primitive) const {
    const std::uint32_t* map = triangleMap[geometry & 1u];
    return map ? map[primitive] : primitive;
  }
  std::uint32_t surfaceOf(std::uint32_t triangle) const { return surfaces[slots ? slots[triangle] : 0]; }
};

inline Vec2f interpolate(Vec2f a, Vec2f b, Vec2f c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}
inline Vec3f interpolate(Vec3f a, Vec3f b, Vec3f c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

// surfaces: those of the scene.
Interaction interactionOn(const HitInstance& instance, const SurfaceData* surfaces, const Ray& ray,
                          const Hit& hit);

}  // namespace idap::render
