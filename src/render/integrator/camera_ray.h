// Rays through the picture.
#pragma once

#include <optional>

#include "render/accel/ray.h"
#include "render/lanes/lanes.h"
#include "render/scene.h"

namespace idap::render {

// Makes the rays of one camera and picture size. Points of the picture are in pixels from the top left
// corner. Fisheye is equidistant (angle proportional to the distance from the middle), equirectangular has
// the horizon in the middle; both spread horizontalFov over the picture's width, and have no ray where that
// passes behind.
class CameraRays {
 public:
  CameraRays(const Camera& camera, int width, int height);
  // lens: where on the lens the ray passes, as two random numbers; without depth of field it is not asked.
  std::optional<Ray> at(Vec2f point, Vec2f lens = {0.5f, 0.5f}) const;
  // The same, one a lane; the lanes that have a ray. direction: unit.
  LaneMask at(const LaneVec2& point, const LaneVec2& lens, LaneVec& origin, LaneVec& direction) const;
  bool hasLens() const;

 private:
  template <class F>
  Mask<F> ray(const Vec2T<F>& point, const Vec2T<F>& lens, Vec3T<F>& origin, Vec3T<F>& direction) const;

  Camera camera_;
  Vec3f right_, up_;
  float halfWidth_, halfHeight_;
  float scale_;  // per pixel: tangent, metres or radians
};

// Anti-aliasing filters: how a pixel weighs the light around its middle. None has negative lobes, so a plain
// mean of samples is the filtered picture.
enum class PixelFilter {
  BlackmanHarris,  // smooth, 3 pixels wide
  Triangle,        // 2 pixels wide
  Box,             // the pixel's own square: sharpest, jagged on bright edges
};

// An offset from a pixel's middle, distributed as the filter. F: float or Floats.
template <class F>
Vec2T<F> filterOffset(const Vec2T<F>& u, PixelFilter filter = PixelFilter::BlackmanHarris);

}  // namespace idap::render
