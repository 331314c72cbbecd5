#include "formats/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "base/error.h"
#include "base/file.h"

namespace idap {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RegistryTest : public testing::Test {
 protected:
  RegistryTest() {
    std::string name = (fs::temp_directory_path() / "idap-registry-XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~RegistryTest() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(RegistryTest, WritesAndReadsHomesByExtensionAndContent) {
  Home home;
  home.title = "My flat";
  writeHome(home, folder_ / "flat.IDAP");
  EXPECT_EQ(readHome(folder_ / "flat.IDAP").home, home);
  fs::rename(folder_ / "flat.IDAP", folder_ / "flat.renamed");
  EXPECT_EQ(readHome(folder_ / "flat.renamed").home, home) << "the content tells";
}

TEST_F(RegistryTest, SaysWhichFormatsThereAre) {
  try {
    writeHome({}, folder_ / "a.doc");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'doc'"));
    EXPECT_THAT(error.what(), HasSubstr(".idap"));
  }
  EXPECT_FALSE(fs::exists(folder_ / "a.doc"));
  std::ofstream(folder_ / "text.txt") << "no home";
  try {
    readHome(folder_ / "text.txt");
    FAIL();
  } catch (const ParseError& error) {
    EXPECT_EQ(error.file(), "text.txt");
    EXPECT_THAT(error.what(), HasSubstr(".idap, .sh3d"));
  }
  EXPECT_THROW(readHome(folder_ / "none.idap"), IoError);
}

TEST_F(RegistryTest, AFailedSaveLeavesTheOldHome) {
  const fs::path file = folder_ / "home.idap";
  Home home;
  home.name = "old";
  writeHome(home, file);
  Home broken = home;
  broken.wallHeight = -1;
  EXPECT_THROW(writeHome(broken, file), InvalidHome);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(writeHome(home, file, cancelled), Cancelled);
  EXPECT_EQ(readHome(file).home.name, "old");
  EXPECT_THROW(writeHome(home, folder_ / "none" / "home.idap"), IoError);
}

// Homes of another program hold what nobody thought of.
TEST_F(RegistryTest, ImportedHomesComeBackFromOurFormatAsTheyWere) {
  const fs::path homes = fs::path(IDAP_SOURCE_DIR) / ".." / "shared" / "homes";
  if (!fs::exists(homes)) GTEST_SKIP() << "no folder of sample homes at " << homes;
  for (const auto& entry : fs::directory_iterator(homes)) {
    if (entry.path().extension() != ".sh3d") continue;
    Home home = readHome(entry.path()).home;
    writeHome(home, folder_ / "copy.idap");
    const ReadResult back = readHome(folder_ / "copy.idap");
    EXPECT_TRUE(back.report.empty()) << entry.path();
    home.assets = back.home.assets;  // files that nothing uses are left out
    EXPECT_EQ(back.home, home) << entry.path();
  }
}

TEST_F(RegistryTest, EveryFormatCanBeTold) {
  for (const HomeFormat& format : homeFormats()) {
    EXPECT_FALSE(format.id.empty());
    EXPECT_FALSE(format.name.empty());
    EXPECT_FALSE(format.extensions.empty());
    EXPECT_TRUE(format.read || format.write) << format.id;
    if (format.sniffs) {
      EXPECT_FALSE(format.sniffs(std::make_shared<const Bytes>(), "empty"));
    }
  }
}

}  // namespace
}  // namespace idap
