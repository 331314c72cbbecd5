// What can be chosen of parametric pieces: numbers, switches and choices, each one undo step.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QTest>

#include "gui/support/gui_support.h"
#include "model/edits/piece_edits.h"
#include "studio/properties/property_panel.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/number_field.h"

namespace idap {
namespace {

class ParametersTest : public testing::Test {
 protected:
  ParametersTest() {
    panel.resize(320, 1100);
    panel.show();
    panel.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&panel));
  }
  void put(const char* id) {
    FurnitureEdit edit = addFurniture(Home(), makeFurniture(*catalog->find(id), {0, 0, 0}));
    piece = edit.furniture;
    editor.open(std::make_unique<Document>(edit.home));
    editor.select(only(piece));
    ASSERT_TRUE(test::waitFor([&] {
      const auto* section = panel.findChild<QWidget*>("parametersSection");
      return section && section->isVisible();
    }));
  }
  template <class T>
  T* field(const char* name) {
    const QString full = QStringLiteral("parameter-") + QLatin1String(name);
    test::waitFor([&] { return panel.findChild<T*>(full) && panel.findChild<T*>(full)->isVisible(); });
    T* found = panel.findChild<T*>(full);
    EXPECT_TRUE(found) << name;
    return found;
  }
  double chosen(const char* name) {
    const auto& parameters = editor.home().furniture.find(piece)->model.parameters;
    const auto found = parameters.find(name);
    return found == parameters.end() ? -1 : found->second;
  }

  std::shared_ptr<const Catalog> catalog =
      std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
  Editor editor{catalog};
  PropertyPanel panel{editor};
  FurnitureId piece;
};

TEST_F(ParametersTest, DoorsAreCountedAndUndone) {
  put("idap/wardrobe-hinged");
  const Home before = editor.home();
  auto* doors = field<NumberField>("doors");
  ASSERT_TRUE(doors);
  const double was = doors->value();
  doors->setFocus();
  doors->selectAll();
  QTest::keyClicks(doors, "5");
  QTest::keyClick(doors, Qt::Key_Return);
  EXPECT_EQ(chosen("doors"), 5);
  test::shoot(panel, "parameters-wardrobe");
  editor.undo();
  EXPECT_EQ(editor.home(), before);
  EXPECT_TRUE(test::waitFor([&] { return doors->value() == was; }));
}

TEST_F(ParametersTest, StylesAreChosen) {
  put("idap/wardrobe-hinged");
  auto* fronts = field<QComboBox>("front");
  ASSERT_TRUE(fronts);
  EXPECT_GT(fronts->count(), 4);
  fronts->setFocus();
  const int was = fronts->currentIndex();
  QTest::keyClick(fronts, was == 0 ? Qt::Key_Down : Qt::Key_Up);
  EXPECT_EQ(chosen("front"), fronts->currentIndex());
  EXPECT_NE(fronts->currentIndex(), was);
  editor.undo();
  EXPECT_TRUE(test::waitFor([&] { return fronts->currentIndex() == was; }));
}

TEST_F(ParametersTest, PartsAreSwitchedOnAndMeasuredInTheUsersUnit) {
  put("idap/table-dining");
  auto* shelf = field<QCheckBox>("shelf");
  ASSERT_TRUE(shelf);
  QTest::mouseClick(shelf, Qt::LeftButton, {}, QPoint(6, shelf->height() / 2));
  EXPECT_EQ(chosen("shelf"), 1);
  auto* apron = field<LengthField>("apron");
  ASSERT_TRUE(apron);
  apron->setFocus();
  apron->selectAll();
  QTest::keyClicks(apron, "12");
  QTest::keyClick(apron, Qt::Key_Return);
  EXPECT_NEAR(chosen("apron"), 0.12, 1e-9);
  test::shoot(panel, "parameters-table");
}

TEST_F(ParametersTest, SolidsHaveTheirs) {
  put("idap/solid-cylinder");
  auto* axis = field<QComboBox>("axis");
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->count(), 3);
  auto* taper = field<NumberField>("taper");
  ASSERT_TRUE(taper);
  taper->setFocus();
  taper->selectAll();
  QTest::keyClicks(taper, "25");
  QTest::keyClick(taper, Qt::Key_Return);
  EXPECT_NEAR(chosen("taper"), 0.25, 1e-9);
  test::shoot(panel, "parameters-cylinder");
}

}  // namespace
}  // namespace idap
