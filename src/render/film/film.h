// What a rendering accumulates, before exposure and tone mapping: sums over the samples of every pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "light/rgb.h"

namespace idap::render {

// Every layer holds width * height values, rows from the top. A pixel without samples (weight 0) has mean 0.
struct Film {
  int width = 0;
  int height = 0;
  int samples = 0;                       // samples a pixel so far, for the record
  std::vector<Rgb> color;                // sum of radiance, cd/m2
  std::vector<Rgb> albedo;               // sum of the first surface's reflectance, 0..1 each
  std::vector<Vec3f> normal;             // sum of the first surface's unit world normal; 0 for the sky
  std::vector<float> depth;              // sum of the distance to the first surface, m; 0 for the sky
  std::vector<float> square;             // sum of squared luminance, for the estimate of the error; 0 unknown
  std::vector<float> coverage;           // samples that met a surface rather than the sky
  std::vector<float> weight;             // samples this pixel got
  std::vector<std::uint32_t> objectId;   // of the first sample; 0 none
  std::vector<std::vector<Rgb>> groups;  // sum of radiance by light group; together they are `color`

  Film() = default;
  // Black. Throws as requireSize().
  Film(int w, int h, int groupCount = 0);
  // Throws RenderError, saying how much memory it would take, where the size is not from 1 to kMaxSide or the
  // layers would need more than kMaxBytes or than the machine has.
  static void requireSize(int w, int h, int groupCount = 0);

  static constexpr int kMaxSide = 65'536;
  static constexpr std::size_t kMaxBytes = std::size_t{16} << 30;
  // Memory that a film of this size takes.
  static std::size_t bytesNeeded(int w, int h, int groupCount);

  bool empty() const { return color.empty(); }
  std::size_t pixels() const { return color.size(); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  float inverseWeight(std::size_t i) const { return weight[i] > 0 ? 1.0f / weight[i] : 0.0f; }
  Rgb meanColor(std::size_t i) const { return color[i] * inverseWeight(i); }
  Rgb meanAlbedo(std::size_t i) const { return albedo[i] * inverseWeight(i); }
  Vec3f meanNormal(std::size_t i) const { return normal[i] * inverseWeight(i); }  // shorter than 1 at edges
  float meanDepth(std::size_t i) const { return depth[i] * inverseWeight(i); }
  Rgb meanGroup(std::size_t group, std::size_t i) const { return groups[group][i] * inverseWeight(i); }
  float meanCoverage(std::size_t i) const { return coverage[i] * inverseWeight(i); }  // 0..1
  std::vector<Rgb> meanColors() const;
  // The standard error of the mean luminance (cd/m2), estimated from the pixel's own samples; infinite where
  // it is not known: with fewer than two samples, or without their squares.
  float standardError(std::size_t i) const;

  // Back to black, keeping the memory.
  void clear();
};

}  // namespace idap::render
