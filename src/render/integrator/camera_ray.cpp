#include "render/integrator/camera_ray.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/sampling/warp.h"

namespace idap::render {

CameraRays::CameraRays(const Camera& camera, int width, int height)
    : camera_(camera),
      halfWidth_(0.5f * static_cast<float>(width)),
      halfHeight_(0.5f * static_cast<float>(height)) {
  right_ = normalized(cross(camera.forward, camera.up));
  up_ = cross(right_, camera.forward);
  switch (camera.projection) {
    case Projection::Perspective:
      scale_ = std::tan(0.5f * std::clamp(camera.horizontalFov, 1e-3f, 3.1f)) / halfWidth_;
      break;
    case Projection::Orthographic:
      scale_ = 0.5f * camera.orthographicWidth / halfWidth_;
      break;
    default:
      scale_ = 0.5f * camera.horizontalFov / halfWidth_;
      break;
  }
}

bool CameraRays::hasLens() const {
  return camera_.lensRadius > 0 && camera_.focusDistance > 0 &&
         (camera_.projection == Projection::Perspective || camera_.projection == Projection::Orthographic);
}

template <class F>
Mask<F> CameraRays::ray(const Vec2T<F>& point, const Vec2T<F>& lens, Vec3T<F>& origin,
                        Vec3T<F>& direction) const {
  using namespace lane_math;
  using V = Vec3T<F>;
  const F x = (point.x - halfWidth_) * scale_, y = (halfHeight_ - point.y) * scale_;
  const V forward = spread<F>(camera_.forward), right = spread<F>(right_), up = spread<F>(up_);
  origin = spread<F>(camera_.eye);
  switch (camera_.projection) {
    case Projection::Perspective:
    case Projection::Orthographic: {
      if (camera_.projection == Projection::Orthographic) {
        origin += right * x + up * y;
        direction = forward;
      } else {
        direction = forward + right * F(x + camera_.shift.x) + up * F(y + camera_.shift.y);
      }
      if (hasLens()) {
        const Vec2T<F> disc = unitDisc(lens);
        const V aside = right * F(disc.x * camera_.lensRadius) + up * F(disc.y * camera_.lensRadius);
        origin += aside;
        direction = direction * F(camera_.focusDistance) - aside;
      }
      direction = normalized(direction);
      return Mask<F>(true);
    }
    case Projection::Fisheye: {
      const F angle = sqrt(x * x + y * y), scale = 1.0f / max(angle, 1e-6f);
      F sine, cosine;
      sinCos(angle, sine, cosine);
      direction = normalized(forward * cosine + right * F(x * scale * sine) + up * F(y * scale * sine));
      return angle <= std::min(kPiF, 0.5f * camera_.horizontalFov);
    }
    case Projection::Equirectangular: {
      F sinX, cosX, sinY, cosY;
      sinCos(x, sinX, cosX);
      sinCos(y, sinY, cosY);
      direction = normalized((forward * cosX + right * sinX) * cosY + up * sinY);
      return abs(y) <= 0.5f * kPiF && abs(x) <= kPiF * 1.01f;
    }
  }
  return Mask<F>(false);
}

std::optional<Ray> CameraRays::at(Vec2f point, Vec2f lens) const {
  Ray made;
  if (!ray<float>(point, lens, made.origin, made.direction)) return std::nullopt;
  return made;
}

LaneMask CameraRays::at(const LaneVec2& point, const LaneVec2& lens, LaneVec& origin,
                        LaneVec& direction) const {
  return ray<Floats>(point, lens, origin, direction);
}

namespace {

// The inverse of the window's cumulative sum, in even steps.
struct InverseWindow {
  static constexpr int kSteps = 256;
  std::array<float, kSteps + 1> x{};
  InverseWindow() {
    constexpr int kFine = 4096;
    std::array<double, kFine + 1> sum{};
    for (int i = 0; i < kFine; ++i) {
      const double t = 2 * kPi * (i + 0.5) / kFine;
      const double w =
          0.35875 - 0.48829 * std::cos(t) + 0.14128 * std::cos(2 * t) - 0.01168 * std::cos(3 * t);
      sum[static_cast<std::size_t>(i) + 1] = sum[static_cast<std::size_t>(i)] + w;
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const double target = sum[kFine] * static_cast<double>(i) / kSteps;
      while (k < kFine - 1 && sum[k + 1] < target) ++k;
      const double within = (target - sum[k]) / (sum[k + 1] - sum[k]);
      x[i] = static_cast<float>(3 * ((static_cast<double>(k) + within) / kFine - 0.5));
    }
  }
  template <class F>
  F at(F u) const {
    const F s = u * float{kSteps};
    const Int<F> i = toInt(lane_math::min(s, float{kSteps - 1}));
    const F low = gather(x.data(), i);
    return low + (gather(x.data(), i + 1) - low) * (s - toFloats(i));
  }
};
const InverseWindow kWindow;

}  // namespace

template <class F>
Vec2T<F> filterOffset(const Vec2T<F>& u, PixelFilter filter) {
  using namespace lane_math;
  const auto triangle = [](const F& v) {
    return select(v < 0.5f, sqrt(2.0f * v) - 1.0f, 1.0f - sqrt(max(2.0f - 2.0f * v, 0.0f)));
  };
  switch (filter) {
    case PixelFilter::Triangle:
      return {triangle(u.x), triangle(u.y)};
    case PixelFilter::Box:
      return {u.x - 0.5f, u.y - 0.5f};
    case PixelFilter::BlackmanHarris:
      break;
  }
  return {kWindow.at(u.x), kWindow.at(u.y)};
}
template Vec2f filterOffset(const Vec2f&, PixelFilter);
template LaneVec2 filterOffset(const LaneVec2&, PixelFilter);

Camera upright(const Camera& camera) {
  constexpr float kMostTilt = 0.87f;  // radians
  const float level = std::hypot(camera.forward.x, camera.forward.y);
  const float tilt = std::atan2(camera.forward.z, level);
  if (camera.projection != Projection::Perspective || std::fabs(tilt) > kMostTilt) return camera;
  Camera c = camera;
  c.forward = {camera.forward.x / level, camera.forward.y / level, 0};
  c.up = {0, 0, 1};
  // What was in the middle stays there, and as large: its depth has shrunk by the cosine.
  c.shift = {camera.shift.x, camera.shift.y + std::tan(tilt)};
  c.horizontalFov = 2 * std::atan(std::tan(0.5f * camera.horizontalFov) / std::cos(tilt));
  return c;
}

float lensRadius(float horizontalFov, float fNumber) {
  const float focalLength = 0.018f / std::tan(0.5f * horizontalFov);
  return 0.5f * focalLength / fNumber;
}

}  // namespace idap::render
