// Rays, what they hit, and the masks that say which things they see. World space, metres.
#pragma once

#include <cstdint>
#include <limits>

#include "geometry/vec.h"

namespace idap::render {

struct Ray {
  Vec3f origin;
  Vec3f direction;  // unit
  float tMin = 0.0f;
  float tMax = std::numeric_limits<float>::infinity();
};

// Sets of things a ray can see; may be joined with '|'.
enum RayMask : std::uint32_t {
  kSeenByCamera = 1,  // instances but those with visibleToCamera == false
  kSeenByLight = 2,   // every instance
  kLampSpheres = 4,   // lamps with a radius; they stop nothing but the ray that looks for them
};
inline constexpr std::uint32_t kCameraRay = kSeenByCamera | kLampSpheres;
inline constexpr std::uint32_t kBounceRay = kSeenByLight | kLampSpheres;

inline constexpr std::uint32_t kNone = 0xffffffffu;

// Where a ray ends: on a triangle of an instance, or on a lamp's sphere.
struct Hit {
  float t = 0.0f;
  float u = 0.0f, v = 0.0f;        // weights of the triangle's second and third corner
  std::uint32_t instance = kNone;  // into Scene::instances; kNone on a lamp
  std::uint32_t triangle = 0;      // into the mesh's triangles
  std::uint32_t lamp = kNone;      // into Scene::lamps
  bool isLamp() const { return lamp != kNone; }
};

// A ray as it was handed to Embree, for measuring and debugging.
struct LoggedRay {
  Ray ray;
  std::uint32_t mask = 0;
  bool shadow = false;
  bool coherent = false;
};

}  // namespace idap::render
