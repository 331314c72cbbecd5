#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "base/file.h"
#include "base/zip.h"
#include "gui/support/gui_support.h"
#include "model/edits/piece_edits.h"
#include "studio/catalog/import_dialog.h"
#include "studio/widgets/length_field.h"

namespace idap {
namespace {

constexpr std::string_view kBox =
    "mtllib box.mtl\nusemtl red\n"
    "v 0 0 0\nv 80 0 0\nv 80 75 0\nv 0 75 0\nv 0 0 -40\nv 80 0 -40\nv 80 75 -40\nv 0 75 -40\n"
    "f 1 2 3 4\nf 6 5 8 7\nf 5 1 4 8\nf 2 6 7 3\nf 4 3 7 8\nf 5 6 2 1\n";
constexpr std::string_view kMaterial = "newmtl red\nKd 0.8 0.1 0.1\n";
constexpr std::string_view kLibrary =
    "name=Test pieces\nlicense=CC0\n"
    "name#1=Red "
    "box\ncategory#1=Boxes\nmodel#1=/box.obj\nicon#1=/box.png\nwidth#1=80\ndepth#1=40\nheight#1=75\n"
    "movable#1=true\ndoorOrWindow#1=false\n";

SharedBytes shared(std::string_view text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(begin, begin + text.size());
}

class ImportDialogTest : public testing::Test {
 protected:
  std::filesystem::path write(const char* name, std::string_view text) {
    const auto path = std::filesystem::path(folder.path().toStdString()) / name;
    writeFileAtomically(path, *shared(text));
    return path;
  }
  template <class T>
  T* find(const char* name) {
    return dialog.findChild<T*>(QString::fromLatin1(name));
  }
  QPushButton* finish() { return find<QPushButton>("importFinish"); }
  bool waitForPage() {
    return test::waitFor([&] { return finish()->isVisible(); }, 20'000);
  }

  QTemporaryDir folder;
  std::shared_ptr<const Catalog> catalog =
      std::make_shared<const Catalog>(std::vector<std::filesystem::path>{userDataFolder() / "furniture"});
  Editor editor{catalog};
  ImportDialog dialog{editor};
};

TEST_F(ImportDialogTest, AModelBecomesAPieceOfItsTrueSizeInOneStep) {
  write("box.mtl", kMaterial);
  dialog.show();
  dialog.chooseFile(write("side_table.obj", kBox));
  ASSERT_TRUE(waitForPage());
  EXPECT_EQ(find<QLineEdit>("importName")->text(), "Side table");
  EXPECT_NEAR(find<LengthField>("importWidth")->value(), 0.8, 1e-6);
  EXPECT_NEAR(find<LengthField>("importDepth")->value(), 0.4, 1e-6);
  EXPECT_NEAR(find<LengthField>("importHeight")->value(), 0.75, 1e-6);
  test::waitFor([&] { return !find<QLabel>("importPicture")->pixmap(Qt::ReturnByValue).isNull(); }, 20'000);
  test::shoot(dialog, "import-model");

  QTest::mouseClick(find<QPushButton>("importTurn"), Qt::LeftButton);
  EXPECT_NEAR(find<LengthField>("importWidth")->value(), 0.4, 1e-6);
  QTest::mouseClick(find<QPushButton>("importTurn"), Qt::LeftButton);
  auto* width = find<LengthField>("importWidth");
  width->selectAll();
  QTest::keyClicks(width, "40");
  QTest::keyClick(width, Qt::Key_Return);
  EXPECT_NEAR(find<LengthField>("importHeight")->value(), 0.375, 1e-6);

  QTest::mouseClick(finish(), Qt::LeftButton);
  ASSERT_EQ(editor.home().furniture.size(), 1u);
  const Furniture& piece = *editor.home().furniture.begin()->second;
  EXPECT_EQ(piece.name, "Side table");
  EXPECT_EQ(piece.model.asset, "models/side-table/side_table.obj");
  EXPECT_TRUE(editor.home().assets->contains("models/side-table/side_table.obj"));
  EXPECT_TRUE(editor.home().assets->contains("models/side-table/box.mtl"));
  EXPECT_NEAR(piece.size.x, 0.4, 1e-6);
  EXPECT_EQ(editor.selection().furniture.size(), 1u);
  editor.undo();
  EXPECT_TRUE(editor.home().furniture.empty());
  EXPECT_TRUE(editor.home().assets->empty());
}

TEST_F(ImportDialogTest, AModelInAnArchiveBringsItsMaterials) {
  const Bytes zip = writeZip({{"chair/box.obj", shared(kBox)}, {"chair/box.mtl", shared(kMaterial)}});
  dialog.show();
  dialog.chooseFile(write("chair.zip", asText(zip)));
  ASSERT_TRUE(waitForPage());
  QTest::mouseClick(finish(), Qt::LeftButton);
  ASSERT_EQ(editor.home().furniture.size(), 1u);
  EXPECT_EQ(editor.home().assets->size(), 2u);
}

TEST_F(ImportDialogTest, AWindowJumpsIntoAWall) {
  editor.document().apply({"room", [](const Home&) { return makeRoomHome(4, 5, 2.5, 0.1, "Bedroom"); }});
  dialog.show();
  dialog.chooseFile(write("window.obj", kBox));
  ASSERT_TRUE(waitForPage());
  find<QComboBox>("importKind")->setCurrentIndex(3);
  QTest::mouseClick(finish(), Qt::LeftButton);
  ASSERT_EQ(editor.home().openings.size(), 1u);
  EXPECT_TRUE(bool(editor.home().openings.begin()->second->wall));
}

TEST_F(ImportDialogTest, SaysWhatIsWrongWithABadFile) {
  dialog.show();
  for (const auto& path : {write("empty.obj", ""), write("noise.3ds", "this is no model"),
                           write("half.glb", "glTF\2\0\0\0"), write("broken.zip", "PK\3\4 not really"),
                           write("broken.sh3f", "nothing"), std::filesystem::path("/nowhere/chair.obj")}) {
    dialog.chooseFile(path);
    auto* problem = find<QLabel>("importProblem");
    ASSERT_TRUE(test::waitFor([&] { return problem->isVisible(); })) << path;
    EXPECT_FALSE(problem->text().isEmpty());
    EXPECT_FALSE(finish()->isVisible());
    if (path.filename() == "noise.3ds") test::shoot(dialog, "import-problem");
  }
  EXPECT_TRUE(editor.home().furniture.empty());
}

TEST_F(ImportDialogTest, ALibraryBecomesPartOfTheCatalogAndIsReplacedOnlyWithWords) {
  const Bytes zip =
      writeZip({{"PluginFurnitureCatalog.properties", shared(kLibrary)}, {"box.obj", shared(kBox)}});
  const auto file = write("test-pieces.sh3f", asText(zip));
  dialog.show();
  dialog.chooseFile(file);
  ASSERT_TRUE(waitForPage());
  EXPECT_TRUE(find<QLabel>("importLibraryAbout")->text().contains("Red box"));
  EXPECT_FALSE(find<QLabel>("importLibraryReplaces")->isVisible());
  test::shoot(dialog, "import-library");
  QSignalSpy imported(&dialog, &ImportDialog::libraryImported);
  QTest::mouseClick(finish(), Qt::LeftButton);
  ASSERT_TRUE(test::waitFor([&] { return !imported.isEmpty(); }));
  EXPECT_EQ(catalog->pieces().size(), catalog->builtinPieces().size() + 1);

  ImportDialog again(editor);
  again.show();
  again.chooseFile(file);
  auto* replaces = again.findChild<QLabel*>("importLibraryReplaces");
  EXPECT_TRUE(test::waitFor([&] { return replaces->isVisible(); }));
}

}  // namespace
}  // namespace idap
