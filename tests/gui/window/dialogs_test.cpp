// The dialogs: what they show, what OK does, what Cancel leaves.
#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTextBrowser>
#include <QTimeZone>
#include <QTreeWidget>
#include <numbers>

#include "gui/window/window_fixture.h"
#include "studio/window/dialogs/background_dialog.h"
#include "studio/window/dialogs/cities.h"
#include "studio/window/dialogs/print_dialog.h"

namespace idap::test {
namespace {

class DialogsTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    newRoom();
  }
  QDialog* open(const char* action, const char* name) {
    trigger(action);
    auto* dialog = await<QDialog>(name);
    if (dialog) {
      QTest::qWait(30);
      shoot(*dialog, name);
    }
    return dialog;
  }
  void ok(QDialog* dialog) {
    QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
  }
  void type(QDialog* dialog, const char* field, const char* text) {
    auto* line = dialog->findChild<QLineEdit*>(field);
    ASSERT_TRUE(line) << field;
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, text);
  }
};

TEST_F(DialogsTest, TextGivesTitleAndNotesInOneStep) {
  QDialog* dialog = open("text", "textDialog");
  ASSERT_TRUE(dialog);
  type(dialog, "title", "Our bedroom");
  QTest::keyClicks(dialog->findChild<QPlainTextEdit*>("notes"), "Paint first");
  ok(dialog);
  EXPECT_EQ(editor().home().title, "Our bedroom");
  EXPECT_EQ(editor().home().notes, "Paint first");
  editor().undo();
  EXPECT_EQ(editor().home().title, "");
  EXPECT_FALSE(editor().document().canUndo());
}

TEST_F(DialogsTest, ATownSetsPlaceAndTimeZone) {
  QDialog* dialog = open("compass", "siteDialog");
  ASSERT_TRUE(dialog);
  auto* city = dialog->findChild<QComboBox*>("city");
  const int bangkok = city->findText("Bangkok");
  ASSERT_GT(bangkok, 0);
  city->setCurrentIndex(bangkok);
  emit city->activated(bangkok);
  type(dialog, "north", "90");
  dialog->findChild<QDateTimeEdit*>("time")->setDateTime(
      QDateTime(QDate(2026, 6, 21), QTime(12, 0), Qt::UTC));
  ok(dialog);
  const Site& site = editor().home().site;
  EXPECT_NEAR(site.latitude, 13.76 * std::numbers::pi / 180, 1e-6);
  EXPECT_NEAR(site.longitude, 100.5 * std::numbers::pi / 180, 1e-6);
  EXPECT_EQ(site.timeZone, "Asia/Bangkok");
  EXPECT_NEAR(site.north, -std::numbers::pi / 2, 1e-9);  // clockwise for people, counter-clockwise inside
  // Noon in Bangkok is five in the morning in Greenwich.
  EXPECT_EQ(site.time, QDateTime(QDate(2026, 6, 21), QTime(5, 0), Qt::UTC).toMSecsSinceEpoch());
}

TEST_F(DialogsTest, NothingTouchedChangesNothing) {
  for (const auto& [action, name] : {std::pair{"compass", "siteDialog"}, std::pair{"text", "textDialog"},
                                     std::pair{"level-properties", "levelDialog"}}) {
    const Home before = editor().home();
    QDialog* dialog = open(action, name);
    ASSERT_TRUE(dialog);
    ok(dialog);
    EXPECT_EQ(editor().home(), before) << name;
    EXPECT_FALSE(editor().document().modified()) << name;
    QTest::qWait(10);
  }
}

TEST_F(DialogsTest, EveryTownIsInItsZone) {
  for (const City& city : cities()) {
    EXPECT_LE(std::abs(city.latitude), 90);
    const QTimeZone zone{QByteArray(city.timeZone)};
    ASSERT_TRUE(zone.isValid()) << city.name;
    // Clocks follow the sun to within a few hours everywhere.
    const double hours = zone.standardTimeOffset(QDateTime::currentDateTime()) / 3600.0;
    EXPECT_NEAR(hours, city.longitude / 15, 2.6) << city.name;
  }
}

TEST_F(DialogsTest, ALevelIsRenamedAndRaised) {
  trigger("add-level");
  QDialog* dialog = open("level-properties", "levelDialog");
  ASSERT_TRUE(dialog);
  type(dialog, "name", "Attic");
  type(dialog, "height", "2.2m");
  ok(dialog);
  const Level& level = *editor().home().levels.find(editor().level());
  EXPECT_EQ(level.name, "Attic");
  EXPECT_NEAR(level.height, 2.2, 1e-9);
}

TEST_F(DialogsTest, PreferencesChangeUnitAndThemeForAllWindows) {
  const auto other = makeWindow();
  QDialog* dialog = open("preferences", "preferencesDialog");
  ASSERT_TRUE(dialog);
  auto* unit = dialog->findChild<QComboBox*>("unit");
  unit->setCurrentIndex(unit->findText("Millimetres"));
  dialog->findChild<QComboBox*>("theme")->setCurrentIndex(2);
  type(dialog, "wallThickness", "240");
  ok(dialog);
  EXPECT_EQ(editor().settings().unit, LengthUnit::Millimetre);
  EXPECT_EQ(other->editor().settings().unit, LengthUnit::Millimetre);
  EXPECT_NEAR(editor().settings().wallThickness, 0.24, 1e-9);
  EXPECT_LT(QApplication::palette().color(QPalette::Window).lightness(), 128);
  QTest::qWait(50);
  shoot(window(), "dark");
  // Kept for the next start.
  EXPECT_EQ(Preferences().editor().unit, LengthUnit::Millimetre);
  EXPECT_EQ(Preferences().theme(), Preferences::Theme::Dark);
  window().preferences().setTheme(Preferences::Theme::Light);
  EXPECT_GT(QApplication::palette().color(QPalette::Window).lightness(), 128);
}

