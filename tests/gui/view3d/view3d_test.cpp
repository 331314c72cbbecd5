// The live view with real mouse and key events.
#include "editor/editor.h"

#include <gtest/gtest.h>

#include <QSlider>
#include <QTest>

#include "gui/support/gui_support.h"
#include "studio/view3d/live_panel.h"
#include "studio/view3d/view3d.h"
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
    return waitFor([this] { return view().upToDate() && view().samples() >= 1; });
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

}  // namespace
}  // namespace idap::test
