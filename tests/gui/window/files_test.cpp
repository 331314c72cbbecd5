// Files: opening, saving, closing, failing, and getting back what a crash left.
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QListWidget>

#include "formats/registry.h"
#include "gui/window/window_fixture.h"
#include "studio/window/recent_pictures.h"
#include "studio/window/welcome_page.h"

namespace idap::test {
namespace {

class FilesTest : public WindowTest {
 protected:
  static QString sample() { return QStringLiteral(IDAP_SOURCE_DIR "/share/samples/apartment.idap"); }
  std::string contents(const QString& file) {
    QFile in(file);
    return in.open(QIODevice::ReadOnly) ? in.readAll().toStdString() : std::string();
  }
};

TEST_F(FilesTest, AHomeOpensWithTheWindowAlive) {
  window().openFile(sample().toStdString());
  EXPECT_TRUE(window().busy());
  int turns = 0;
  EXPECT_TRUE(waitFor([&] { return ++turns, window().files().isOpen(); }));
  EXPECT_GT(turns, 0);
  EXPECT_GT(editor().home().furniture.size(), 10u);
  EXPECT_FALSE(editor().document().modified());
  EXPECT_TRUE(window().windowTitle().startsWith("apartment"));
  EXPECT_EQ(window().preferences().recentFiles().value(0), sample());
  QTest::qWait(300);
  shoot(window(), "apartment");
}

TEST_F(FilesTest, ALargeHouseOpensWhileTheWindowLives) {
  const QString house = QStringLiteral(IDAP_SOURCE_DIR "/../shared/homes/3-BedroomHouseWithMezzanine.sh3d");
  if (!QFileInfo::exists(house)) GTEST_SKIP() << "the sample homes of ../shared are not there";
  QElapsedTimer clock, turn;
  clock.start();
  turn.start();
  qint64 longest = 0;
  window().openFile(house.toStdString());
  ASSERT_TRUE(waitFor(
      [&] {
        longest = std::max(longest, turn.restart());
        return window().files().isOpen();
      },
      20000));
  window().repaint();
  RecordProperty("opened_ms", int(clock.elapsed()));
  RecordProperty("longest_turn_ms", int(longest));
  EXPECT_GT(editor().home().furniture.size(), 100u);
  shoot(window(), "house");
}

TEST_F(FilesTest, WhatCannotBeReadIsSaidAndTheOldHomeStays) {
  newRoom();
  editor().document().markSaved({});
  QFile broken(path("broken.idap"));
  ASSERT_TRUE(broken.open(QIODevice::WriteOnly));
  broken.write("not a home");
  broken.close();
  window().openFile(path("broken.idap").toStdString());
  QMessageBox* box = nullptr;
  EXPECT_TRUE(waitFor([&] { return (box = window().findChild<QMessageBox*>()) != nullptr; }));
  EXPECT_TRUE(box->text().contains("broken.idap"));
  box->close();
  EXPECT_EQ(editor().home().walls.size(), 4u);
}

TEST_F(FilesTest, SavingAsksForANameOnceAndThenJustSaves) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  EXPECT_TRUE(window().isWindowModified() || waitFor([&] { return window().isWindowModified(); }));
  QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
  choose("saveDialog", path("room"));
  ASSERT_TRUE(settle());
  EXPECT_FALSE(editor().document().modified());
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(readHome(path("room.idap").toStdString()).home, editor().home());
  put("idap/chair-windsor", {2, 1});
  window().activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window()));
  QTest::keyClick(&window(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(settle());
  EXPECT_EQ(readHome(path("room.idap").toStdString()).home.furniture.size(), 2u);
  EXPECT_TRUE(window().windowTitle().startsWith("room"));
  // A little later its picture is there for the first page.
  EXPECT_TRUE(waitFor([&] { return QFileInfo::exists(recentPicture(path("room.idap"))); }));
}

TEST_F(FilesTest, WhatIsDoneWhileSavingIsStillUnsaved) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  window().files().file().save(path("a.idap").toStdString());
  put("idap/chair-windsor", {2, 1});
  ASSERT_TRUE(settle());
  EXPECT_TRUE(editor().document().modified());
  EXPECT_EQ(readHome(path("a.idap").toStdString()).home.furniture.size(), 1u);
  editor().undo();
  EXPECT_FALSE(editor().document().modified());
}

