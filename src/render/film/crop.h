// Parts of pictures: to work on what has changed only.
#pragma once

#include <vector>

#include "render/film/film.h"
#include "render/film/pixel_region.h"
#include "render/integrator/features.h"

namespace idap::render {

// The region must lie within the picture. Light groups are left out.
Film cropped(const Film& film, const PixelRegion& region);
Features cropped(const Features& features, const PixelRegion& region);

// Of layers of a picture that is so wide.
template <class T>
std::vector<T> cropped(const std::vector<T>& layer, int width, const PixelRegion& r) {
  std::vector<T> out;
  out.reserve(r.pixels());
  for (int y = r.y; y < r.y + r.height; ++y) {
    const auto row = layer.begin() + static_cast<std::ptrdiff_t>(y) * width + r.x;
    out.insert(out.end(), row, row + r.width);
  }
  return out;
}

// The opposite: puts the part in its place.
template <class T>
void paste(const std::vector<T>& part, std::vector<T>& layer, int width, const PixelRegion& r) {
  for (int y = 0; y < r.height; ++y)
    std::copy_n(part.begin() + static_cast<std::ptrdiff_t>(y) * r.width, r.width,
                layer.begin() + static_cast<std::ptrdiff_t>(y + r.y) * width + r.x);
}

}  // namespace idap::render
