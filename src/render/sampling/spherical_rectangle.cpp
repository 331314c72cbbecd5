#include "render/sampling/spherical_rectangle.h"

#include <algorithm>

#include "render/sampling/warp.h"

namespace idap::render {

SphericalRectangle::SphericalRectangle(Vec3f corner, Vec3f edgeU, Vec3f edgeV, Vec3f from) {
  const float lengthU = length(edgeU), lengthV = length(edgeV);
  x_ = edgeU / lengthU;
  y_ = edgeV / lengthV;
  z_ = cross(x_, y_);
  const Vec3f d = corner - from;
  z0_ = dot(d, z_);
  if (z0_ > 0) {
    z_ = -z_;
    z0_ = -z0_;
  }
  x0_ = dot(d, x_);
  y0_ = dot(d, y_);
  x1_ = x0_ + lengthU;
  y1_ = y0_ + lengthV;
  // z components of the normals of the four planes through `from` and an edge; inner angles between them.
  const auto planeZ = [this](float a) { return z0_ == 0 && a == 0 ? 0.0f : a / std::hypot(z0_, a); };
  const float n0 = -planeZ(y0_), n1 = planeZ(x1_), n2 = planeZ(y1_), n3 = -planeZ(x0_);
  const auto angle = [](float a, float b) { return std::acos(std::clamp(-a * b, -1.0f, 1.0f)); };
  const float g0 = angle(n0, n1), g1 = angle(n1, n2), g2 = angle(n2, n3), g3 = angle(n3, n0);
  b0_ = n0;
  b1_ = n2;
  k_ = 2 * kPiF - g2 - g3;
  solidAngle_ = std::max(0.0f, g0 + g1 - k_);
}

Vec3f SphericalRectangle::sample(Vec2f u) const {
  const float au = u.x * solidAngle_ + k_;
  const float fu = (std::cos(au) * b0_ - b1_) / std::sin(au);
  float cu = std::copysign(1 / std::sqrt(fu * fu + b0_ * b0_), fu);
  cu = std::clamp(cu, -1.0f, 1.0f);
  const float xu = std::clamp(-(cu * z0_) / std::sqrt(std::max(1 - cu * cu, 1e-12f)), x0_, x1_);
  const float d = std::sqrt(xu * xu + z0_ * z0_);
  const float h0 = y0_ / std::sqrt(d * d + y0_ * y0_);
  const float h1 = y1_ / std::sqrt(d * d + y1_ * y1_);
  const float hv = h0 + u.y * (h1 - h0), hv2 = hv * hv;
  const float yv = hv2 < 1 - 1e-6f ? hv * d / std::sqrt(1 - hv2) : (hv < 0 ? y0_ : y1_);
  return x_ * xu + y_ * std::clamp(yv, y0_, y1_) + z_ * z0_;
}

}  // namespace idap::render
