// The picture window with real mouse and key events.
#include "studio/picture/picture_window.h"

#include <gmock/gmock.h>

#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include "formats/registry.h"
#include "gui/support/gui_support.h"
#include "studio/picture/compare_view.h"
#include "studio/picture/light_mixer.h"
#include "studio/picture/picture_form.h"
#include "studio/picture/picture_queue.h"

namespace idap {
namespace {

using test::shoot;
using test::waitFor;

constexpr int kLong = 60'000;  // ms: for a machine under load

class PictureWindowTest : public testing::Test {
 protected:
  PictureWindowTest() : editor(std::make_shared<const Catalog>(std::vector<std::filesystem::path>{})) {
    Home home = readHome(std::filesystem::path(IDAP_SOURCE_DIR) / "share/templates/bathroom.idap").home;
    home.cameras = {};
    Camera camera;
    camera.name = "Door";
    camera.eye = {0.5, 0.5, 1.5};
    camera.yaw = -0.7;
    home.cameras.set(home.newId<CameraId>(), camera);
    editor.open(std::make_unique<Document>(home));
    window = std::make_unique<PictureWindow>(editor);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    smallAndQuick();
  }
  template <class W>
  W* part(const char* name) {
    W* found = window->findChild<W*>(QLatin1String(name));
    EXPECT_TRUE(found) << name;
    return found;
  }
  void type(QSpinBox* box, int value) {
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, QString::number(value));
    QTest::keyClick(box, Qt::Key_Tab);
  }
  void smallAndQuick() {
    type(part<QSpinBox>("pictureWidth"), 48);
    type(part<QSpinBox>("pictureHeight"), 32);
    auto* quality = part<QComboBox>("pictureQuality");
    quality->setFocus();
    QTest::keyClick(quality, Qt::Key_Home);
  }
  // Ticks or unticks by the mouse on the box.
  void tick(int row) {
    auto* views = part<QListWidget>("pictureViews");
    const QRect item = views->visualItemRect(views->item(row));
    QTest::mouseClick(views->viewport(), Qt::LeftButton, {}, QPoint(item.left() + 10, item.center().y()));
  }
  void press(const char* name) { QTest::mouseClick(part<QWidget>(name), Qt::LeftButton); }
  bool done() {
    return waitFor([this] { return window->queue().jobs().empty(); }, kLong);
  }

