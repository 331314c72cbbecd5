#include "studio/picture/picture_panel.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "formats/registry.h"
#include "gui/support/gui_support.h"
#include "studio/picture/picture_canvas.h"
#include "studio/widgets/texts.h"

namespace idap {
namespace {

using test::shoot;
using test::waitFor;

constexpr int kLong = 60'000;  // ms: for a machine under load

Home smallRoom() {
  return readHome(std::filesystem::path(IDAP_SOURCE_DIR) / "share/templates/bathroom.idap").home;
}

class PicturePanelTest : public testing::Test {
 protected:
  PicturePanelTest() : editor(std::make_shared<const Catalog>(std::vector<std::filesystem::path>{})) {
    editor.open(std::make_unique<Document>(smallRoom()));
    panel = std::make_unique<PicturePanel>(editor);
    panel->setQuality(1, 60);
    panel->resize(260, 200);
    panel->show();
  }
  template <class W>
  W* child(const char* name) {
    return panel->findChild<W*>(QLatin1String(name));
  }
  bool pictureMade() {
    return waitFor([&] { return !panel->busy(); }, kLong) && !panel->picture().isNull();
  }
  void moveSomething() {
    ASSERT_TRUE(editor.apply("Move", [](const Home& before) {
      Home home = before;
      const auto& [id, first] = *home.furniture.begin();
      Furniture piece = *first;
      piece.position.x += 0.1;
      home.furniture.set(id, piece);
      return home;
    }));
  }

