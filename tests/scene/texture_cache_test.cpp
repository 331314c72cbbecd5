#include "scene/texture_cache.h"

#include <gtest/gtest.h>

#include <cstring>

namespace idap {
namespace {

// A binary portable pixmap of grey values.
SharedBytes pixmap(int width, int height, const std::vector<unsigned char>& greys) {
  std::string text = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
  for (const unsigned char g : greys) text.append(3, static_cast<char>(g));
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return std::make_shared<const Bytes>(std::move(bytes));
}

TEST(TextureCache, AMaskGoesIntoTheAlphaOfItsPicture) {
  TextureCache cache;
  const SharedBytes picture = pixmap(1, 1, {100}), mask = pixmap(2, 1, {0, 255});
  const render::TexturePtr t = cache.get({picture, "leaf", true, mask});
  ASSERT_TRUE(t);
  EXPECT_TRUE(t->hasAlpha);
  ASSERT_EQ(t->width, 2);
  EXPECT_EQ(t->rgba[0], 100);
  EXPECT_EQ(t->rgba[3], 0);
  EXPECT_EQ(t->rgba[4], 100);
  EXPECT_EQ(t->rgba[7], 255);
  EXPECT_FALSE(cache.get({picture, "leaf", true, nullptr})->hasAlpha);
  EXPECT_EQ(cache.get({nullptr, "white", true, mask})->rgba[4], 255) << "without a picture it is white";
  EXPECT_TRUE(cache.warnings().empty());
}

TEST(TextureCache, EachPictureIsDecodedOnce) {
  TextureCache cache;
  const SharedBytes picture = pixmap(1, 1, {100});
  EXPECT_EQ(cache.get({picture, "a", true, nullptr}), cache.get({picture, "b", true, nullptr}));
  EXPECT_NE(cache.get({picture, "a", true, nullptr}), cache.get({picture, "a", false, nullptr}));
}

TEST(TextureCache, WhatCannotBeReadIsToldOnce) {
  TextureCache cache;
  const auto broken = std::make_shared<const Bytes>(Bytes(8));
  EXPECT_FALSE(cache.get({broken, "broken", true, nullptr}));
  EXPECT_FALSE(cache.get({broken, "broken", true, nullptr}));
  EXPECT_EQ(cache.warnings().size(), 1u);
}

}  // namespace
}  // namespace idap