  Editor editor;
  std::unique_ptr<PictureWindow> window;
};

TEST_F(PictureWindowTest, EveryTickedPointOfViewBecomesAPictureOfTheGallery) {
  auto* views = part<QListWidget>("pictureViews");
  ASSERT_EQ(views->count(), 2);
  EXPECT_EQ(views->item(0)->checkState(), Qt::Checked);
  tick(1);
  EXPECT_EQ(part<QPushButton>("pictureBegin")->text(), "&Ray Trace 2 pictures");
  press("pictureBegin");
  EXPECT_EQ(window->queue().jobs().size(), 2u);
  ASSERT_TRUE(done());
  ASSERT_EQ(editor.home().pictures.size(), 2u);
  EXPECT_EQ(part<QListWidget>("gallery")->count(), 2);
  const auto& [id, picture] = *editor.home().pictures.begin();
  EXPECT_EQ(picture->name, "From above");
  EXPECT_EQ(picture->settings.width, 48);
  EXPECT_GE(picture->samples, 1);
  EXPECT_TRUE(editor.document().modified());
  EXPECT_FALSE(editor.document().canUndo());
  EXPECT_EQ(part<CompareView>("pictureView")->picture().size(), QSize(48, 32));
  shoot(*window, "picture_window");
}

TEST_F(PictureWindowTest, PicturesComeBackWithTheFile) {
  press("pictureBegin");
  ASSERT_TRUE(done());
  QTemporaryDir folder;
  const std::filesystem::path file = folder.path().toStdString() + "/home.idap";
  writeHome(editor.home(), file);
  editor.open(std::make_unique<Document>(readHome(file).home));
  auto* gallery = part<QListWidget>("gallery");
  ASSERT_EQ(gallery->count(), 1);
  QTest::mouseClick(gallery->viewport(), Qt::LeftButton, {},
                    gallery->visualItemRect(gallery->item(0)).center());
  EXPECT_EQ(part<CompareView>("pictureView")->picture().size(), QSize(48, 32));
}

TEST_F(PictureWindowTest, WithNothingTickedItSaysWhy) {
  tick(0);
  EXPECT_FALSE(part<QPushButton>("pictureBegin")->isEnabled());
  EXPECT_FALSE(part<QLabel>("pictureTrouble")->text().isEmpty());
}

TEST_F(PictureWindowTest, ProportionsHoldWhileAWidthIsTyped) {
  auto* proportion = part<QComboBox>("pictureProportion");
  proportion->setFocus();
  QTest::keyClicks(proportion, "16:9");
  type(part<QSpinBox>("pictureWidth"), 320);
  EXPECT_EQ(part<QSpinBox>("pictureHeight")->value(), 180);
}

TEST_F(PictureWindowTest, MadeAgainAfterAChangeTheTwoAreComparedByADivider) {
  press("pictureBegin");
  ASSERT_TRUE(done());
  ASSERT_TRUE(editor.apply("Repaint", [](const Home& before) {
    Home home = before;
    for (const auto& [id, room] : before.rooms) {
      Room red = *room;
      red.floor = plain(Color{1, 0, 0});
      home.rooms.set(id, red);
    }
    return home;
  }));
  press("makeAgain");
  ASSERT_TRUE(done());
  ASSERT_EQ(editor.home().pictures.size(), 2u);
  auto* view = part<CompareView>("pictureView");
  ASSERT_TRUE(view->comparing());
  QTest::mousePress(view, Qt::LeftButton, {}, view->rect().center());
  QTest::mouseMove(view, view->rect().center() + QPoint(view->width() / 8, 0));
  QTest::mouseRelease(view, Qt::LeftButton, {}, view->rect().center() + QPoint(view->width() / 8, 0));
  EXPECT_GT(view->divider(), 0.55);
  const double before = view->divider();
  QTest::keyClick(view, Qt::Key_Left);
  EXPECT_LT(view->divider(), before);
  shoot(*window, "picture_compare");
}

TEST_F(PictureWindowTest, StopKeepsWhatThereIsAndAPauseHoldsStill) {
  auto* quality = part<QComboBox>("pictureQuality");
  quality->setFocus();
  QTest::keyClick(quality, Qt::Key_End);  // by time
  type(part<QSpinBox>("pictureSeconds"), 600);
  press("pictureBegin");
  ASSERT_TRUE(waitFor([this] { return !window->queue().jobs().front().preview.isNull(); }, kLong));
  QTest::mouseClick(part<QToolButton>("jobPause"), Qt::LeftButton);
  EXPECT_EQ(window->queue().jobs().front().state, PictureQueue::Job::State::Paused);
  QTest::mouseClick(part<QToolButton>("jobPause"), Qt::LeftButton);
  EXPECT_EQ(window->queue().jobs().front().state, PictureQueue::Job::State::Tracing);
  QTest::mouseClick(part<QToolButton>("jobKeep"), Qt::LeftButton);
  ASSERT_TRUE(done());
  EXPECT_EQ(editor.home().pictures.size(), 1u);
}

TEST_F(PictureWindowTest, GivenUpAPictureLeavesNothing) {
  auto* quality = part<QComboBox>("pictureQuality");
  quality->setFocus();
  QTest::keyClick(quality, Qt::Key_End);
  press("pictureBegin");
  ASSERT_TRUE(waitFor([this] { return !window->findChildren<QToolButton*>("jobRemove").empty(); }));
  QTest::mouseClick(part<QToolButton>("jobRemove"), Qt::LeftButton);
  ASSERT_TRUE(done());
  EXPECT_TRUE(editor.home().pictures.empty());
}

TEST_F(PictureWindowTest, ADeletedPictureComesBackWithUndo) {
  press("pictureBegin");
  ASSERT_TRUE(done());
  press("removePicture");
  EXPECT_TRUE(editor.home().pictures.empty());
  editor.undo();
  EXPECT_EQ(editor.home().pictures.size(), 1u);
}

TEST_F(PictureWindowTest, TheClassicLookIsOf1993sSize) {
  auto* look = part<QComboBox>("pictureLook");
  look->setFocus();
  QTest::keyClick(look, Qt::Key_End);
  EXPECT_EQ(part<QSpinBox>("pictureWidth")->value(), 320);
  EXPECT_EQ(part<QSpinBox>("pictureHeight")->value(), 200);
  press("pictureBegin");
  ASSERT_TRUE(done());
  EXPECT_TRUE(editor.home().pictures.begin()->second->settings.classic);
}

TEST_F(PictureWindowTest, AGalleryPictureIsSavedAsEveryKind) {
  press("pictureBegin");
  ASSERT_TRUE(done());
  const PictureId id = editor.home().pictures.begin()->first;
  QTemporaryDir folder;
  for (const char* extension : {"png", "jpg", "pcx", "gif", "exr"}) {
    const QString file = folder.path() + "/picture." + extension;
    window->savePicture(id, file);
    EXPECT_TRUE(waitFor([&] { return QFile::exists(file) && QFileInfo(file).size() > 100; })) << extension;
  }
}

TEST_F(PictureWindowTest, LightsAreMixedKeptAndTakenOver) {
  press("pictureBegin");
  ASSERT_TRUE(done());
  ASSERT_EQ(part<QListWidget>("gallery")->count(), 1);
  auto* mixer = part<LightMixer>("lightMixer");
  EXPECT_FALSE(mixer->isVisible());
  press("mixPicture");
  EXPECT_TRUE(mixer->isVisible());
  ASSERT_TRUE(waitFor([&] { return mixer->ready(); }, kLong));
  QTest::qWait(50);
  shoot(*window, "light_mixer");
  auto* rows = part<QScrollArea>("mixLights");
  EXPECT_LE(rows->widget()->minimumSizeHint().width(), rows->viewport()->width()) << "cut off at the right";
  EXPECT_LE(mixer->mapTo(window.get(), QPoint(mixer->width(), 0)).x(), window->width());
  EXPECT_FALSE(mixer->changed());
  EXPECT_FALSE(part<QPushButton>("mixKeep")->isEnabled());

  // The first lamp of the list, after sky and sun.
  std::size_t group = 2;
  while (!window->findChild<QWidget*>(QStringLiteral("mixStrength%1").arg(group))) ++group;
  const FurnitureId lamp = mixer->film()->lamps[group];
  const bool wasOn = editor.home().furniture.find(lamp)->lamp->on;
  QImage mixed;
  QObject::connect(mixer, &LightMixer::previewed, mixer, [&](const QImage& picture) { mixed = picture; });
  const auto brightness = [&] {
    double sum = 0;
    for (int y = 0; y < mixed.height(); ++y)
      for (int x = 0; x < mixed.width(); ++x) sum += qGray(mixed.pixel(x, y));
    return sum;
  };
  auto* strength = part<QWidget>(QStringLiteral("mixStrength%1").arg(group).toLatin1().constData());
  auto* slider = strength->findChild<QSlider*>();
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_Right);
  QTest::keyClick(slider, Qt::Key_Left);
  const double asItWas = brightness();
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_LT(brightness(), asItWas);
  EXPECT_TRUE(mixer->changed());

