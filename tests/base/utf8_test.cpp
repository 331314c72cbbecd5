#include "base/utf8.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

TEST(Utf8, KnowsWellFormedText) {
  EXPECT_TRUE(isUtf8(""));
  EXPECT_TRUE(isUtf8("plain \xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8F\xA0"));
  for (const char* bad : {"\x80", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80",
                          "\xFF", "\xE2\x82", "\xF0\x9F\x8F"})
    EXPECT_FALSE(isUtf8(bad));
}

TEST(Utf8, ReplacesWhatIsNot) {
  EXPECT_EQ(toValidUtf8("Caf\xE9!"), "Caf\xEF\xBF\xBD!");
  EXPECT_EQ(toValidUtf8("\xE2\x82\xAC"), "\xE2\x82\xAC");
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b) {
      const char text[] = {char(a), char(b), 'x'};
      const std::string mended = toValidUtf8(std::string_view(text, 3));
      ASSERT_TRUE(isUtf8(mended));
      ASSERT_EQ(mended.back(), 'x');
    }
}

TEST(Utf8, CutsBetweenCharacters) {
  EXPECT_EQ(utf8Prefix("a\xE2\x82\xAC", 3), "a");
  EXPECT_EQ(utf8Prefix("a\xE2\x82\xAC", 4), "a\xE2\x82\xAC");
  EXPECT_EQ(utf8Prefix("abc", 2), "ab");
}

}  // namespace
}  // namespace idap