TEST_F(FilesTest, AFailedSaveLeavesEverythingOpen) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  // A folder in the place of the file: nobody can write over that, not even root.
  ASSERT_TRUE(QDir(folder_.path()).mkpath("blocked.idap/inside"));
  window().files().file().save(path("blocked.idap").toStdString());
  auto* box = await<QMessageBox>("saveFailed");
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("blocked.idap"));
  EXPECT_TRUE(box->informativeText().contains("nothing of it is lost"));
  shoot(*box, "save_failed");
  box->close();
  EXPECT_TRUE(editor().document().modified());
  EXPECT_EQ(editor().home().furniture.size(), 1u);
  EXPECT_TRUE(window().isVisible());
}

TEST_F(FilesTest, AFileChangedByOthersIsNotOverwrittenUnasked) {
  newRoom();
  window().files().file().save(path("shared.idap").toStdString());
  ASSERT_TRUE(settle());
  QFile other(path("shared.idap"));
  ASSERT_TRUE(other.open(QIODevice::Append));
  other.write("somebody else");
  other.close();
  const std::string theirs = contents(path("shared.idap"));
  put("idap/chair-windsor", {1, 1});
  trigger("save");
  auto* box = await<QMessageBox>("changedOnDisk");
  ASSERT_TRUE(box);
  EXPECT_EQ(contents(path("shared.idap")), theirs);
  EXPECT_TRUE(editor().document().modified());
  for (QAbstractButton* button : box->buttons())
    if (box->buttonRole(button) == QMessageBox::DestructiveRole) QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return !editor().document().modified(); }));
  EXPECT_EQ(readHome(path("shared.idap").toStdString()).home.furniture.size(), 1u);
}

TEST_F(FilesTest, ClosingAsksAndCancelKeepsTheWindow) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  window().close();
  auto* box = await<QMessageBox>("askToSave");
  shoot(*box, "ask_to_save");
  press(box, QMessageBox::Cancel);
  QTest::qWait(20);
  EXPECT_TRUE(window().isVisible());
  EXPECT_EQ(editor().home().furniture.size(), 1u);
  window().close();
  press(await<QMessageBox>("askToSave"), QMessageBox::Discard);
  EXPECT_TRUE(waitFor([&] { return !window().isVisible(); }));
}

TEST_F(FilesTest, ClosingWithSaveWritesBeforeItCloses) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  window().close();
  press(await<QMessageBox>("askToSave"), QMessageBox::Save);
  choose("saveDialog", path("closing.idap"));
  EXPECT_TRUE(waitFor([&] { return !window().isVisible(); }));
  EXPECT_EQ(readHome(path("closing.idap").toStdString()).home.furniture.size(), 1u);
}

TEST_F(FilesTest, ClosingTheHomeGoesBackToTheFirstPage) {
  newRoom();
  editor().document().markSaved(path("x.idap").toStdString());
  trigger("close");
  EXPECT_FALSE(window().files().isOpen());
  EXPECT_TRUE(find<QWidget>("welcomePage")->isVisible());
  EXPECT_FALSE(window().findChild<QWidget*>("catalogDock")->isVisible());
}

TEST_F(FilesTest, OtherFormatsAreSavedAsIdapAndSayWhy) {
  newRoom();
  editor().document().markSaved(path("theirs.sh3d").toStdString());
  put("idap/chair-windsor", {1, 1});
  trigger("save");
  auto* dialog = await<QFileDialog>("saveDialog");
  ASSERT_TRUE(dialog);
  EXPECT_TRUE(dialog->windowTitle().contains("theirs.sh3d"));
  EXPECT_TRUE(dialog->selectedFiles().value(0).endsWith("theirs.idap"));
  dialog->close();
  EXPECT_TRUE(editor().document().modified());
}