  press("mixTakeOver");
  EXPECT_FALSE(editor.home().furniture.find(lamp)->lamp->on);
  editor.undo();
  EXPECT_EQ(editor.home().furniture.find(lamp)->lamp->on, wasOn);

  press("mixKeep");
  ASSERT_TRUE(waitFor([&] { return part<QListWidget>("gallery")->count() == 2; }, kLong));
  EXPECT_FALSE(mixer->isVisible());
  EXPECT_TRUE(part<QListWidget>("gallery")->item(1)->text().contains(QStringLiteral("other light")) ||
              part<QListWidget>("gallery")->item(0)->text().contains(QStringLiteral("other light")));
}

TEST_F(PictureWindowTest, LookBrightnessAndLensAreKeptWithThePicture) {
  const auto choose = [&](const char* name, int row) {
    auto* box = part<QComboBox>(name);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < row; ++i) QTest::keyClick(box, Qt::Key_Down);
  };
  choose("pictureLook", 1);
  choose("pictureSharpness", 2);
  auto* slider = part<QWidget>("pictureBrightness")->findChild<QSlider*>();
  slider->setFocus();
  for (int i = 0; i < 10; ++i) QTest::keyClick(slider, Qt::Key_Right);
  QTest::keyClick(part<QWidget>("pictureUpright"), Qt::Key_Space);
  tick(0);
  tick(1);
  press("pictureBegin");
  ASSERT_TRUE(done());
  ASSERT_EQ(editor.home().pictures.size(), 1u);
  const PictureSettings& made = editor.home().pictures.begin()->second->settings;
  EXPECT_EQ(made.tone, PictureTone::Film);
  EXPECT_EQ(made.aperture, 2.8);
  EXPECT_NEAR(made.brightness, 1, 0.01);
  EXPECT_TRUE(made.upright);
  EXPECT_FALSE(made.classic);
  // A mix of its lights is developed as the picture was.
  const auto film = window->queue().filmOf(editor.home().pictures.begin()->first);
  ASSERT_NE(film, nullptr);
  EXPECT_EQ(film->look.toneMap, render::ToneMap::AgX);
  EXPECT_NEAR(film->look.compensation, 1, 0.01);
  shoot(*window, "picture_form");
}

}  // namespace
}  // namespace idap
