#include "base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "base/error.h"

namespace idap {
namespace {

namespace fs = std::filesystem;

Bytes bytesOf(std::string_view text) {
  Bytes bytes;
  for (const char c : text) bytes.push_back(std::byte(c));
  return bytes;
}

class FileTest : public testing::Test {
 protected:
  FileTest() {
    std::string name = (fs::temp_directory_path() / "idap-file-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~FileTest() override {
    fs::permissions(folder_, fs::perms::owner_all);
    fs::remove_all(folder_);
  }
  std::size_t filesInFolder() const {
    return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  fs::path folder_;
};

TEST_F(FileTest, ReadsBackWhatItWrote) {
  for (const std::size_t size : {0u, 1u, 65536u, 1'000'003u}) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = std::byte(i * 31 >> 3);
    writeFileAtomically(folder_ / "a", bytes);
    EXPECT_EQ(readFile(folder_ / "a"), bytes);
  }
  EXPECT_EQ(filesInFolder(), 1u) << "a temporary file was left";
}

TEST_F(FileTest, SaysWhichFileAndWhy) {
  try {
    readFile(folder_ / "none");
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((folder_ / "none").string()));
    EXPECT_THAT(error.what(), testing::HasSubstr("No such file"));
  }
  EXPECT_THROW(readFile(folder_), IoError);
  EXPECT_THROW(writeFileAtomically(folder_, bytesOf("x")), IoError);
  EXPECT_THROW(writeFileAtomically(folder_ / "no" / "where", bytesOf("x")), IoError);
  writeFileAtomically(folder_ / "big", Bytes(1000));
  EXPECT_THROW(readFile(folder_ / "big", 999), IoError);
  EXPECT_EQ(readFile(folder_ / "big", 1000).size(), 1000u);
}

TEST_F(FileTest, AFullDeviceIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(writeFileAtomically("/dev/full", bytesOf("x")), IoError);
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device was replaced";
}

// A limit on file size stands for a disk that fills up half way through.
TEST_F(FileTest, ADiskThatFillsUpLeavesTheOldFile) {
  const fs::path file = folder_ / "home.idap";
  writeFileAtomically(file, bytesOf("old"));
  const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 4096;
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(writeFileAtomically(file, Bytes(100'000)), IoError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, oldHandler);
  EXPECT_EQ(readFile(file), bytesOf("old"));
  EXPECT_EQ(filesInFolder(), 1u) << "a temporary file was left";
}

TEST_F(FileTest, AnUnwritableFolderLeavesTheOldFile) {
  const fs::path file = folder_ / "home.idap";
  writeFileAtomically(file, bytesOf("old"));
  ::chmod(folder_.c_str(), 0555);
  // The superuser may write everywhere, so the test is somebody else for a moment.
  const bool superuser = ::geteuid() == 0;
  if (superuser) {
    ASSERT_EQ(::seteuid(65534), 0);
  }
  EXPECT_THROW(writeFileAtomically(file, bytesOf("new")), IoError);
  if (superuser) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(readFile(file), bytesOf("old"));
}

TEST_F(FileTest, KeepsPermissionsAndFollowsLinks) {
  const fs::path file = folder_ / "file", link = folder_ / "link";
  writeFileAtomically(file, bytesOf("old"));
  ::chmod(file.c_str(), 0640);
  fs::create_symlink("file", link);
  writeFileAtomically(link, bytesOf("new"));
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(readFile(file), bytesOf("new"));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
}

TEST_F(FileTest, NewFilesObeyTheUsersMask) {
  const mode_t old = ::umask(0027);
  writeFileAtomically(folder_ / "masked", bytesOf("x"));
  ::umask(old);
  EXPECT_EQ(fs::status(folder_ / "masked").permissions(), fs::perms(0640));
}

TEST_F(FileTest, ReadsPipesToTheirEnd) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    std::ofstream(pipe) << std::string(200'000, 'p');
    ::_exit(0);
  }
  EXPECT_EQ(readFile(pipe).size(), 200'000u);
}

}  // namespace
}  // namespace idap
