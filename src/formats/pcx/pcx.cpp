#include "formats/pcx/pcx.h"

#include <algorithm>

#include "base/error.h"

namespace idap {

namespace {

constexpr std::size_t kHeaderSize = 128, kPaletteSize = 769;
constexpr int kMaxSide = 65'534;  // a line's even number of bytes must fit its field
constexpr std::uint8_t kManufacturer = 10, kVersion = 5, kRunLength = 1, kPaletteTag = 12;
constexpr std::uint8_t kRun = 0xc0;  // two top bits set: a run of so many
constexpr std::size_t kLongestRun = 63;
constexpr std::size_t kMaxPixels = std::size_t{1} << 28;

class Writer {
 public:
  void byte(int v) { bytes.push_back(static_cast<std::byte>(v)); }
  void word(int v) {
    byte(v & 255);
    byte(v >> 8);
  }
  Bytes bytes;
};

std::uint8_t byteAt(const Bytes& bytes, std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); }
int wordAt(const Bytes& bytes, std::size_t i) { return byteAt(bytes, i) | byteAt(bytes, i + 1) << 8; }

void requireSize(int width, int height) {
  if (width < 1 || height < 1) throw Error("a picture without pixels cannot be written");
  if (width > kMaxSide || height > kMaxSide)
    throw Error("PCX holds pictures of at most 65534 x 65534 pixels");
}

void writeRow(Writer& out, const std::vector<std::uint8_t>& row) {
  for (std::size_t i = 0; i < row.size();) {
    std::size_t run = 1;
    while (i + run < row.size() && run < kLongestRun && row[i + run] == row[i]) ++run;
    if (run > 1 || row[i] >= kRun) out.byte(static_cast<int>(kRun | run));
    out.byte(row[i]);
    i += run;
  }
}

}  // namespace

Bytes writePcx(const IndexedImage& image) {
  requireSize(image.width, image.height);
  const auto width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  if (image.pixels.size() != width * height || image.palette.size() > 256) {
    throw Error("a picture of 256 colours that does not fit its own size");
  }
  Writer out;
  out.byte(kManufacturer);
  out.byte(kVersion);
  out.byte(kRunLength);
  out.byte(8);  // bits a pixel
  out.word(0);
  out.word(0);
  out.word(image.width - 1);
  out.word(image.height - 1);
  out.word(72);  // dots an inch
  out.word(72);
  for (int i = 0; i < 48; ++i) out.byte(0);  // the palette of older versions
  out.byte(0);
  out.byte(1);  // planes
  const std::size_t lineBytes = width + width % 2;
  out.word(static_cast<int>(lineBytes));
  out.word(1);  // colours
  while (out.bytes.size() < kHeaderSize) out.byte(0);
  std::vector<std::uint8_t> row(lineBytes);
  for (std::size_t y = 0; y < height; ++y) {
    std::copy_n(image.pixels.begin() + static_cast<std::ptrdiff_t>(y * width), std::min(width, row.size()),
                row.begin());
    writeRow(out, row);
  }
  out.byte(kPaletteTag);
  for (std::size_t i = 0; i < 256; ++i) {
    for (std::size_t k = 0; k < 3; ++k) out.byte(i < image.palette.size() ? image.palette[i][k] : 0);
  }
  return std::move(out.bytes);
}

Bytes writePcx(const Image8& image, const QuantizerOptions& options, QuantizerStatistics* statistics) {
  requireSize(image.width, image.height);
  return writePcx(quantize(image, options, statistics));
}

bool looksLikePcx(const Bytes& bytes) {
  return bytes.size() > kHeaderSize && byteAt(bytes, 0) == kManufacturer && byteAt(bytes, 1) <= kVersion &&
         byteAt(bytes, 2) == kRunLength;
}

