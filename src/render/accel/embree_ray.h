// One ray as Embree wants it.
#pragma once

#include <embree3/rtcore.h>

#include "render/accel/ray.h"

namespace idap::render {

inline RTCRay embreeRay(const Ray& ray, std::uint32_t mask) {
  return {ray.origin.x,
          ray.origin.y,
          ray.origin.z,
          ray.tMin,
          ray.direction.x,
          ray.direction.y,
          ray.direction.z,
          0.0f,
          ray.tMax,
          mask,
          0u,
          0u};
}

}  // namespace idap::render
