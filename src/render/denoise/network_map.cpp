#include "render/denoise/network_map.h"

#include <cstdint>
#include <cstring>

namespace idap::render {

namespace {

// 2 x 2 maximum. After a ReLU nothing is negative, so the bits compare like the numbers.
template <class Bits>
void poolInto(const Map& from, Map& to, Format format) {
  const Bits* in = reinterpret_cast<const Bits*>(from.data());
  Bits* out = reinterpret_cast<Bits*>(to.data());
  const int blocks = from.channels / kBlock;
  forRows(to.height, [&](int y) {
    for (int b = 0; b < blocks; ++b) {
      for (int x = 0; x < to.width; ++x) {
        const Bits* p = in + at(from, format, b, 2 * x, 2 * y);
        const Bits* q = in + at(from, format, b, 2 * x + 1, 2 * y);
        const Bits* r = in + at(from, format, b, 2 * x, 2 * y + 1);
        const Bits* s = in + at(from, format, b, 2 * x + 1, 2 * y + 1);
        Bits* o = out + at(to, format, b, x, y);
        for (int k = 0; k < kBlock; ++k) o[k] = std::max(std::max(p[k], q[k]), std::max(r[k], s[k]));
      }
    }
  });
}

void upsampleAndJoin(const Map& low, const Map& skip, Map& to, Format format) {
  const std::size_t size = format.bytes();
  const int lowBlocks = low.channels / kBlock, skipBlocks = skip.channels / kBlock;
  const auto copy = [&](const Map& from, int b, int x, int y, int toB, int toX, int toY) {
    std::memcpy(to.data() + at(to, format, toB, toX, toY) * size,
                from.data() + at(from, format, b, x, y) * size, kBlock * size);
  };
  forRows(to.height, [&](int y) {
    for (int b = 0; b < lowBlocks; ++b) {
      for (int x = 0; x < to.width; ++x) copy(low, b, x / 2, y / 2, b, x, y);
    }
    for (int b = 0; b < skipBlocks; ++b) {
      for (int x = 0; x < to.width; ++x) copy(skip, b, x, y, lowBlocks + b, x, y);
    }
  });
}

}  // namespace

Map halved(const Map& from, Format format, BufferPool& pool) {
  Map to(from.channels, from.width / 2, from.height / 2, format, pool);
  if (format.bf16) {
    poolInto<std::uint16_t>(from, to, format);
  } else {
    poolInto<std::uint32_t>(from, to, format);
  }
  return to;
}

Map joined(const Map& low, const Map& skip, Format format, BufferPool& pool) {
  Map to(low.channels + skip.channels, skip.width, skip.height, format, pool);
  upsampleAndJoin(low, skip, to, format);
  return to;
}

}  // namespace idap::render
