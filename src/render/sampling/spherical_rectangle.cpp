#include "render/sampling/spherical_rectangle.h"

#include "render/sampling/warp.h"

namespace idap::render {

template <class F>
SphericalRectangleT<F>::SphericalRectangleT(const V& corner, const V& edgeU, const V& edgeV, const V& from) {
  using namespace lane_math;
  const F u2 = dot(edgeU, edgeU), v2 = dot(edgeV, edgeV);
  const F inverseU = inverseSqrt(u2), inverseV = inverseSqrt(v2);
  const F lengthU = u2 * inverseU, lengthV = v2 * inverseV;
  x_ = edgeU * inverseU;
  y_ = edgeV * inverseV;
  z_ = cross(x_, y_);
  const V d = corner - from;
  z0_ = dot(d, z_);
  const Mask<F> turned = z0_ > 0.0f;
  z_ = select(turned, -z_, z_);
  z0_ = select(turned, -z0_, z0_);
  x0_ = dot(d, x_);
  y0_ = dot(d, y_);
  x1_ = x0_ + lengthU;
  y1_ = y0_ + lengthV;
  // z components of the normals of the four planes through `from` and an edge; inner angles between them.
  const F z2 = z0_ * z0_;
  const auto planeZ = [z2](const F& a) { return F(a * inverseSqrt(max(z2 + a * a, 1e-30f))); };
  const F n0 = -planeZ(y0_), n1 = planeZ(x1_), n2 = planeZ(y1_), n3 = -planeZ(x0_);
  const auto angle = [](const F& a, const F& b) { return arcCosine(clamp(F(-a * b), -1.0f, 1.0f)); };
  const F g0 = angle(n0, n1), g1 = angle(n1, n2), g2 = angle(n2, n3), g3 = angle(n3, n0);
  b0_ = n0;
  b1_ = n2;
  k_ = 2 * kPiF - g2 - g3;
  solidAngle_ = max(g0 + g1 - k_, 0.0f);
}

template <class F>
auto SphericalRectangleT<F>::sample(const Vec2T<F>& u) const -> V {
  using namespace lane_math;
  F sine, cosine;
  sinCos(F(u.x * solidAngle_ + k_), sine, cosine);
  const F fu = (cosine * b0_ - b1_) / sine;
  const F cu = clamp(copysign(1.0f / sqrt(fu * fu + b0_ * b0_), fu), -1.0f, 1.0f);
  const F xu = min(max(-(cu * z0_) / sqrt(max(1.0f - cu * cu, 1e-12f)), x0_), x1_);
  const F d2 = xu * xu + z0_ * z0_;
  const F h0 = y0_ * inverseSqrt(max(d2 + y0_ * y0_, 1e-30f));
  const F h1 = y1_ * inverseSqrt(max(d2 + y1_ * y1_, 1e-30f));
  const F hv = h0 + u.y * (h1 - h0), hv2 = hv * hv;
  const F yv = select(hv2 < 1 - 1e-6f, hv * sqrt(d2) * inverseSqrt(max(1.0f - hv2, 1e-12f)),
                      select(hv < 0.0f, y0_, y1_));
  return x_ * xu + y_ * min(max(yv, y0_), y1_) + z_ * z0_;
}

template class SphericalRectangleT<float>;
template class SphericalRectangleT<Floats>;

}  // namespace idap::render
