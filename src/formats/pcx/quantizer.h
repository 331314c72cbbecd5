// From true colour to 256 colours by median cut, as IDAP did it in 1993. @cite heckbert1982quantization
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/image8.h"

namespace idap {

using PaletteColor = std::array<std::uint8_t, 3>;

// A picture of 8-bit indices into at most 256 colours, rows from the top.
struct IndexedImage {
  int width = 0;
  int height = 0;
  std::vector<PaletteColor> palette;  // from dark to bright: 30 R + 59 G + 11 B
  std::vector<std::uint8_t> pixels;
};

struct QuantizerOptions {
  int colors = 256;    // 1..256
  bool gamma = false;  // brighten by the power 1 / 2.222 first, for pictures whose values are linear light
};

// What the "verbose" option of 1993 told.
struct QuantizerStatistics {
  int cells = 0;                                // of the histogram's 32 x 32 x 32 that are used
  int boxes = 0;                                // = colours of the palette
  std::size_t largestBox = 0, smallestBox = 0;  // pixels
  double meanError = 0;                         // root mean square over pixels and channels, of 255
  int worstError = 0;                           // of one channel of one pixel, of 255
};

// statistics: null, or filled in. Throws Error for an empty picture or a number of colours out of range.
IndexedImage quantize(const Image8& image, const QuantizerOptions& options = {},
                      QuantizerStatistics* statistics = nullptr);

}  // namespace idap
