#include "formats/pcx/quantizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"

namespace idap {

namespace {

constexpr int kSide = 32;  // five bits a channel
constexpr int kCells = kSide * kSide * kSide;
constexpr double kGamma = 2.222;

int cellOf(int r, int g, int b) { return (r * kSide + g) * kSide + b; }

// Pixels in each cell of the colour cube.
using Histogram = std::vector<std::size_t>;

struct Box {
  std::array<int, 3> low{0, 0, 0}, high{kSide - 1, kSide - 1, kSide - 1};  // both included
  std::size_t population = 0;

  bool single() const { return low == high; }
  int longestAxis() const {
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      if (high[static_cast<std::size_t>(k)] - low[static_cast<std::size_t>(k)] >
          high[static_cast<std::size_t>(axis)] - low[static_cast<std::size_t>(axis)]) {
        axis = k;
      }
    }
    return axis;
  }
};

template <class F>
void forCells(const Box& box, const F& f) {
  for (int r = box.low[0]; r <= box.high[0]; ++r) {
    for (int g = box.low[1]; g <= box.high[1]; ++g) {
      for (int b = box.low[2]; b <= box.high[2]; ++b) f(std::array<int, 3>{r, g, b}, cellOf(r, g, b));
    }
  }
}

// Draws the box in to what it holds, and counts that.
Box shrunk(const Box& box, const Histogram& histogram) {
  Box tight;
  tight.low = {kSide, kSide, kSide};
  tight.high = {-1, -1, -1};
  forCells(box, [&](const std::array<int, 3>& at, int cell) {
    const std::size_t n = histogram[static_cast<std::size_t>(cell)];
    if (n == 0) return;
    tight.population += n;
    for (std::size_t k = 0; k < 3; ++k) {
      tight.low[k] = std::min(tight.low[k], at[k]);
      tight.high[k] = std::max(tight.high[k], at[k]);
    }
  });
  return tight;
}

// Cuts across the longest axis where the running sum passes half the population; both parts hold something.
std::pair<Box, Box> split(const Box& box, const Histogram& histogram) {
  const auto axis = static_cast<std::size_t>(box.longestAxis());
  std::array<std::size_t, kSide> slices{};
  forCells(box, [&](const std::array<int, 3>& at, int cell) {
    slices[static_cast<std::size_t>(at[axis])] += histogram[static_cast<std::size_t>(cell)];
  });
  int cut = box.low[axis];
  std::size_t sum = slices[static_cast<std::size_t>(cut)];
  while (2 * sum < box.population && cut < box.high[axis] - 1) sum += slices[static_cast<std::size_t>(++cut)];
  Box first = box, second = box;
  first.high[axis] = cut;
  second.low[axis] = cut + 1;
  return {shrunk(first, histogram), shrunk(second, histogram)};
}

int widened(int fiveBits) { return fiveBits << 3 | fiveBits >> 2; }

// The mean of the box's cells, weighted by their pixels.
PaletteColor colorOf(const Box& box, const Histogram& histogram) {
  std::array<double, 3> sum{};
  forCells(box, [&](const std::array<int, 3>& at, int cell) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += static_cast<double>(histogram[static_cast<std::size_t>(cell)]) * widened(at[k]);
    }
  });
  PaletteColor color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = static_cast<std::uint8_t>(std::lround(sum[k] / static_cast<double>(box.population)));
  }
  return color;
}

int brightness(const PaletteColor& c) { return 30 * c[0] + 59 * c[1] + 11 * c[2]; }

std::array<std::uint8_t, 256> correction(bool gamma) {
  std::array<std::uint8_t, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double v = static_cast<double>(i) / 255;
    table[i] =
        static_cast<std::uint8_t>(gamma ? std::lround(255 * std::pow(v, 1 / kGamma)) : static_cast<long>(i));
  }
  return table;
}

}  // namespace

IndexedImage quantize(const Image8& image, const QuantizerOptions& options, QuantizerStatistics* statistics) {
  if (image.width < 1 || image.height < 1 || image.rgb.empty())
    throw Error("the picture to quantize is empty");
  if (options.colors < 1 || options.colors > 256) throw Error("a palette has 1 to 256 colours");
  const std::array<std::uint8_t, 256> corrected = correction(options.gamma);
  const std::size_t pixels = image.rgb.size() / 3;
  const auto value = [&](std::size_t pixel, std::size_t k) { return corrected[image.rgb[3 * pixel + k]]; };

  Histogram histogram(kCells);
  std::vector<std::uint16_t> cells(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const int cell = cellOf(value(i, 0) >> 3, value(i, 1) >> 3, value(i, 2) >> 3);
    cells[i] = static_cast<std::uint16_t>(cell);
    ++histogram[static_cast<std::size_t>(cell)];
  }

  std::vector<Box> boxes{shrunk(Box(), histogram)};
  while (boxes.size() < static_cast<std::size_t>(options.colors)) {
    Box* most = nullptr;
    for (Box& box : boxes) {
      if (!box.single() && (!most || box.population > most->population)) most = &box;
    }
    if (!most) break;
    auto [first, second] = split(*most, histogram);
    *most = first;
    boxes.push_back(second);
  }

  std::vector<PaletteColor> colors;
  for (const Box& box : boxes) colors.push_back(colorOf(box, histogram));
  std::vector<std::size_t> order(boxes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return brightness(colors[i]); });

  IndexedImage result{image.width, image.height, {}, {}};
  // Every used cell lies in one box, so that "or else the nearest colour" is left for none.
  std::vector<std::uint8_t> indexOf(kCells);
  for (std::size_t i = 0; i < order.size(); ++i) {
    result.palette.push_back(colors[order[i]]);
    forCells(boxes[order[i]], [&](const std::array<int, 3>&, int cell) {
      if (histogram[static_cast<std::size_t>(cell)] > 0) {
        indexOf[static_cast<std::size_t>(cell)] = static_cast<std::uint8_t>(i);
      }
    });
  }
  result.pixels.reserve(pixels);
  for (std::uint16_t cell : cells) result.pixels.push_back(indexOf[cell]);

  if (statistics) {
    QuantizerStatistics s;
    s.cells = static_cast<int>(std::ranges::count_if(histogram, [](std::size_t n) { return n > 0; }));
    s.boxes = static_cast<int>(boxes.size());
    const auto [small, large] = std::ranges::minmax(boxes, {}, &Box::population);
    s.smallestBox = small.population;
    s.largestBox = large.population;
    double squares = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int error = std::abs(int{value(i, k)} - int{result.palette[result.pixels[i]][k]});
        squares += error * error;
        s.worstError = std::max(s.worstError, error);
      }
    }
    s.meanError = std::sqrt(squares / (3.0 * static_cast<double>(pixels)));
    *statistics = s;
  }
  return result;
}

}  // namespace idap
