#include "catalog/model_import.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"
#include "base/zip.h"
#include "catalog/library/install_library.h"

namespace idap {
namespace {

constexpr std::string_view kBox =
    "mtllib box.mtl\nv 0 0 0\nv 80 0 0\nv 80 75 0\nv 0 75 0\nv 0 0 -40\nv 80 0 -40\nv 80 75 -40\nv 0 75 -40\n"
    "f 1 2 3 4\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 4 3 7 8\nf 5 6 2 1\n";

SharedBytes shared(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(begin, begin + text.size());
}

class ModelImportTest : public testing::Test {
 protected:
  ModelImportTest() {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  ~ModelImportTest() override { std::filesystem::remove_all(folder); }
  std::filesystem::path write(const char* name, std::string_view text) {
    writeFileAtomically(folder / name, *shared(text));
    return folder / name;
  }
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("idap-model-import-" + std::to_string(::getpid()));
};

TEST_F(ModelImportTest, ReadsAModelWithWhatLiesBesideItAndItsSize) {
  write("box.mtl", "newmtl a\n");
  write("other.txt", "not asked for");
  const ModelImport import = readModelImport(write("side_table.obj", kBox));
  EXPECT_EQ(import.name, "Side table");
  EXPECT_EQ(import.kind, "obj");
  EXPECT_EQ(import.files.size(), 2u);
  EXPECT_TRUE(import.files.contains("box.mtl"));
  EXPECT_NEAR(import.fileSize.x, 80, 1e-3);
  EXPECT_NEAR(import.fileSize.y, 40, 1e-3);
  EXPECT_NEAR(import.fileSize.z, 75, 1e-3);
  EXPECT_EQ(likelyUnit(import), 0.01);
}

TEST_F(ModelImportTest, NeverReadsOutsideTheModelsFolder) {
  std::filesystem::create_directories(folder / "inner");
  write("secret.mtl", "newmtl a\n");
  writeFileAtomically(folder / "inner/a.obj",
                      *shared(std::string("mtllib ../secret.mtl\n") + std::string(kBox)));
  EXPECT_EQ(readModelImport(folder / "inner/a.obj").files.size(), 1u);
}

TEST_F(ModelImportTest, SaysWhatIsWrong) {
  EXPECT_THROW(readModelImport(folder / "missing.obj"), IoError);
  EXPECT_THROW(readModelImport(write("empty.obj", "")), ParseError);
  EXPECT_THROW(readModelImport(write("text.txt", "hello")), ParseError);
  EXPECT_THROW(readModelImport(write("none.zip", asText(writeZip({{"a.txt", shared("x")}})))), ParseError);
}

TEST(ImportRotation, PutsTheChosenAxisUp) {
  // A file's (x, y, z) with y up is (x, -z, y) in object space.
  const auto object = [](Vec3 file) { return Vec3{file.x, -file.z, file.y}; };
  const std::pair<UpAxis, Vec3> cases[] = {{UpAxis::Y, {0, 1, 0}},       {UpAxis::Z, {0, 0, 1}},
                                           {UpAxis::X, {1, 0, 0}},       {UpAxis::MinusY, {0, -1, 0}},
                                           {UpAxis::MinusZ, {0, 0, -1}}, {UpAxis::MinusX, {-1, 0, 0}}};
  for (const auto& [axis, up] : cases) {
    const auto r = importRotation(axis, 1);
    const Vec3 o = object(up);
    const Vec3 turned = r[0] * o.x + r[1] * o.y + r[2] * o.z;
    EXPECT_NEAR(turned.z, 1, 1e-12) << int(axis);
  }
}

TEST(ImportRotation, BringsEveryAxisOfAFileThatIsZUpUp) {
  // Its reader leaves such a file's axes as they are.
  const std::pair<UpAxis, Vec3> cases[] = {{UpAxis::Y, {0, 1, 0}},       {UpAxis::Z, {0, 0, 1}},
                                           {UpAxis::X, {1, 0, 0}},       {UpAxis::MinusY, {0, -1, 0}},
                                           {UpAxis::MinusZ, {0, 0, -1}}, {UpAxis::MinusX, {-1, 0, 0}}};
  for (const auto& [axis, up] : cases) {
    const auto r = importRotation(axis, 0, true);
    EXPECT_NEAR((r[0] * up.x + r[1] * up.y + r[2] * up.z).z, 1, 1e-12) << int(axis);
  }
}

TEST(ImportRotation, TurnsWidthIntoDepth) {
  const Vec3 size = rotatedSize({3, 2, 1}, importRotation(UpAxis::Y, 1));
  EXPECT_EQ(size.x, 2);
  EXPECT_EQ(size.y, 3);
  EXPECT_EQ(size.z, 1);
}

TEST(AssetFolder, IsOneThatNothingLiesIn) {
  std::map<std::string, SharedBytes> assets;
  EXPECT_EQ(freeAssetFolder(assets, "Side table"), "models/side-table/");
  assets["models/side-table/a.obj"] = shared("x");
  EXPECT_EQ(freeAssetFolder(assets, "Side table"), "models/side-table-2/");
  EXPECT_EQ(freeAssetFolder(assets, "โต๊ะ"), "models/model/");
}

TEST_F(ModelImportTest, ALibraryIsLookedAtInstalledAndFoundByACatalogThatRereads) {
  constexpr std::string_view kTable =
      "name=Test pieces\nid#1=t#1\nname#1=Red "
      "box\ncategory#1=Boxes\nmodel#1=/box.obj\nwidth#1=80\ndepth#1=40\n"
      "height#1=75\nid#2=t#2\nname#2=Lost\ncategory#2=Boxes\nmodel#2=/"
      "gone.obj\nwidth#2=80\ndepth#2=40\nheight#2=75\n";
  const auto file = write(
      "test.sh3f",
      asText(writeZip({{"PluginFurnitureCatalog.properties", shared(kTable)}, {"box.obj", shared(kBox)}})));
  const LibraryPreview preview = previewLibrary(file);
  EXPECT_EQ(preview.name, "Test pieces");
  EXPECT_EQ(preview.pieces, 1u);
  EXPECT_EQ(preview.faults.size(), 1u);
  EXPECT_THROW(previewLibrary(write("bad.sh3f", "no archive")), Error);

  const Catalog catalog({folder / "mine"});
  EXPECT_FALSE(catalog.librariesRead());
  EXPECT_EQ(catalog.find("t#1"), nullptr);
  EXPECT_TRUE(catalog.librariesRead());
  installLibrary(file, folder / "mine");
  installLibrary(file, folder / "mine");  // replaces
  EXPECT_EQ(catalog.find("t#1"), nullptr);
  catalog.reread();
  const CatalogPiecePtr piece = catalog.find("t#1");
  ASSERT_TRUE(piece);
  EXPECT_TRUE(catalog.model("t#1", piece->size));
}

}  // namespace
}  // namespace idap
