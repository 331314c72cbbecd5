#include "render/denoise/weight_file.h"

#include <gtest/gtest.h>

#include <cstring>

#include "base/error.h"

namespace idap::render {
namespace {

class Writer {
 public:
  template <class T>
  void put(T value) {
    const std::size_t at = bytes.size();
    bytes.resize(at + sizeof(T));
    std::memcpy(bytes.data() + at, &value, sizeof(T));
  }
  void text(const char* s) {
    while (*s) put(*s++);
  }
  Bytes bytes;
};

// One bias of two halves: 1.5 and -2.
Bytes archive() {
  Writer w;
  w.put<std::uint16_t>(0x41D7);
  w.put<std::uint8_t>(2);
  w.put<std::uint8_t>(0);
  w.put<std::uint64_t>(16);
  w.put<std::uint16_t>(0x3E00);
  w.put<std::uint16_t>(0xC000);
  w.put<std::uint32_t>(1);
  w.put<std::uint16_t>(6);
  w.text("a.bias");
  w.put<std::uint8_t>(1);
  w.put<std::uint32_t>(2);
  w.text("xh");
  w.put<std::uint64_t>(12);
  return w.bytes;
}

TEST(WeightFile, ReadsNamesShapesAndHalfFloats) {
  const auto tensors = parseWeights(archive(), "w.tza");
  ASSERT_TRUE(tensors.contains("a.bias"));
  EXPECT_EQ(tensors.at("a.bias").shape, std::vector<int>{2});
  EXPECT_EQ(tensors.at("a.bias").values, (std::vector<float>{1.5f, -2.0f}));
}

TEST(WeightFile, EveryCutIsRefused) {
  const Bytes whole = archive();
  for (std::size_t cut = 0; cut < whole.size(); ++cut) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(cut));
    EXPECT_THROW(parseWeights(part, "w.tza"), ParseError) << cut;
  }
}

TEST(WeightFile, JunkIsRefused) {
  Bytes bytes = archive();
  bytes[0] = std::byte{1};
  EXPECT_THROW(parseWeights(bytes, "w.tza"), ParseError);
  bytes = archive();
  bytes[29] = std::byte{0xff};  // a size out of all proportion
  EXPECT_THROW(parseWeights(bytes, "w.tza"), ParseError);
}

}  // namespace
}  // namespace idap::render
