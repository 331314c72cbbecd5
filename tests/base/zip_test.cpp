#include "base/zip.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>
#include <thread>

#include "base/error.h"
#include "base/file.h"

namespace idap {
namespace {

SharedBytes bytesOf(std::string_view text) {
  Bytes bytes;
  for (const char c : text) bytes.push_back(std::byte(c));
  return std::make_shared<const Bytes>(std::move(bytes));
}

SharedBytes zipOf(const std::map<std::string, SharedBytes>& entries) {
  return std::make_shared<const Bytes>(writeZip(entries));
}

TEST(Zip, ReadsBackWhatItWrote) {
  const auto large = std::make_shared<const Bytes>(Bytes(300'000, std::byte{7}));
  const auto archive = zipOf({{"b/c.txt", bytesOf("hello")},
                              {"a", bytesOf("")},
                              {"gr\xC3\xB6\xC3\x9F"
                               "e",
                               large}});
  EXPECT_TRUE(looksLikeZip(*archive));
  const ZipReader zip(archive, "test.zip");
  EXPECT_EQ(zip.entries(), (std::vector<std::string>{"a", "b/c.txt",
                                                     "gr\xC3\xB6\xC3\x9F"
                                                     "e"}));
  EXPECT_EQ(asText(zip.read("b/c.txt")), "hello");
  EXPECT_TRUE(zip.read("a").empty());
  EXPECT_EQ(zip.read(zip.entries()[2]), *large);
  EXPECT_EQ(zip.size("b/c.txt"), 5u);
  EXPECT_FALSE(zip.contains("none"));
  EXPECT_THROW(zip.read("none"), ParseError);
  EXPECT_THROW(zip.size("none"), ParseError);
}

TEST(Zip, ReadsStraightFromAFile) {
  const auto file = std::filesystem::temp_directory_path() / ("idap-zip-test-" + std::to_string(::getpid()));
  writeFileAtomically(file, *zipOf({{"a", bytesOf("text")}}));
  EXPECT_EQ(asText(ZipReader(file).read("a")), "text");
  std::filesystem::remove(file);
  EXPECT_THROW(ZipReader{file}, IoError);
}

TEST(Zip, EqualContentGivesEqualBytes) {
  const std::map<std::string, SharedBytes> entries{{"x", bytesOf("1")}, {"y", bytesOf("2")}};
  EXPECT_EQ(*zipOf(entries), *zipOf(entries));
  EXPECT_TRUE(ZipReader(zipOf({}), "empty.zip").entries().empty());
}

TEST(Zip, RefusesNamesThatLeaveTheArchive) {
  for (const char* name : {"../evil", "a/../../evil", "/etc/passwd", "c:evil", "a\\..\\b", "a/.."}) {
    const auto archive = zipOf({{name, bytesOf("x")}});
    try {
      ZipReader zip(archive, "hostile.zip");
      ADD_FAILURE() << name << " was let in";
    } catch (const ParseError& error) {
      EXPECT_EQ(error.file(), "hostile.zip");
      EXPECT_EQ(error.place(), name);
    }
  }
  EXPECT_NO_THROW(ZipReader(zipOf({{"a..b/...c", bytesOf("x")}}), "fine.zip"));
}

TEST(Zip, KeepsItsLimits) {
  const auto bomb = zipOf({{"zeros", std::make_shared<const Bytes>(Bytes(8 << 20))}});
  EXPECT_THROW(ZipReader(bomb, "bomb.zip", {.maxRatio = 100}), ParseError);
  EXPECT_THROW(ZipReader(bomb, "bomb.zip", {.maxEntryBytes = 1 << 20}), ParseError);
  EXPECT_NO_THROW(ZipReader(bomb, "bomb.zip", {.maxRatio = 1e6}));
  const auto two = zipOf({{"a", bytesOf("12345")}, {"b", bytesOf("67890")}});
  EXPECT_THROW(ZipReader(two, "two.zip", {.maxTotalBytes = 9}), ParseError);
  EXPECT_THROW(ZipReader(two, "two.zip", {.maxEntries = 1}), ParseError);
  EXPECT_NO_THROW(ZipReader(two, "two.zip", {.maxEntries = 2, .maxTotalBytes = 10}));
}

TEST(Zip, DamageIsFoundNotRead) {
  const auto good = zipOf({{"a", bytesOf("a text that is long enough to be hit")}, {"b", bytesOf("b")}});
  std::mt19937 random(2);
  for (int round = 0; round < 3000; ++round) {
    Bytes bad = *good;
    for (int i = 0; i <= round % 4; ++i) bad[random() % bad.size()] = std::byte(random());
    if (round % 5 == 0) bad.resize(random() % bad.size());
    try {
      const ZipReader zip(std::make_shared<const Bytes>(bad), "bad.zip");
      for (const std::string& entry : zip.entries()) zip.read(entry);
    } catch (const ParseError&) {
    }
  }
  EXPECT_THROW(ZipReader(bytesOf("not a zip"), "x"), ParseError);
  EXPECT_THROW(ZipReader(bytesOf(""), "x"), ParseError);
}

TEST(Zip, ServesSeveralThreads) {
  std::map<std::string, SharedBytes> entries;
  for (int i = 0; i < 50; ++i) entries[std::to_string(i)] = bytesOf("entry " + std::to_string(i));
  const ZipReader zip(zipOf(entries), "many.zip");
  std::vector<std::thread> threads;
  std::atomic<int> wrong = 0;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (const std::string& name : zip.entries())
        if (asText(zip.read(name)) != "entry " + name) ++wrong;
    });
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace idap