  Editor editor;
  std::unique_ptr<PicturePanel> panel;
};

TEST_F(PicturePanelTest, BeginsEmptyAndTracesAtTheClickOfTheBigButton) {
  EXPECT_TRUE(child<QWidget>("empty")->isVisible());
  EXPECT_FALSE(child<QToolButton>("savePicture")->isEnabled());
  shoot(*panel, "picture-empty");
  QSignalSpy started(panel.get(), &PicturePanel::started), finished(panel.get(), &PicturePanel::finished);
  QTest::mouseClick(child<QPushButton>("begin"), Qt::LeftButton);
  EXPECT_TRUE(panel->busy());
  EXPECT_EQ(started.count(), 1);
  EXPECT_TRUE(child<QWidget>("progress")->isVisible());
  EXPECT_TRUE(child<QToolButton>("stop")->isVisible());
  ASSERT_TRUE(pictureMade());
  EXPECT_EQ(finished.count(), 1);
  EXPECT_FALSE(child<QWidget>("progress")->isVisible());
  EXPECT_FALSE(child<QWidget>("empty")->isVisible());
  EXPECT_FALSE(child<QWidget>("outdated")->isVisible());
  EXPECT_TRUE(child<QToolButton>("savePicture")->isEnabled());
  const QImage picture = panel->picture();
  const QSize canvas = child<PictureCanvas>("canvas")->size();
  EXPECT_NEAR(double(picture.width()) / picture.height(), double(canvas.width()) / canvas.height(), 0.03);
  shoot(*panel, "picture-made");
}

TEST_F(PicturePanelTest, ACoarsePictureComesBeforeTheFineOne) {
  panel->resize(500, 400);
  panel->setQuality(1000, 600);
  panel->rayTrace();
  ASSERT_TRUE(waitFor([&] { return !panel->picture().isNull(); }, kLong));
  EXPECT_TRUE(panel->busy());
  EXPECT_LT(panel->picture().width(), child<PictureCanvas>("canvas")->width());
}

TEST_F(PicturePanelTest, StopKeepsThePicture) {
  panel->setQuality(1000, 600);
  panel->rayTrace();
  ASSERT_TRUE(waitFor([&] { return !panel->picture().isNull(); }, kLong));
  shoot(*panel, "picture-tracing");
  QTest::mouseClick(child<QToolButton>("stop"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !panel->busy(); }, kLong));
  EXPECT_FALSE(panel->picture().isNull());
  EXPECT_FALSE(child<QToolButton>("stop")->isVisible());
}

TEST_F(PicturePanelTest, StoppedBeforeAnythingIsSeenItIsEmptyAgain) {
  panel->rayTrace();
  panel->stop();
  ASSERT_TRUE(waitFor([&] { return !panel->busy(); }, kLong));
  EXPECT_EQ(panel->picture().isNull(), child<QWidget>("empty")->isVisible());
}

TEST_F(PicturePanelTest, ClosingWhileTracingDoesNotWaitForThePicture) {
  panel->setQuality(100'000, 600);
  panel->rayTrace();
  ASSERT_TRUE(waitFor([&] { return !panel->picture().isNull(); }, kLong));
  QElapsedTimer clock;
  clock.start();
  panel.reset();
  EXPECT_LT(clock.elapsed(), 20'000);  // of 600 s
}

TEST_F(PicturePanelTest, SaysWhenTheHomeHasChangedSince) {
  panel->rayTrace();
  moveSomething();
  ASSERT_TRUE(pictureMade());
  EXPECT_TRUE(panel->outdated());
  EXPECT_TRUE(child<QWidget>("outdated")->isVisible());
  shoot(*panel, "picture-outdated");
  editor.undo();
  EXPECT_FALSE(panel->outdated());
  EXPECT_FALSE(child<QWidget>("outdated")->isVisible());
  editor.redo();
  QTest::mouseClick(child<QPushButton>("outdated"), Qt::LeftButton);
  EXPECT_TRUE(panel->busy());
  ASSERT_TRUE(pictureMade());
  EXPECT_FALSE(panel->outdated());
}

TEST_F(PicturePanelTest, SeesFromAboveOrFromACameraOfTheHome) {
  auto* cameras = child<QComboBox>("camera");
  ASSERT_EQ(cameras->count(), 1 + int(editor.home().cameras.size()));
  EXPECT_EQ(cameras->currentIndex(), 0);
  panel->rayTrace();
  ASSERT_TRUE(pictureMade());
  const QImage above = panel->picture();
  panel->setCamera(editor.home().cameras.begin()->first);
  EXPECT_EQ(cameras->currentText(), toQt(editor.home().cameras.begin()->second->name));
  panel->rayTrace();
  ASSERT_TRUE(waitFor([&] { return !panel->busy(); }, kLong));
  EXPECT_NE(panel->picture(), above);
}

TEST_F(PicturePanelTest, ARemovedCameraGivesWayToTheViewFromAbove) {
  const CameraId first = editor.home().cameras.begin()->first;
  panel->setCamera(first);
  ASSERT_TRUE(editor.apply("Delete", [&](const Home& before) {
    Home home = before;
    home.cameras.erase(first);
    return home;
  }));
  EXPECT_EQ(child<QComboBox>("camera")->currentIndex(), 0);
  editor.undo();
  EXPECT_EQ(child<QComboBox>("camera")->count(), 1 + int(editor.home().cameras.size()));
}

TEST_F(PicturePanelTest, AnotherHomeBeginsWithoutAPicture) {
  panel->rayTrace();
  ASSERT_TRUE(pictureMade());
  editor.open(std::make_unique<Document>(Home{}));
  EXPECT_TRUE(panel->picture().isNull());
  EXPECT_TRUE(child<QWidget>("empty")->isVisible());
}

TEST_F(PicturePanelTest, AnotherHomeWhileTracingIsNotGivenThePictureOfTheOld) {
  panel->rayTrace();
  editor.open(std::make_unique<Document>(Home{}));
  ASSERT_TRUE(waitFor([&] { return !panel->busy(); }, kLong));
  EXPECT_TRUE(panel->picture().isNull());
}

TEST_F(PicturePanelTest, AnEmptyHomeCanBeTraced) {
  editor.open(std::make_unique<Document>(Home{}));
  panel->rayTrace();
  EXPECT_TRUE(pictureMade());
}

TEST_F(PicturePanelTest, ResizingTracesNothing) {
  panel->rayTrace();
  ASSERT_TRUE(pictureMade());
  const QImage before = panel->picture();
  panel->resize(500, 300);
  QTest::qWait(20);
  EXPECT_FALSE(panel->busy());
  EXPECT_EQ(panel->picture(), before);
  shoot(*panel, "picture-wider");
}

TEST_F(PicturePanelTest, SavesPngAndJpegAndSaysSo) {
  std::vector<std::pair<Text, Editor::Severity>> said;
  Editor::Listener listener;
  listener.said = [&](const Text& text, Editor::Severity severity) { said.emplace_back(text, severity); };
  const int handle = editor.subscribe(listener);
  const QTemporaryDir folder;
  panel->rayTrace();
  ASSERT_TRUE(pictureMade());
  for (const char* name : {"a.png", "a.jpg"}) {
    said.clear();
    panel->savePicture(folder.filePath(QLatin1String(name)));
    ASSERT_TRUE(waitFor([&] { return !said.empty(); }, kLong));
    EXPECT_EQ(said.back().second, Editor::Severity::Note);
    EXPECT_EQ(QImage(folder.filePath(QLatin1String(name))).size(), panel->picture().size());
  }
  said.clear();
  panel->savePicture(folder.filePath(QStringLiteral("no-such-folder/a.png")));
  ASSERT_TRUE(waitFor([&] { return !said.empty(); }, kLong));
  EXPECT_EQ(said.back().second, Editor::Severity::Error);
  editor.unsubscribe(handle);
}

TEST_F(PicturePanelTest, ADoubleClickAsksForTheWholeWindow) {
  QSignalSpy asked(panel.get(), &PicturePanel::maximiseRequested);
  QTest::mouseDClick(child<QWidget>("canvas"), Qt::LeftButton, {}, QPoint(5, 5));
  QTest::mouseClick(child<QToolButton>("maximise"), Qt::LeftButton);
  EXPECT_EQ(asked.count(), 2);
}

TEST_F(PicturePanelTest, ShowsTheTimeOfDay) {
  EXPECT_THAT(fromQt(child<QLabel>("time")->text()), testing::HasSubstr("15:00"));
}

}  // namespace
}  // namespace idap
