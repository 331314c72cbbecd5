#include "editor/symbol/depth_raster.h"

#include <algorithm>
#include <cmath>

namespace idap {

namespace {

constexpr int kBorder = 2;  // cells

}  // namespace

DepthRaster::DepthRaster(const Box3f& box, float cell)
    : origin_{box.min.x - kBorder * cell, box.min.y - kBorder * cell},
      cell_(cell),
      width_(int(std::ceil((box.max.x - box.min.x) / cell)) + 2 * kBorder),
      height_(int(std::ceil((box.max.y - box.min.y) / cell)) + 2 * kBorder),
      depth_(std::size_t(width_) * std::size_t(height_), kNothing),
      label_(depth_.size(), 0) {}

void DepthRaster::fill(Vec3f a, Vec3f b, Vec3f c, std::uint32_t label) {
  const Vec2f pa = toCells(a), pb = toCells(b), pc = toCells(c);
  const float twice = cross(pb - pa, pc - pa);
  if (std::abs(twice) < 1e-9f) return;  // seen on edge
  const int left = std::max(0, int(std::ceil(std::min({pa.x, pb.x, pc.x}) - 0.5f)));
  const int right = std::min(width_ - 1, int(std::floor(std::max({pa.x, pb.x, pc.x}) - 0.5f)));
  const int low = std::max(0, int(std::ceil(std::min({pa.y, pb.y, pc.y}) - 0.5f)));
  const int high = std::min(height_ - 1, int(std::floor(std::max({pa.y, pb.y, pc.y}) - 0.5f)));
  for (int y = low; y <= high; ++y) {
    for (int x = left; x <= right; ++x) {
      const Vec2f p{float(x) + 0.5f, float(y) + 0.5f};
      const float u = cross(pb - p, pc - p) / twice, v = cross(pc - p, pa - p) / twice, w = 1 - u - v;
      constexpr float kEdge = -1e-5f;
      if (u < kEdge || v < kEdge || w < kEdge) continue;
      const float z = a.z * u + b.z * v + c.z * w;
      const std::size_t i = at(x, y);
      if (z > depth_[i]) depth_[i] = z, label_[i] = label;
    }
  }
}

}  // namespace idap
