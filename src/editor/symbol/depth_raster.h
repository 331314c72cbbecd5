// A small picture of a model: which surface is seen in each cell, and how near it is. Finds what hides what.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/box.h"

namespace idap {

class DepthRaster {
 public:
  static constexpr float kNothing = -std::numeric_limits<float>::infinity();

  // Covers the box with cells of this size (m), with an empty border around.
  DepthRaster(const Box3f& box, float cell);

  // x right, y up, z towards the eye. label > 0.
  void fill(Vec3f a, Vec3f b, Vec3f c, std::uint32_t label);

  int width() const { return width_; }
  int height() const { return height_; }
  float cell() const { return cell_; }
  float depth(int x, int y) const { return inside(x, y) ? depth_[at(x, y)] : kNothing; }
  std::uint32_t label(int x, int y) const { return inside(x, y) ? label_[at(x, y)] : 0; }

  // Metres to cells (whole numbers are the corners of cells) and back.
  Vec2f toCells(Vec3f p) const { return {(p.x - origin_.x) / cell_, (p.y - origin_.y) / cell_}; }
  Vec2f toMetres(Vec2f cells) const { return {origin_.x + cells.x * cell_, origin_.y + cells.y * cell_}; }

 private:
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }

  Vec2f origin_;
  float cell_;
  int width_, height_;
  std::vector<float> depth_;
  std::vector<std::uint32_t> label_;
};

}  // namespace idap
