// Uniform sampling of the directions in which a rectangle is seen. Source: Urena, Fajardo and King 2013,
// "An area-preserving parametrization for spherical rectangles".
#pragma once

#include "render/lanes/lanes.h"

namespace idap::render {

template <class F>
class SphericalRectangleT {
  using V = Vec3T<F>;

 public:
  // The rectangle corner + s*edgeU + t*edgeV (edges square to each other) seen from a point.
  SphericalRectangleT(const V& corner, const V& edgeU, const V& edgeV, const V& from);

  F solidAngle() const { return solidAngle_; }
  // A point of the rectangle, relative to `from`, uniform over solid angle.
  V sample(const Vec2T<F>& u) const;

 private:
  V x_, y_, z_;
  F x0_, y0_, x1_, y1_, z0_;
  F b0_, b1_, k_;
  F solidAngle_;
};
using SphericalRectangle = SphericalRectangleT<float>;

extern template class SphericalRectangleT<float>;
extern template class SphericalRectangleT<Floats>;

}  // namespace idap::render
