// The live view with real mouse and key events.
#include "editor/editor.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "gui/support/gui_support.h"
#include "model/edits/finish_edits.h"
#include "studio/view3d/live_panel.h"
#include "studio/view3d/view3d.h"
#include "studio/widgets/mime_types.h"
#include "support/wall_chain.h"

namespace idap::test {
namespace {

class View3dTest : public testing::Test {
 protected:
  void SetUp() override {
    Home home;
    addWalls(home, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    Room room;
    room.points = {{0.05, 0.05}, {3.95, 0.05}, {3.95, 3.95}, {0.05, 3.95}};
    home.rooms.set(home.newId<RoomId>(), room);
    chair_ = home.newId<FurnitureId>();
    home.furniture.set(chair_, makeFurniture(*editor_.catalog().find("idap/chair-windsor"), {2, 2.5, 0}));
    Camera camera;
    camera.name = "Door";
    camera.eye = {2, 0.4, 1.5};
    camera.pitch = 0.4;
    home.cameras.set(home.newId<CameraId>(), camera);
    editor_.open(std::make_unique<Document>(home));
    panel_ = std::make_unique<LivePanel>(editor_);
    view().setSamples(1);
    panel_->resize(400, 320);
    panel_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(panel_.get()));
    ASSERT_TRUE(settle());
  }
  View3d& view() { return panel_->view(); }
  bool settle() {
    return waitFor([this] { return view().upToDate() && view().samples() >= 1; }, 60'000);
  }
  Vec3 chair() { return editor_.home().furniture.find(chair_)->position; }
  // A pixel where the chair is seen.
  QPoint onChair() {
    for (int y = 0; y < view().height(); y += 3)
      for (int x = 0; x < view().width(); x += 3)
        if (const auto id = view().at({x, y}); id && *id == AnyId(chair_)) return {x, y};
    ADD_FAILURE() << "the chair is not seen";
    return {};
  }

  // A pixel where that part of an element of that kind is seen; of the view's middle rows first.
  template <class Id>
  QPoint onPart(const std::string& part) {
    for (int y = view().height() - 4; y > 0; y -= 3)
      for (int x = view().width() / 2; x < view().width(); x += 3)
        if (const auto seen = view().partAt({x, y});
            seen && std::holds_alternative<Id>(seen->first) && (part.empty() || seen->second == part))
          return {x, y};
    ADD_FAILURE() << "not seen: " << part;
    return {};
  }
  // What a drag from the catalog brings to the view.
  void dragOnto(const char* mime, const char* id, QPoint to, bool letGo,
                Qt::KeyboardModifiers modifiers = {}) {
    QMimeData data;
    data.setData(mime, id);
    QDragEnterEvent enter(to, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(&view(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDragMoveEvent move(to, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(&view(), &move);
    if (letGo) {
      QDropEvent drop(to, Qt::CopyAction, &data, Qt::LeftButton, modifiers);
      QCoreApplication::sendEvent(&view(), &drop);
    } else {
      QDragLeaveEvent leave;
      QCoreApplication::sendEvent(&view(), &leave);
    }
  }
  const Room& room() { return *editor_.home().rooms.begin()->second; }

  Editor editor_{std::make_shared<const Catalog>(std::vector<std::filesystem::path>())};
  FurnitureId chair_;
  std::unique_ptr<LivePanel> panel_;
};

TEST_F(View3dTest, AClickSelectsWhatIsSeenThere) {
  QTest::mouseClick(&view(), Qt::LeftButton, {}, onChair());
  EXPECT_TRUE(contains(editor_.selection(), chair_));
}

TEST_F(View3dTest, ADragMovesWhatIsSelectedOverTheFloorInOneUndoStep) {
  const QPoint from = onChair();
  QTest::mouseClick(&view(), Qt::LeftButton, {}, from);
  const Vec3 before = chair();
  QTest::mousePress(&view(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) QTest::mouseMove(&view(), from + QPoint(8 * i, 0));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, from + QPoint(64, 0));
  EXPECT_GT(chair().x, before.x + 0.1);
  EXPECT_NEAR(chair().z, before.z, 1e-9);
  editor_.undo();
  EXPECT_EQ(chair(), before);
}

TEST_F(View3dTest, ADragElsewhereLooksAroundAndMovesNothing) {
  const Vec3 before = chair();
  const double yaw = view().camera().yaw;
  QTest::mousePress(&view(), Qt::LeftButton, {}, {20, 20});
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(&view(), QPoint(20 + 10 * i, 20));
  QTest::mouseRelease(&view(), Qt::LeftButton, {}, {70, 20});
  EXPECT_NE(view().camera().yaw, yaw);
  EXPECT_EQ(chair(), before);
}

TEST_F(View3dTest, WWalksAheadAndWallsStopIt) {
  view().setFocus();
  view().setStopsAtWalls(true);
  const Vec3 before = view().camera().eye;
  QTest::keyPress(&view(), Qt::Key_W);
  waitFor([&] { return view().camera().eye.y > before.y + 0.1; });
  QTest::keyRelease(&view(), Qt::Key_W);
  EXPECT_GT(view().camera().eye.y, before.y + 0.1);
  EXPECT_NEAR(view().camera().eye.z, before.z, 1e-9);
}

TEST_F(View3dTest, AHomeWhoseObserverFacesAWallOpensFromAbove) {
  EXPECT_EQ(view().manner(), View3d::Manner::Walk);
  Home home = editor_.home();
  home.cameras = {};
  Camera observer;
  observer.eye = {2, 3.5, 1.6};  // half a metre from the wall, and looking at it
  home.observer = observer;
  editor_.open(std::make_unique<Document>(home));
  ASSERT_TRUE(settle());
  EXPECT_EQ(view().manner(), View3d::Manner::Orbit);
  EXPECT_GT(view().camera().eye.z, 2.5);
}

TEST_F(View3dTest, AnEditShows) {
  const QPoint at = onChair();
  editor_.apply("delete", [this](const Home& home) {
    Home next = home;
    next.furniture.erase(chair_);
    return next;
  });
  ASSERT_TRUE(settle());
  EXPECT_NE(view().at(at), std::optional<AnyId>(chair_));
}

TEST_F(View3dTest, AChairFromTheCatalogStandsWhereItIsDropped) {
  const QPoint at = onPart<RoomId>(kPartFloor);
  const Vec3 point = *view().pointAt(at);
  dragOnto(kPieceMime, "idap/chair-windsor", at, true);
  ASSERT_EQ(editor_.home().furniture.size(), 2u);
  std::shared_ptr<const Furniture> dropped;
  for (const auto& [id, piece] : editor_.home().furniture)
    if (id != chair_) dropped = piece;
  EXPECT_NEAR(dropped->position.z, 0, 1e-6);
  EXPECT_LT(length(Vec2{dropped->position.x - point.x, dropped->position.y - point.y}), 0.8);
}

TEST_F(View3dTest, AFinishDroppedOntoTheFloorStaysThereInOneUndoStep) {
  dragOnto(kMaterialMime, "oak", onPart<RoomId>(kPartFloor), true);
  EXPECT_EQ(room().floor.material, "oak");
  EXPECT_TRUE(room().ceiling.empty());
  editor_.undo();
  EXPECT_TRUE(room().floor.empty());
}

TEST_F(View3dTest, AFinishCarriedAwayAgainLeavesNothing) {
  dragOnto(kMaterialMime, "oak", onPart<RoomId>(kPartFloor), false);
  EXPECT_TRUE(room().floor.empty());
  EXPECT_FALSE(editor_.document().canUndo());
}

TEST_F(View3dTest, AFinishDroppedOntoAWallIsForTheSideThatIsSeen) {
  const QPoint at = onPart<WallId>({});
  const auto seen = view().partAt(at);
  dragOnto(kMaterialMime, "brick", at, true);
  const Wall& wall = *editor_.home().walls.find(std::get<WallId>(seen->first));
  // The walls go round counter-clockwise: the room is to their left.
  EXPECT_EQ(wall.left.finish.material, "brick");
  EXPECT_TRUE(wall.right.finish.empty());
}

TEST_F(View3dTest, AFinishDroppedOntoAPieceIsForTheTouchedPartAndWithShiftForAllOfIt) {
  const QPoint at = onChair();
  const std::string part = view().partAt(at)->second;
  ASSERT_FALSE(part.empty());
  dragOnto(kMaterialMime, "walnut", at, true);
  const auto chair = [this] { return *editor_.home().furniture.find(chair_); };
  ASSERT_EQ(chair().slotFinishes.count(part), 1u);
  EXPECT_EQ(chair().slotFinishes.at(part).material, "walnut");
  dragOnto(kMaterialMime, "oak", at, true, Qt::ShiftModifier);
  EXPECT_TRUE(chair().slotFinishes.empty());
  EXPECT_EQ(chair().finish.material, "oak");
}

TEST_F(View3dTest, FromOutsideTheWallsInTheWayAreCutAwayUnlessNeverIsChosen) {
  Camera outside;
  outside.eye = {2, -5, 1.5};
  view().setCamera(outside);
  ASSERT_TRUE(settle());
  const QPoint middle = view().rect().center();
  const auto through = view().at(middle);
  EXPECT_FALSE(through && std::holds_alternative<WallId>(*through) && view().pointAt(middle)->y < 1)
      << "the front wall hides the room";
  view().setCutAway(CutAway::Never);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(view().pointAt(middle));
  EXPECT_LT(view().pointAt(middle)->y, 0.2);
}

TEST_F(View3dTest, TheHourChangesTheHomeAndCanBeUndone) {
  const std::int64_t before = editor_.home().site.time;
  auto* hour = panel_->findChild<QSlider*>("hour");
  ASSERT_TRUE(hour);
  hour->setFocus();
  QTest::keyClick(hour, Qt::Key_PageUp);
  EXPECT_EQ(editor_.home().site.time, before + 3'600'000);
  editor_.undo();
  EXPECT_EQ(editor_.home().site.time, before);
}

// The popup of the lamp button, with a lamp in the room.
class LightPopupTest : public View3dTest {
 protected:
  void SetUp() override {
    View3dTest::SetUp();
    Furniture lamp = makeFurniture(*editor_.catalog().find("idap/light-floor"), {1, 3, 0});
    editor_.apply("lamp", [&](const Home& home) {
      Home next = home;
      lamp_ = next.newId<FurnitureId>();
      next.furniture.set(lamp_, lamp);
      return next;
    });
    ASSERT_TRUE(this->lamp().has_value());
    QTest::mouseClick(panel_->findChild<QToolButton*>("light"), Qt::LeftButton);
    popup_ = panel_->findChild<QWidget*>("lightPopup");
    ASSERT_TRUE(popup_);
  }
  std::optional<Lamp> lamp() { return editor_.home().furniture.find(lamp_)->lamp; }
  template <class W>
  W* part(const std::string& name) {
    W* found = popup_->findChild<W*>(QString::fromStdString(name));
    EXPECT_TRUE(found) << name;
    return found;
  }
  FurnitureId lamp_;
  QWidget* popup_ = nullptr;
};

TEST_F(LightPopupTest, ASwitchPutsALampOutAndItsDimmerRests) {
  ASSERT_TRUE(lamp()->on);
  auto* on = part<QCheckBox>("lamp" + std::to_string(lamp_.value));
  QTest::mouseClick(on, Qt::LeftButton, {}, QPoint(8, on->height() / 2));
  EXPECT_FALSE(lamp()->on);
  EXPECT_FALSE(part<QSlider>("dimmer" + std::to_string(lamp_.value))->isEnabled());
  editor_.undo();
  EXPECT_TRUE(lamp()->on);
}

TEST_F(LightPopupTest, ADimmerIsMovedByTheKeys) {
  auto* dimmer = part<QSlider>("dimmer" + std::to_string(lamp_.value));
  dimmer->setFocus();
  const double before = lamp()->dimmer;
  for (int i = 0; i < 5; ++i) QTest::keyClick(dimmer, Qt::Key_Left);
  EXPECT_NEAR(lamp()->dimmer, before - 0.05, 1e-6);
}

TEST_F(LightPopupTest, AllLampsGoOutAtOnce) {
  QTest::mouseClick(part<QPushButton>("allOff"), Qt::LeftButton);
  EXPECT_FALSE(lamp()->on);
  QTest::mouseClick(part<QPushButton>("allOn"), Qt::LeftButton);
  EXPECT_TRUE(lamp()->on);
}

TEST_F(LightPopupTest, TheWeatherIsTheHomes) {
  auto* weather = part<QComboBox>("weather");
  weather->setFocus();
  QTest::keyClick(weather, Qt::Key_End);
  EXPECT_DOUBLE_EQ(editor_.home().environment.cloudiness, 1);
}

}  // namespace
}  // namespace idap::test