Image8 readPcx(const Bytes& bytes, const std::string& fileName) {
  const auto fail = [&](const std::string& reason) { throw ParseError(fileName, "", reason); };
  if (!looksLikePcx(bytes)) fail("is not a PCX picture");
  const int planes = byteAt(bytes, 65);
  if (byteAt(bytes, 1) != kVersion || byteAt(bytes, 3) != 8 || (planes != 1 && planes != 3)) {
    fail("is a PCX picture of a kind that is not read; 256 colours and 24 bits are");
  }
  const int width = wordAt(bytes, 8) - wordAt(bytes, 4) + 1,
            height = wordAt(bytes, 10) - wordAt(bytes, 6) + 1;
  const auto lineBytes = static_cast<std::size_t>(wordAt(bytes, 66));
  if (width < 1 || height < 1 || lineBytes < static_cast<std::size_t>(width)) fail("has an impossible size");
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  // A byte pair codes 63 pixels at most.
  if (w * h > kMaxPixels || w * h / 32 > bytes.size()) fail("promises more pixels than it can hold");
  std::size_t end = bytes.size();
  if (planes == 1) {
    if (bytes.size() < kHeaderSize + kPaletteSize ||
        byteAt(bytes, bytes.size() - kPaletteSize) != kPaletteTag) {
      fail("lacks its palette");
    }
    end -= kPaletteSize;
  }
  Image8 image(width, height);
  std::vector<std::uint8_t> row(lineBytes * static_cast<std::size_t>(planes));
  std::size_t at = kHeaderSize;
  for (std::size_t y = 0; y < h; ++y) {
    // Some writers let a run go on over the end of a plane, none over that of a row.
    for (std::size_t x = 0; x < row.size();) {
      if (at >= end) fail("ends too early");
      std::uint8_t value = byteAt(bytes, at++);
      std::size_t run = 1;
      if (value >= kRun) {
        run = value & kLongestRun;
        if (at >= end) fail("ends too early");
        value = byteAt(bytes, at++);
      }
      for (; run > 0 && x < row.size(); --run) row[x++] = value;
    }
    for (std::size_t x = 0; x < w; ++x) {
      for (std::size_t k = 0; k < 3; ++k) {
        image.rgb[(y * w + x) * 3 + k] =
            planes == 3 ? row[k * lineBytes + x] : byteAt(bytes, end + 1 + row[x] * std::size_t{3} + k);
      }
    }
  }
  return image;
}

Bytes writeRawDump(const Image8& image) {
  requireSize(image.width, image.height);
  Writer out;
  out.word(image.width);
  out.word(image.height);
  for (int y = 0; y < image.height; ++y) {
    out.word(y);
    for (int k = 0; k < 3; ++k) {
      for (int x = 0; x < image.width; ++x) out.byte(image.pixel(x, y)[k]);
    }
  }
  return std::move(out.bytes);
}

Image8 readRawDump(const Bytes& bytes, const std::string& fileName) {
  const auto fail = [&](const std::string& reason) { throw ParseError(fileName, "", reason); };
  if (bytes.size() < 4) fail("is not a raw picture");
  const auto width = static_cast<std::size_t>(wordAt(bytes, 0)),
             height = static_cast<std::size_t>(wordAt(bytes, 2));
  const std::size_t rowSize = 2 + 3 * width;
  if (width == 0 || height == 0 || bytes.size() != 4 + height * rowSize)
    fail("is not a raw picture of its size");
  Image8 image(static_cast<int>(width), static_cast<int>(height));
  for (std::size_t i = 0; i < height; ++i) {
    const std::size_t at = 4 + i * rowSize;
    const auto y = static_cast<std::size_t>(wordAt(bytes, at));
    if (y >= height) fail("has a row outside the picture");
    for (std::size_t x = 0; x < width; ++x) {
      for (std::size_t k = 0; k < 3; ++k)
        image.rgb[(y * width + x) * 3 + k] = byteAt(bytes, at + 2 + k * width + x);
    }
  }
  return image;
}

}  // namespace idap