TEST_F(DialogsTest, ABackgroundPictureIsPutUnderTheLevel) {
  QImage scan(400, 300, QImage::Format_RGB32);
  scan.fill(Qt::yellow);
  ASSERT_TRUE(scan.save(path("scan.png")));
  auto* dialog = qobject_cast<BackgroundDialog*>(open("background", "backgroundDialog"));
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->findChild<QPushButton*>("calibrate")->isEnabled());
  EXPECT_TRUE(dialog->usePicture(path("scan.png")));
  ASSERT_EQ(editor().home().backgrounds.size(), 1u);
  const Background& background = editor().home().backgrounds.begin()->second;
  EXPECT_TRUE(editor().home().assets->contains(background.asset));
  EXPECT_GT(background.scale, 0);
  shoot(*dialog, "background_with_picture");
  QTest::mouseClick(dialog->findChild<QPushButton*>("calibrate"), Qt::LeftButton);
  EXPECT_FALSE(dialog->isVisible());
  EXPECT_FALSE(editor().selecting());
  editor().undo();
  editor().undo();
  EXPECT_TRUE(editor().home().backgrounds.empty());
}

TEST_F(DialogsTest, WhatIsNoPictureIsRefusedInWords) {
  QFile file(path("text.png"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("hello");
  file.close();
  auto* dialog = qobject_cast<BackgroundDialog*>(open("background", "backgroundDialog"));
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->usePicture(path("text.png")));
  EXPECT_TRUE(dialog->findChild<QLabel*>("problem")->text().contains("text.png"));
  EXPECT_TRUE(editor().home().backgrounds.empty());
}

TEST_F(DialogsTest, APlanIsPrintedIntoAPdf) {
  put("idap/chair-windsor", {1, 1});
  auto* dialog = dynamic_cast<PrintDialog*>(open("print", "printDialog"));
  ASSERT_TRUE(dialog);
  for (int scale = 0; scale < dialog->findChild<QComboBox*>("scale")->count(); ++scale)
    dialog->findChild<QComboBox*>("scale")->setCurrentIndex(scale);
  dialog->writePdf(path("plan.pdf"));
  QFile pdf(path("plan.pdf"));
  ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
  EXPECT_TRUE(pdf.read(5) == "%PDF-");
}

TEST_F(DialogsTest, ChoicesOfPrintingAreThereTheNextTime) {
  put("idap/chair-windsor", {1, 1});
  for (const bool again : {false, true}) {
    auto* dialog = dynamic_cast<PrintDialog*>(open("print", "printDialog"));
    ASSERT_TRUE(dialog);
    auto* scale = dialog->findChild<QComboBox*>("scale");
    auto* title = dialog->findChild<QCheckBox*>("titleBlock");
    if (!again) {
      scale->setFocus();
      QTest::keyClicks(scale, "1:100");
      QTest::keyClick(title, Qt::Key_Space);
    }
    EXPECT_DOUBLE_EQ(dialog->job().scale, 1.0 / 100) << again;
    EXPECT_FALSE(dialog->job().titleBlock) << again;
    dialog->setChoices("{damaged");
    dialog->setChoices(R"({"scale": 12345, "titleBlock": false})");
    EXPECT_DOUBLE_EQ(dialog->job().scale, 1.0 / 100) << again;
    const QPointer<QDialog> closing(dialog);
    dialog->reject();
    ASSERT_TRUE(QTest::qWaitFor([&closing] { return closing.isNull(); }));
  }
}

TEST_F(DialogsTest, KeysAreListedAndSearched) {
  QDialog* dialog = open("keys", "keysDialog");
  ASSERT_TRUE(dialog);
  auto* list = dialog->findChild<QTreeWidget*>("keyList");
  EXPECT_GT(list->topLevelItemCount(), 40);
  QTest::keyClicks(dialog->findChild<QLineEdit*>("search"), "Ctrl+S");
  int shown = 0;
  for (int i = 0; i < list->topLevelItemCount(); ++i) shown += !list->topLevelItem(i)->isHidden();
  EXPECT_GE(shown, 2);
  EXPECT_LT(shown, 20);
  dialog->close();
  QDialog* about = open("about", "aboutDialog");
  ASSERT_TRUE(about);
  EXPECT_TRUE(about->findChild<QTextBrowser*>()->toPlainText().contains("General Public License"));
}

TEST_F(DialogsTest, NewAsksForTheSizeDrawn) {
  editor().document().markSaved({});
  QDialog* dialog = open("new", "newRoomDialog");
  ASSERT_TRUE(dialog);
  type(dialog, "roomX", "6m");
  QTest::mouseClick(dialog->findChild<QPushButton*>("startRoom"), Qt::LeftButton);
  Box2 box;
  for (const Vec2 p : editor().home().rooms.begin()->second->points) box.add(p);
  EXPECT_NEAR(box.max.x - box.min.x, 6, 1e-9);
}

}  // namespace
}  // namespace idap::test
