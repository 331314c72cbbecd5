#include "render/denoise/weight_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/error.h"

namespace idap::render {

namespace {

float fromHalf(std::uint16_t h) {
  const float sign = h & 0x8000 ? -1.0f : 1.0f;
  const int exponent = (h >> 10) & 31;
  const auto fraction = static_cast<float>(h & 1023);
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  if (exponent == 31) return sign * (fraction > 0 ? NAN : INFINITY);
  return sign * std::ldexp(1024.0f + fraction, exponent - 25);
}

// Little-endian values from a block of bytes; throws before reading past its end.
class Cursor {
 public:
  Cursor(const Bytes& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

  template <class T>
  T read() {
    T value;
    std::memcpy(&value, take(sizeof(T)), sizeof(T));
    return value;
  }
  std::string text(std::size_t length) { return {reinterpret_cast<const char*>(take(length)), length}; }
  const std::byte* take(std::size_t size) {
    if (size > bytes_.size() - at_) fail("the file ends too early");
    const std::byte* p = bytes_.data() + at_;
    at_ += size;
    return p;
  }
  void seek(std::uint64_t offset) {
    if (offset > bytes_.size()) fail("the file ends too early");
    at_ = static_cast<std::size_t>(offset);
  }
  std::size_t at() const { return at_; }
  [[noreturn]] void fail(const std::string& reason) const { throw ParseError(file_, "", reason); }

 private:
  const Bytes& bytes_;
  const std::string& file_;
  std::size_t at_ = 0;
};

Tensor readTensor(Cursor& cursor) {
  Tensor tensor;
  const int dimensions = cursor.read<std::uint8_t>();
  std::size_t count = 1;
  for (int d = 0; d < dimensions; ++d) {
    const auto n = cursor.read<std::uint32_t>();
    if (n == 0 || n > 4096) cursor.fail("a tensor of impossible size");
    count *= n;
    if (count > 100'000'000) cursor.fail("a tensor of impossible size");
    tensor.shape.push_back(static_cast<int>(n));
  }
  const std::string layout = cursor.text(static_cast<std::size_t>(dimensions));
  if (layout != "oihw" && layout != "x") cursor.fail("a tensor of unknown layout " + layout);
  const char type = static_cast<char>(cursor.read<std::uint8_t>());
  if (type != 'h' && type != 'f') cursor.fail("a tensor of unknown type");
  const auto offset = cursor.read<std::uint64_t>();
  const std::size_t next = cursor.at();
  cursor.seek(offset);
  tensor.values.resize(count);
  const std::byte* data = cursor.take(count * (type == 'h' ? 2 : 4));
  if (type == 'f') {
    std::memcpy(tensor.values.data(), data, count * 4);
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      std::uint16_t half;
      std::memcpy(&half, data + 2 * i, 2);
      tensor.values[i] = fromHalf(half);
    }
  }
  for (float v : tensor.values) {
    if (!std::isfinite(v)) cursor.fail("a weight that is not a number");
  }
  cursor.seek(next);
  return tensor;
}

}  // namespace

std::map<std::string, Tensor> parseWeights(const Bytes& bytes, const std::string& fileName) {
  static_assert(std::endian::native == std::endian::little);
  Cursor cursor(bytes, fileName);
  if (cursor.read<std::uint16_t>() != 0x41D7) cursor.fail("not a TZA archive of weights");
  if (cursor.read<std::uint8_t>() != 2) cursor.fail("a TZA archive of another version");
  cursor.read<std::uint8_t>();
  cursor.seek(cursor.read<std::uint64_t>());
  const auto count = cursor.read<std::uint32_t>();
  if (count > 10'000) cursor.fail("too many tensors");
  std::map<std::string, Tensor> tensors;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string name = cursor.text(cursor.read<std::uint16_t>());
    tensors[name] = readTensor(cursor);
  }
  return tensors;
}

}  // namespace idap::render
