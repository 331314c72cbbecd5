#include "render/film/texture_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "base/error.h"

namespace idap::render {
namespace {

Bytes bytesOf(const std::string& text) {
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

TEST(TextureFile, ReadsPortablePixmapsFromMemory) {
  const TexturePtr texture = decodeTexture(bytesOf("P6\n# made by hand\n2 1\n255\nabcdef"), true);
  EXPECT_EQ(texture->width, 2);
  EXPECT_EQ(texture->height, 1);
  EXPECT_FALSE(texture->hasAlpha);
  EXPECT_EQ(texture->rgba, (std::vector<std::uint8_t>{'a', 'b', 'c', 255, 'd', 'e', 'f', 255}));
}

TEST(TextureFile, RefusesDamagedPixmaps) {
  for (const char* text : {"P6", "P6 ", "P6\n2 1\n255\nabc", "P6\n2\n", "P6\n0 1\n255\n",
                           "P6\n1 1\n65535\nabcdef", "P6\n-3 2\n255\n", "P6\n99999999999 2\n255\n", "P6 #"})
    EXPECT_THROW(decodeTexture(bytesOf(text), true), ParseError) << text;
}

}  // namespace
}  // namespace idap::render
