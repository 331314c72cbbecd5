// The pictures of many channels that flow through the denoiser's network, and what happens to them between
// the convolutions.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace idap::render {

inline constexpr int kBlock = 16;  // channels come in sixteens; sides of the picture too, after four halvings

// How numbers lie in memory: as floats or bfloat16. Blocked: planes of 16 channels; else
// all channels of a pixel together.
struct Format {
  bool bf16 = false;
  bool blocked = false;
  std::size_t bytes() const { return bf16 ? 2 : 4; }
};

// Blocks of memory for the maps, used again and again: fresh pages from the system cost as much time as the
// convolutions do.
class BufferPool {
 public:
  struct Free {
    void operator()(std::byte* p) const { ::operator delete[](p, std::align_val_t{64}); }
  };
  struct Buffer {
    std::size_t size = 0;
    std::unique_ptr<std::byte[], Free> bytes;
  };

  // At least `size` bytes of any content, 64-byte aligned.
  Buffer take(std::size_t size) {
    const auto fits = [&](const Buffer& b) { return b.size >= size && b.size / 4 <= size; };
    if (const auto found = std::ranges::find_if(free_, fits); found != free_.end()) {
      Buffer buffer = std::move(*found);
      free_.erase(found);
      return buffer;
    }
    return {size, std::unique_ptr<std::byte[], Free>(new (std::align_val_t{64}) std::byte[size])};
  }
  void giveBack(Buffer buffer) {
    const auto larger = [&](const Buffer& b) { return b.size > buffer.size; };
    free_.insert(std::ranges::find_if(free_, larger), std::move(buffer));
  }

 private:
  std::vector<Buffer> free_;  // smallest first
};

// Channels of one picture at one of the network's resolutions; the memory goes back to the pool it came from.
struct Map {
  int channels = 0, width = 0, height = 0;  // channels a multiple of 16
  BufferPool::Buffer buffer;
  BufferPool* pool = nullptr;

  Map(int c, int w, int h, Format format, BufferPool& from)
      : channels(c), width(w), height(h), buffer(from.take(size(format))), pool(&from) {}
  ~Map() { release(); }
  Map(Map&& other) noexcept { *this = std::move(other); }
  Map& operator=(Map&& other) noexcept {
    std::swap(channels, other.channels);
    std::swap(width, other.width);
    std::swap(height, other.height);
    std::swap(buffer, other.buffer);
    std::swap(pool, other.pool);
    other.release();
    return *this;
  }

  std::size_t size(Format format) const {
    return static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) *
           static_cast<std::size_t>(height) * format.bytes();
  }
  std::byte* data() { return buffer.bytes.get(); }
  const std::byte* data() const { return buffer.bytes.get(); }

 private:
  void release() {
    if (pool && buffer.bytes) pool->giveBack(std::move(buffer));
    pool = nullptr;
  }
};

// Where the 16 channels of block b of pixel (x, y) start, in elements.
inline std::size_t at(const Map& m, Format format, int b, int x, int y) {
  const auto pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(m.width) + static_cast<std::size_t>(x);
  if (format.blocked) {
    return (static_cast<std::size_t>(b) * static_cast<std::size_t>(m.width) *
                static_cast<std::size_t>(m.height) +
            pixel) *
           kBlock;
  }
  return pixel * static_cast<std::size_t>(m.channels) + static_cast<std::size_t>(b * kBlock);
}

// Half as wide and high, the greatest of every four. All values must be 0 or more.
Map halved(const Map& from, Format format, BufferPool& pool);

// Every pixel of `low` four times, then the channels of `skip`.
Map joined(const Map& low, const Map& skip, Format format, BufferPool& pool);

// f(y) for every row, on as many threads as OpenMP is set to.
template <class F>
void forRows(int rows, const F& f) {
#ifdef _OPENMP
#pragma omp parallel for schedule(static)
#endif
  for (int y = 0; y < rows; ++y) f(y);
}

}  // namespace idap::render
