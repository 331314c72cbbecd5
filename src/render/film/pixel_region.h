// A rectangle of pixels.
#pragma once

#include <cstddef>

namespace idap::render {

struct PixelRegion {
  int x = 0, y = 0, width = 0, height = 0;  // x, y: its first column and row

  bool empty() const { return width <= 0 || height <= 0; }
  bool has(int px, int py) const { return px >= x && px < x + width && py >= y && py < y + height; }
  std::size_t pixels() const {
    return empty() ? 0 : static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

}  // namespace idap::render
