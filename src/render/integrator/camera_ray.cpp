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

std::optional<Ray> CameraRays::at(Vec2f point, Vec2f lens) const {
  const float x = (point.x - halfWidth_) * scale_, y = (halfHeight_ - point.y) * scale_;
  const Vec3f forward = camera_.forward;
  const float pi = static_cast<float>(kPi);
  switch (camera_.projection) {
    case Projection::Perspective:
    case Projection::Orthographic: {
      const bool flat = camera_.projection == Projection::Orthographic;
      const Vec3f eye = flat ? camera_.eye + right_ * x + up_ * y : camera_.eye;
      const Vec3f way =
          flat ? forward : forward + right_ * (x + camera_.shift.x) + up_ * (y + camera_.shift.y);
      if (!hasLens()) return Ray{eye, normalized(way)};
      const Vec2f disc = unitDisc(lens) * camera_.lensRadius;
      const Vec3f aside = right_ * disc.x + up_ * disc.y;
      return Ray{eye + aside, normalized(way * camera_.focusDistance - aside)};
    }
    case Projection::Fisheye: {
      const float angle = std::hypot(x, y);
      if (angle > std::min(pi, 0.5f * camera_.horizontalFov)) return std::nullopt;
      if (angle < 1e-6f) return Ray{camera_.eye, forward};
      const Vec3f side = right_ * (x / angle) + up_ * (y / angle);
      return Ray{camera_.eye, normalized(forward * std::cos(angle) + side * std::sin(angle))};
    }
    case Projection::Equirectangular: {
      if (std::fabs(y) > 0.5f * pi || std::fabs(x) > pi * 1.01f) return std::nullopt;
      const Vec3f level = forward * std::cos(x) + right_ * std::sin(x);
      return Ray{camera_.eye, normalized(level * std::cos(y) + up_ * std::sin(y))};
    }
  }
  return std::nullopt;
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
  float at(float u) const {
    const float s = u * kSteps;
    const auto i = std::min(static_cast<std::size_t>(s), static_cast<std::size_t>(kSteps - 1));
    return x[i] + (x[i + 1] - x[i]) * (s - static_cast<float>(i));
  }
};
const InverseWindow kWindow;

}  // namespace

Vec2f filterOffset(Vec2f u, PixelFilter filter) {
  const auto triangle = [](float v) { return v < 0.5f ? std::sqrt(2 * v) - 1 : 1 - std::sqrt(2 - 2 * v); };
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
