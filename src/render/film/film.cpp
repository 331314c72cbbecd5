#include "render/film/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/platform.h"

namespace idap::render {

namespace {

std::string notThere(int w, int h, std::size_t bytes) {
  return fmt::format("a picture of {} x {} pixels needs {:.1f} GB of memory, which is not there", w, h,
                     static_cast<double>(bytes) / (1 << 30));
}

}  // namespace

std::size_t Film::bytesNeeded(int w, int h, int groupCount) {
  const std::size_t perPixel = 3 * sizeof(Rgb) + 4 * sizeof(float) + sizeof(std::uint32_t) +
                               static_cast<std::size_t>(std::max(groupCount, 0)) * sizeof(Rgb);
  return static_cast<std::size_t>(std::max(w, 0)) * static_cast<std::size_t>(std::max(h, 0)) * perPixel;
}

void Film::requireSize(int w, int h, int groupCount) {
  if (w < 1 || h < 1) throw RenderError(fmt::format("a picture of {} x {} pixels has no pixels", w, h));
  const std::size_t bytes = bytesNeeded(w, h, groupCount);
  if (bytes > kMaxBytes || w > kMaxSide || h > kMaxSide) {
    throw RenderError(
        fmt::format("a picture of {} x {} pixels is too large: it would need {:.1f} GB of memory (the limit "
                    "is {} GB and {} "
                    "pixels a side); choose a smaller size",
                    w, h, static_cast<double>(bytes) / (1 << 30), kMaxBytes >> 30, kMaxSide));
  }
  // Systems promise memory that they do not have, and end the program when it is used.
  if (bytes > availableMemoryBytes()) throw RenderError(notThere(w, h, bytes));
}

Film::Film(int w, int h, int groupCount) : width(w), height(h) {
  requireSize(w, h, groupCount);
  const std::size_t n = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  try {
    color.resize(n);
    albedo.resize(n);
    normal.resize(n);
    depth.resize(n);
    square.resize(n);
    coverage.resize(n);
    weight.resize(n);
    objectId.resize(n);
    groups.assign(static_cast<std::size_t>(std::max(groupCount, 0)), std::vector<Rgb>(n));
  } catch (const std::bad_alloc&) {
    throw RenderError(notThere(w, h, bytesNeeded(w, h, groupCount)));
  }
}

std::vector<Rgb> Film::meanColors() const {
  std::vector<Rgb> mean(pixels());
  for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = meanColor(i);
  return mean;
}

float Film::standardError(std::size_t i) const {
  const float n = weight[i];
  const float mean = luminance(color[i]) * inverseWeight(i);
  if (n < 2 || (square[i] <= 0 && mean > 0)) return std::numeric_limits<float>::infinity();
  const float variance = std::max(square[i] / n - mean * mean, 0.0f) * n / (n - 1);
  return std::sqrt(variance / n);
}

void Film::clear() {
  samples = 0;
  std::ranges::fill(color, Rgb{});
  std::ranges::fill(albedo, Rgb{});
  std::ranges::fill(normal, Vec3f{});
  std::ranges::fill(depth, 0.0f);
  std::ranges::fill(square, 0.0f);
  std::ranges::fill(coverage, 0.0f);
  std::ranges::fill(weight, 0.0f);
  std::ranges::fill(objectId, 0u);
  for (std::vector<Rgb>& group : groups) std::ranges::fill(group, Rgb{});
}

}  // namespace idap::render
