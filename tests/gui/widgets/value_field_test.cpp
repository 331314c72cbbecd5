#include "studio/widgets/value_field.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include "gui/support/gui_support.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/number_field.h"
#include "studio/widgets/section_box.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/text_field.h"

namespace idap {
namespace {

class ValueFieldTest : public testing::Test {
 protected:
  ValueFieldTest() {
    auto* column = new QVBoxLayout(&window);
    column->addWidget(&field);
    column->addWidget(&other);
    window.show();
    window.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    field.setValue(1.2);
    field.setFocus();
    field.selectAll();
  }
  void type(const char* text) { QTest::keyClicks(&field, QString::fromUtf8(text)); }

  QWidget window;
  LengthField field;
  QLineEdit other;
  QSignalSpy changed{&field, &ValueField::valueChanged};
};

TEST_F(ValueFieldTest, TakesASumInTheUsersUnitAndTellsOnce) {
  type("120+15");
  EXPECT_EQ(changed.count(), 0);
  QTest::keyClick(&field, Qt::Key_Return);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_DOUBLE_EQ(changed.at(0).at(0).toDouble(), 1.35);
  EXPECT_EQ(field.text(), "135 cm");
  other.setFocus();
  EXPECT_EQ(changed.count(), 1);
}

TEST_F(ValueFieldTest, TakesOtherUnits) {
  type("3.25m");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(field.value(), 3.25);
  field.selectAll();
  type("10'8\"");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_NEAR(field.value(), 3.2512, 1e-9);
  field.setUnit(LengthUnit::FeetInches);
  EXPECT_EQ(field.text(), "10' 8\"");
}

TEST_F(ValueFieldTest, LeavingApplies) {
  type("2m");
  other.setFocus();
  EXPECT_EQ(changed.count(), 1);
  EXPECT_DOUBLE_EQ(field.value(), 2);
}

TEST_F(ValueFieldTest, WrongTextIsMarkedAndNeverApplied) {
  const QColor usual = field.palette().color(QPalette::Base);
  type("12 apples");
  EXPECT_FALSE(field.problem().isEmpty());
  EXPECT_NE(field.palette().color(QPalette::Base), usual);
  QTest::keyClick(&field, Qt::Key_Return);
  other.setFocus();
  EXPECT_EQ(changed.count(), 0);
  EXPECT_DOUBLE_EQ(field.value(), 1.2);
  field.setFocus();
  QTest::keyClick(&field, Qt::Key_Escape);
  EXPECT_EQ(field.text(), "120 cm");
  EXPECT_TRUE(field.problem().isEmpty());
  EXPECT_EQ(field.palette().color(QPalette::Base), usual);
}

TEST_F(ValueFieldTest, LimitsRefuseWithWords) {
  field.setRange(0.5, 2);
  type("250");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_TRUE(field.problem().contains("200 cm")) << field.problem().toStdString();
  EXPECT_EQ(changed.count(), 0);
  QTest::keyClick(&field, Qt::Key_Escape);
  field.selectAll();
  type("200");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(changed.count(), 1);
}

TEST_F(ValueFieldTest, NewValuesDoNotDisturbTyping) {
  type("99");
  field.setValue(1.5);
  EXPECT_EQ(field.text(), "99");
  QTest::keyClick(&field, Qt::Key_Escape);
  EXPECT_EQ(field.text(), "150 cm");
  EXPECT_EQ(changed.count(), 0);
}

TEST_F(ValueFieldTest, EscapeIsForTheWindowWhenNothingIsTyped) {
  QKeyEvent escape(QEvent::KeyPress, Qt::Key_Escape, Qt::NoModifier);
  escape.accept();
  QApplication::sendEvent(&field, &escape);
  EXPECT_FALSE(escape.isAccepted());
}

TEST_F(ValueFieldTest, ArrowsStepAndApplyAtRest) {
  QSignalSpy stepping(&field, &ValueField::valueStepping);
  QTest::keyClick(&field, Qt::Key_Up);
  QTest::keyClick(&field, Qt::Key_Up);
  QTest::keyClick(&field, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_EQ(stepping.count(), 3);
  EXPECT_EQ(changed.count(), 0);
  EXPECT_EQ(field.text(), "112 cm");
  EXPECT_TRUE(test::waitFor([&] { return changed.count() == 1; }));
  EXPECT_NEAR(changed.at(0).at(0).toDouble(), 1.12, 1e-12);
}

TEST_F(ValueFieldTest, WheelStepsOnlyWithTheKeyboardInTheField) {
  const auto roll = [&](QWidget& at) {
    const QPointF middle(at.rect().center());
    QWheelEvent wheel(middle, at.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&at, &wheel);
  };
  roll(field);
  EXPECT_EQ(field.text(), "121 cm");
  other.setFocus();
  EXPECT_EQ(changed.count(), 1);
  roll(field);
  EXPECT_EQ(field.text(), "121 cm");
}

TEST_F(ValueFieldTest, SeveralValuesShowWordsAndTakeOne) {
  field.setMixed();
  EXPECT_TRUE(field.text().isEmpty());
  EXPECT_FALSE(field.placeholderText().isEmpty());
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(changed.count(), 0);
  type("120");
  QTest::keyClick(&field, Qt::Key_Return);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_FALSE(field.mixed());
}

TEST_F(ValueFieldTest, EnteringWhatIsShownChangesNothing) {
  field.setValue(1.23456);
  field.selectAll();
  type("123.46 cm");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(changed.count(), 0);
  EXPECT_DOUBLE_EQ(field.value(), 1.23456);
}

TEST_F(ValueFieldTest, UndoBelongsToTheHomeUnlessTyping) {
  const auto asks = [&] {
    QKeyEvent undo(QEvent::ShortcutOverride, Qt::Key_Z, Qt::ControlModifier);
    undo.ignore();
    QApplication::sendEvent(&field, &undo);
    return undo.isAccepted();
  };
  EXPECT_FALSE(asks());
  type("1");
  EXPECT_TRUE(asks());
}

TEST_F(ValueFieldTest, OptionalValuesCanBeEmptied) {
  QSignalSpy cleared(&field, &ValueField::cleared);
  QTest::keyClick(&field, Qt::Key_Delete);
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(cleared.count(), 0);
  EXPECT_EQ(field.text(), "120 cm");
  field.setOptional(true);
  field.selectAll();
  QTest::keyClick(&field, Qt::Key_Delete);
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(cleared.count(), 1);
  EXPECT_TRUE(field.none());
}

TEST(NumberFieldTest, ReadsSumsWithAndWithoutItsUnit) {
  NumberField field(nullptr, " lm", 0);
  QSignalSpy changed(&field, &ValueField::valueChanged);
  field.selectAll();
  QTest::keyClicks(&field, "400*2");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_EQ(field.text(), "800 lm");
  EXPECT_DOUBLE_EQ(field.value(), 800);
  field.selectAll();
  QTest::keyClicks(&field, "90 lm");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(field.value(), 90);
  field.selectAll();
  QTest::keyClicks(&field, "2.5");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_FALSE(field.problem().isEmpty());
  EXPECT_EQ(changed.count(), 2);
}

TEST(NumberFieldTest, AnglesAreDegrees) {
  AngleField field;
  field.selectAll();
  QTest::keyClicks(&field, "90-15°");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(field.value(), 75);
  EXPECT_EQ(field.text(), QString::fromUtf8("75°"));
  field.selectAll();
  QTest::keyClicks(&field, "3 m");
  QTest::keyClick(&field, Qt::Key_Return);
  EXPECT_FALSE(field.problem().isEmpty());
}

TEST(SliderFieldTest, SliderAndNumberAgree) {
  SliderField field(0, 100, 1, QStringLiteral(" %"), 0);
  field.setValue(40);
  EXPECT_EQ(field.slider()->value(), 40);
  QSignalSpy changed(&field, &SliderField::valueChanged);
  QSignalSpy changing(&field, &SliderField::valueChanging);
  field.slider()->setSliderDown(true);
  field.slider()->setValue(50);
  field.slider()->setValue(60);
  EXPECT_EQ(changing.count(), 2);
  EXPECT_EQ(changed.count(), 0);
  field.slider()->setSliderDown(false);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed.at(0).at(0).toDouble(), 60);
  field.number()->selectAll();
  QTest::keyClicks(field.number(), "75");
  QTest::keyClick(field.number(), Qt::Key_Return);
  EXPECT_EQ(field.slider()->value(), 75);
  EXPECT_EQ(changed.count(), 2);
}

TEST(TextFieldTest, AppliesWhenFinished) {
  TextField field;
  field.setValue(QStringLiteral("Bed"));
  QSignalSpy changed(&field, &TextField::valueChanged);
  field.end(false);
  QTest::keyClicks(&field, " one");
  EXPECT_EQ(changed.count(), 0);
  field.setValue(QStringLiteral("Sofa"));
  EXPECT_EQ(field.text(), "Bed one");
  QTest::keyClick(&field, Qt::Key_Return);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(changed.at(0).at(0).toString(), "Bed one");
  field.end(false);
  QTest::keyClicks(&field, "x");
  QTest::keyClick(&field, Qt::Key_Escape);
  EXPECT_EQ(field.text(), "Bed one");
  EXPECT_EQ(changed.count(), 1);
}

TEST(TextFieldTest, AreasTakeLineBreaks) {
  TextArea area;
  QSignalSpy changed(&area, &TextArea::valueChanged);
  QTest::keyClicks(&area, "one");
  QTest::keyClick(&area, Qt::Key_Return);
  QTest::keyClicks(&area, "two");
  QTest::keyClick(&area, Qt::Key_Return, Qt::ControlModifier);
  ASSERT_EQ(changed.count(), 1);
  EXPECT_EQ(area.value(), "one\ntwo");
}

TEST(SectionBoxTest, FoldsAndRemembers) {
  {
    SectionBox box(QStringLiteral("Size"), QStringLiteral("test-size"));
    EXPECT_TRUE(box.isOpen());
    box.setOpen(false);
    EXPECT_TRUE(box.body()->isHidden());
  }
  SectionBox again(QStringLiteral("Size"), QStringLiteral("test-size"));
  EXPECT_FALSE(again.isOpen());
  EXPECT_TRUE(again.body()->isHidden());
}

}  // namespace
}  // namespace idap
