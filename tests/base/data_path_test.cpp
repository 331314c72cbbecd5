#include "base/data_path.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace idap {
namespace {

class DataPath : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const char* old = std::getenv("IDAP_DATA")) saved_ = old;
  }
  void TearDown() override {
    if (saved_.empty()) {
      ::unsetenv("IDAP_DATA");
    } else {
      ::setenv("IDAP_DATA", saved_.c_str(), 1);
    }
  }
  std::string saved_;
};

TEST_F(DataPath, TheVariableWins) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path();
  ::setenv("IDAP_DATA", folder.c_str(), 1);
  EXPECT_EQ(dataFolder(), folder);
}

TEST_F(DataPath, AVariableThatNamesNoFolderIsPassedOver) {
  ::setenv("IDAP_DATA", "/no/such/folder", 1);
  EXPECT_NE(dataFolder(), "/no/such/folder");
}

TEST_F(DataPath, AProgramInTheBuildFolderFindsTheSourceTree) {
  ::unsetenv("IDAP_DATA");
  EXPECT_EQ(dataFolder(), std::filesystem::path(IDAP_SOURCE_DIR) / "share");
}

}  // namespace
}  // namespace idap
