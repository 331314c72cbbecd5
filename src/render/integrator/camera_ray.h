// Rays through the picture.
#pragma once

#include <optional>

#include "render/accel/ray.h"
#include "render/scene.h"

namespace idap::render {

// Makes the rays of one camera and picture size. Points of the picture are in pixels from the top left
// corner. Fisheye is equidistant (angle proportional to the distance from the middle), equirectangular has
// the horizon in the middle; both spread horizontalFov over the picture's width, and have no ray where that
// passes behind.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height);
  std::optional<Ray> at(Vec2f point) const;

 private:
  Camera camera_;
  Vec3f right_, up_;
  float halfWidth_, halfHeight_;
  float scale_;  // per pixel: tangent, metres or radians
};

// An offset from a pixel's middle, distributed as the Blackman-Harris window of 3 pixels' width; so a plain
// mean of samples is the filtered picture.
Vec2f filterOffset(Vec2f u);

}  // namespace idap::render
