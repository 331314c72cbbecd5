// Uniform sampling of the directions in which a rectangle is seen. Source: Urena, Fajardo and King 2013,
// "An area-preserving parametrization for spherical rectangles".
#pragma once

#include "geometry/vec.h"

namespace idap::render {

class SphericalRectangle {
 public:
  // The rectangle corner + s*edgeU + t*edgeV (edges square to each other) seen from a point.
  SphericalRectangle(Vec3f corner, Vec3f edgeU, Vec3f edgeV, Vec3f from);

  float solidAngle() const { return solidAngle_; }
  // A point of the rectangle, relative to `from`, uniform over solid angle.
  Vec3f sample(Vec2f u) const;

 private:
  Vec3f x_, y_, z_;
  float x0_, y0_, x1_, y1_, z0_;
  float b0_, b1_, k_;
  float solidAngle_;
};

}  // namespace idap::render
