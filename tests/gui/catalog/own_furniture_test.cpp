// Save as furniture with real keys: into the user's catalog, changed there, placed from it.
#include "editor/editor.h"

#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "catalog/library/own_library.h"
#include "gui/support/gui_support.h"
#include "studio/catalog/own_furniture_dialog.h"

namespace idap {
namespace {

using test::waitFor;

class OwnFurnitureTest : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove(OwnLibrary::userFile());
    Home home;
    for (const double x : {0.0, 1.0})
      home.furniture.set(home.newId<FurnitureId>(),
                         makeFurniture(*editor.catalog().find("idap/chair-windsor"), {x, 0, 0}));
    editor.open(std::make_unique<Document>(home));
    Elements both;
    for (const auto& [id, piece] : home.furniture) both.furniture.push_back(id);
    editor.select(both);
  }
  void TearDown() override { std::filesystem::remove(OwnLibrary::userFile()); }
  void save(OwnFurnitureDialog& dialog, const char* name) {
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
    auto* field = dialog.findChild<QLineEdit*>("ownName");
    auto* button = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, name);
    ASSERT_TRUE(waitFor([&] { return button->isEnabled(); }, 60'000));
    test::shoot(dialog, "own_furniture");
    QSignalSpy saved(&dialog, &OwnFurnitureDialog::saved);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(saved.size(), 1) << dialog.findChild<QLabel*>("ownProblem")->text().toStdString();
  }
  Editor editor{std::make_shared<const Catalog>(
      std::vector<std::filesystem::path>{OwnLibrary::userFile().parent_path()})};
};

TEST_F(OwnFurnitureTest, TwoChairsBecomeOnePieceOfTheCatalogThatCanBePlaced) {
  {
    OwnFurnitureDialog dialog(editor);
    EXPECT_FALSE(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->isEnabled());
    save(dialog, "Pair of chairs");
  }
  editor.catalog().reread();
  const CatalogPiecePtr piece = editor.catalog().find("own/pair-of-chairs");
  ASSERT_TRUE(piece);
  EXPECT_EQ(piece->name, "Pair of chairs");
  EXPECT_EQ(piece->category, "My furniture");
  EXPECT_GT(piece->size.x, 1.2);
  const SurfaceModelPtr model = editor.catalog().model(piece->id, piece->size);
  ASSERT_TRUE(model);
  EXPECT_GT(model->mesh.triangles.size(), 200u);
}

TEST_F(OwnFurnitureTest, ItsNameCanBeChanged) {
  {
    OwnFurnitureDialog dialog(editor);
    save(dialog, "Pair");
  }
  {
    OwnFurnitureDialog dialog(editor, "own/pair");
    EXPECT_EQ(dialog.findChild<QLineEdit*>("ownName")->text(), "Pair");
    save(dialog, "Two chairs");
  }
  editor.catalog().reread();
  ASSERT_TRUE(editor.catalog().find("own/pair"));
  EXPECT_EQ(editor.catalog().find("own/pair")->name, "Two chairs");
}

TEST_F(OwnFurnitureTest, APriceThatIsNoNumberIsSaidAndNothingIsSaved) {
  OwnFurnitureDialog dialog(editor);
  dialog.show();
  auto* button = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
  QTest::keyClicks(dialog.findChild<QLineEdit*>("ownName"), "Pair");
  QTest::keyClicks(dialog.findChild<QLineEdit*>("ownPrice"), "cheap");
  ASSERT_TRUE(waitFor([&] { return button->isEnabled(); }, 60'000));
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_FALSE(dialog.findChild<QLabel*>("ownProblem")->text().isEmpty());
  EXPECT_FALSE(std::filesystem::exists(OwnLibrary::userFile()));
}

}  // namespace
}  // namespace idap