TEST_F(FilesTest, WhatACrashLeftIsOfferedAndRestored) {
  newRoom();
  editor().document().markSaved(path("mine.idap").toStdString());
  put("idap/chair-windsor", {1, 1});
  Recovery& recovery = window().files().recovery();
  recovery.keep();
  ASSERT_TRUE(waitFor([&] { return !recovery.busy(); }));
  // A copy of what is on the disk at this moment is what a crash would leave.
  QDir left(QString::fromStdString(Recovery::folder().string()));
  QStringList kept = left.entryList({"*.idap", "*.json"}, QDir::Files);
  ASSERT_EQ(kept.size(), 2);
  for (const QString& file : kept)
    ASSERT_TRUE(QFile::copy(left.filePath(file), left.filePath("crashed." + QFileInfo(file).suffix())));
  recovery.drop();
  EXPECT_EQ(left.entryList({"*.idap"}, QDir::Files).size(), 1);

  const auto next = makeWindow();
  next->offerRestore();
  auto* box = await<QMessageBox>("askToRestore");
  ASSERT_TRUE(box);
  EXPECT_TRUE(box->text().contains("mine.idap"));
  shoot(*box, "ask_to_restore");
  for (QAbstractButton* button : box->buttons())
    if (box->buttonRole(button) == QMessageBox::AcceptRole) QTest::mouseClick(button, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return next->files().isOpen(); }));
  EXPECT_EQ(next->editor().home().furniture.size(), 1u);
  EXPECT_EQ(next->editor().document().file().filename(), "mine.idap");
  EXPECT_TRUE(next->editor().document().modified());
  EXPECT_TRUE(waitFor([&] { return !QFile::exists(left.filePath("crashed.idap")); }));
  EXPECT_EQ(left.entryList({"*.idap"}, QDir::Files).size(), 1);  // that of the new window
  next->editor().document().markSaved({});
}

TEST_F(FilesTest, ARunningProgramsCopyIsNotOffered) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  Recovery& recovery = window().files().recovery();
  recovery.keep();
  ASSERT_TRUE(waitFor([&] { return !recovery.busy(); }));
  const auto next = makeWindow();
  next->offerRestore();
  QTest::qWait(30);
  EXPECT_FALSE(find<QMessageBox>("askToRestore"));
}

TEST_F(FilesTest, TemplatesStartAHomeThatIsInNoFile) {
  const auto all = homeTemplates(QStringLiteral("en"));
  if (all.empty()) GTEST_SKIP() << "no templates are installed";
  for (const HomeTemplate& one : all) {
    EXPECT_FALSE(one.name.isEmpty());
    EXPECT_TRUE(QFileInfo::exists(one.picture)) << one.picture.toStdString();
  }
  window().files().startFromTemplate(all[0].file);
  ASSERT_TRUE(waitFor([&] { return window().files().isOpen(); }));
  EXPECT_TRUE(editor().document().file().empty());
  EXPECT_GT(editor().home().walls.size(), 0u);
}

TEST_F(FilesTest, RecentFilesAreOnTheFirstPageAndOpenByAClick) {
  newRoom();
  window().files().file().save(path("once.idap").toStdString());
  ASSERT_TRUE(settle());
  trigger("close");
  auto* recent = window().findChild<QListWidget*>("recentFiles");
  ASSERT_TRUE(recent);
  ASSERT_GE(recent->count(), 1);
  EXPECT_EQ(recent->item(0)->text(), QStringLiteral("once"));
  QTest::mouseClick(recent->viewport(), Qt::LeftButton, {}, recent->visualItemRect(recent->item(0)).center());
  EXPECT_TRUE(waitFor([&] { return window().files().isOpen(); }));
  EXPECT_EQ(editor().document().file().filename(), "once.idap");
}

TEST_F(FilesTest, TheFurnitureListIsExported) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  trigger("export-csv");
  choose("csvDialog", path("list.csv"));
  EXPECT_TRUE(waitFor([&] { return contents(path("list.csv")).find('\n') != std::string::npos; }));
}

TEST_F(FilesTest, TheHomeIsExportedInThreeDimensions) {
  newRoom();
  put("idap/chair-windsor", {1, 1});
  bool said = false;
  const int subscription = editor().subscribe(
      {.said = [&](const Text&, Editor::Severity severity) { said = severity != Editor::Severity::Error; }});
  trigger("export-scene");
  choose("sceneDialog", path("home.glb"));
  EXPECT_TRUE(waitFor([&] { return said; }));
  editor().unsubscribe(subscription);
  const std::string glb = contents(path("home.glb"));
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_NE(glb.find("\"meshes\""), std::string::npos);
}

}  // namespace
}  // namespace idap::test
