// The film window with real keys.
#include "studio/film/film_window.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QListWidget>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "gui/support/gui_support.h"
#include "model/edits/piece_edits.h"

namespace idap {
namespace {

using test::waitFor;

class FilmWindowTest : public testing::Test {
 protected:
  FilmWindowTest() : editor(std::make_shared<const Catalog>(std::vector<std::filesystem::path>{})) {
    Home home = makeRoomHome(4, 4, 2.5, 0.1, "Room");
    for (const auto& [name, x] : {std::pair("First", 0.8), std::pair("Second", 1.6)}) {
      Camera camera;
      camera.name = name;
      camera.eye = {x, 1.5, 1.6};
      home.cameras.set(home.newId<CameraId>(), camera);
    }
    editor.open(std::make_unique<Document>(home));
    window = std::make_unique<FilmWindow>(editor);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  }
  template <class W>
  W* part(const char* name) {
    W* found = window->findChild<W*>(QLatin1String(name));
    EXPECT_TRUE(found) << name;
    return found;
  }
  Editor editor;
  std::unique_ptr<FilmWindow> window;
};

TEST_F(FilmWindowTest, PointsOfViewAreOrderedByTheArrows) {
  auto* stops = part<QListWidget>("filmStops");
  ASSERT_EQ(stops->count(), 2);
  QTest::mouseClick(stops->viewport(), Qt::LeftButton, {}, stops->visualItemRect(stops->item(1)).center());
  QTest::mouseClick(part<QToolButton>("filmUp"), Qt::LeftButton);
  EXPECT_EQ(stops->item(0)->text(), "Second");
}

TEST_F(FilmWindowTest, WithoutAPointOfViewItSaysWhy) {
  auto* stops = part<QListWidget>("filmStops");
  for (int i = 0; i < 2; ++i) {
    stops->setFocus();
    stops->setCurrentRow(i);
    QTest::keyClick(stops, Qt::Key_Space);
  }
  EXPECT_TRUE(waitFor([this] { return !part<QPushButton>("filmBegin")->isEnabled(); }));
  EXPECT_FALSE(part<QLabel>("filmEstimate")->text().isEmpty());
}

TEST_F(FilmWindowTest, AShortFilmIsMadeWhileTheDesignGoesOn) {
  for (const char* box : {"filmSize", "filmQuality"}) {
    auto* combo = part<QComboBox>(box);
    combo->setFocus();
    QTest::keyClick(combo, Qt::Key_Home);
  }
  auto* rate = part<QSpinBox>("filmRate");
  rate->setFocus();
  rate->selectAll();
  QTest::keyClicks(rate, "5");
  QTest::keyClick(rate, Qt::Key_Tab);
  // From one place only: a look, no walk.
  auto* stops = part<QListWidget>("filmStops");
  stops->setFocus();
  stops->setCurrentRow(1);
  QTest::keyClick(stops, Qt::Key_Space);
  QTemporaryDir folder;
  const QString file = folder.filePath("walk.mp4");
  QSignalSpy done(window.get(), &FilmWindow::finished);
  window->make(file.toStdString());
  EXPECT_TRUE(window->busy());
  EXPECT_TRUE(editor.apply("title", [](const Home& before) {
    Home home = before;
    home.title = "meanwhile";
    return home;
  }));
  ASSERT_TRUE(waitFor([&] { return !window->busy(); }, 120'000));
  ASSERT_EQ(done.size(), 1);
  EXPECT_TRUE(done[0][0].toBool());
  EXPECT_GT(QFileInfo(file).size(), 1000);
  EXPECT_FALSE(part<QLabel>("filmPreview")->pixmap().isNull());
}

}  // namespace
}  // namespace idap
