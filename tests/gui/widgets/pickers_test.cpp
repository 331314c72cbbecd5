#include <gtest/gtest.h>

#include <QAbstractItemView>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "gui/support/gui_support.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/material_popup.h"
#include "studio/widgets/material_swatches.h"

namespace idap {
namespace {

class MaterialPickerTest : public testing::Test {
 protected:
  MaterialPickerTest() {
    picker.resize(200, 28);
    picker.show();
    QObject::connect(&picker, &MaterialPicker::finishChosen, &picker,
                     [this](const FinishChoice& choice) { chosen.push_back(choice); });
  }
  MaterialPopup* open() {
    QTest::mouseClick(&picker, Qt::LeftButton);
    return picker.findChild<MaterialPopup*>();
  }
  MaterialPicker picker;
  std::vector<FinishChoice> chosen;
};

TEST_F(MaterialPickerTest, SearchAndEnterTakeAMaterial) {
  MaterialPopup* popup = open();
  ASSERT_NE(popup, nullptr);
  auto* search = popup->findChild<QLineEdit*>("materialSearch");
  QTest::keyClicks(search, "walnut");
  QTest::keyClick(search, Qt::Key_Return);
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].finish.material, "walnut");
  EXPECT_EQ(picker.words(), "Walnut");
  EXPECT_FALSE(popup->isVisible());
}

TEST_F(MaterialPickerTest, MaterialsAreInGroupsWithSwatches) {
  MaterialPopup* popup = open();
  ASSERT_NE(popup, nullptr);
  auto* list = popup->findChild<QAbstractItemView*>("materialList");
  EXPECT_EQ(list->model()->index(0, 0).data().toString(), "Wood");
  EXPECT_FALSE(list->model()->index(0, 0).flags() & Qt::ItemIsEnabled);
  EXPECT_TRUE(test::waitFor([&] { return !MaterialSwatches::shared().material("oak").isNull(); }));
  if (!qEnvironmentVariableIsEmpty("IDAP_SHOTS")) QTest::qWait(3000);
  test::shoot(*popup, "material-popup");
  const QModelIndex oak = list->model()->index(1, 0);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(oak).center());
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(chosen[0].finish.material, "oak");
  test::shoot(picker, "material-picker");
}

TEST_F(MaterialPickerTest, TakesAPictureFileWithItsProportions) {
  const QTemporaryDir folder;
  QImage tiles(40, 20, QImage::Format_RGB32);
  tiles.fill(Qt::red);
  const QString file = folder.filePath("my tiles.png");
  ASSERT_TRUE(tiles.save(file));
  ASSERT_TRUE(picker.takePicture(file)) << picker.problem().toStdString();
  ASSERT_EQ(chosen.size(), 1u);
  ASSERT_TRUE(chosen[0].finish.texture.has_value());
  EXPECT_EQ(chosen[0].finish.texture->asset, "textures/my-tiles.png");
  EXPECT_DOUBLE_EQ(chosen[0].finish.texture->size.y, 0.5);
  const Home home = withAsset(Home{}, chosen[0]);
  EXPECT_TRUE(home.assets->contains("textures/my-tiles.png"));

  // Its size can be typed, in the popup.
  picker.setFinish(chosen[0].finish, home.assets);
  MaterialPopup* popup = open();
  ASSERT_NE(popup, nullptr);
  auto* width = popup->findChild<LengthField*>("pictureWidth");
  ASSERT_NE(width, nullptr);
  width->selectAll();
  QTest::keyClicks(width, "30");
  QTest::keyClick(width, Qt::Key_Return);
  test::shoot(*popup, "material-popup-picture");
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_DOUBLE_EQ(chosen[1].finish.texture->size.x, 0.3);
  EXPECT_EQ(chosen[1].asset, nullptr);
}

TEST_F(MaterialPickerTest, RefusesWhatIsNoPicture) {
  const QTemporaryDir folder;
  QFile file(folder.filePath("notes.png"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no picture");
  file.close();
  EXPECT_FALSE(picker.takePicture(file.fileName()));
  EXPECT_TRUE(picker.problem().contains("notes.png"));
  EXPECT_FALSE(picker.takePicture(folder.filePath("nowhere.png")));
  EXPECT_TRUE(chosen.empty());
}

TEST_F(MaterialPickerTest, EmptiesAFinish) {
  Finish finish;
  finish.material = "oak";
  picker.setFinish(finish);
  MaterialPopup* popup = open();
  ASSERT_NE(popup, nullptr);
  QTest::mouseClick(popup->findChild<QPushButton*>("plainFinish"), Qt::LeftButton);
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_TRUE(chosen[0].finish.empty());
  EXPECT_EQ(picker.words(), "As it comes");
}

TEST(ColorButtonTest, TakesACodeAndRemembersIt) {
  ColorButton button;
  button.resize(120, 28);
  button.show();
  std::vector<std::optional<Color>> chosen;
  QObject::connect(&button, &ColorButton::colorChanged, &button,
                   [&](const std::optional<Color>& color) { chosen.push_back(color); });
  QTest::mouseClick(&button, Qt::LeftButton);
  auto* popup = button.findChild<QFrame*>("colorPalette");
  ASSERT_NE(popup, nullptr);
  test::shoot(*popup, "color-palette");
  auto* code = popup->findChild<QLineEdit*>("colorCode");
  QTest::keyClicks(code, "nothing");
  QTest::keyClick(code, Qt::Key_Return);
  EXPECT_TRUE(chosen.empty());
  code->selectAll();
  QTest::keyClicks(code, "336699");
  QTest::keyClick(code, Qt::Key_Return);
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(toQt(*chosen[0]).name(), "#336699");
  ASSERT_FALSE(recentColors().empty());
  EXPECT_EQ(recentColors().front().name(), "#336699");
}

TEST(ColorButtonTest, CanBeWithoutAColour) {
  ColorButton button;
  button.setOptional(true);
  button.setColor(Color{1, 0, 0});
  button.show();
  int cleared = 0;
  QObject::connect(&button, &ColorButton::colorChanged, &button,
                   [&](const std::optional<Color>& color) { cleared += !color; });
  QTest::mouseClick(&button, Qt::LeftButton);
  auto* none = button.findChild<QPushButton*>("noColor");
  ASSERT_NE(none, nullptr);
  QTest::mouseClick(none, Qt::LeftButton);
  EXPECT_EQ(cleared, 1);
}

}  // namespace
}  // namespace idap
