// What is marked on a plane beside the building itself: dimensions from the side, names of cameras, ceilings.
#include <gtest/gtest.h>

#include <QMouseEvent>

#include "gui/support/gui_support.h"
#include "model/edits/level_edits.h"
#include "studio/plan/elevation.h"
#include "studio/plan/plan_view.h"
#include "support/sample_home.h"

namespace idap {
namespace {

class PlanMarks : public testing::TestWithParam<Plane> {
 protected:
  PlanMarks() {
    EditorSettings settings = editor.settings();
    settings.gridShown = false;
    settings.rulersShown = false;
    editor.setSettings(settings);
    editor.open(std::make_unique<Document>(test::smallFlat()));
    view.resize(800, 500);
    view.show();
    view.zoomToFit();
    view.zoomBy(0.8);  // from here on it does not follow what is drawn
  }
  QImage picture() {
    EXPECT_TRUE(test::waitFor([&] {
      view.repaint();
      return view.settled();
    }));
    return view.grab().toImage();
  }
  void change(const std::function<void(Home&)>& how) {
    editor.apply("Change", [&](const Home& home) {
      Home next = home;
      how(next);
      return next;
    });
  }
  CameraId addCamera(const std::string& name, Vec3 eye) {
    CameraId id;
    change([&](Home& home) {
      id = home.newId<CameraId>();
      home.cameras.set(id, Camera{.name = name, .eye = eye});
    });
    return id;
  }
  // Pixels that differ at all.
  static int differing(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return count;
  }
  // Pixels that differ within a rectangle around a point of the plane.
  int differing(const QImage& a, const QImage& b, Vec2 centre, QSizeF metres) const {
    const QPointF middle = view.toView(centre);
    const QSizeF size = metres / view.pixel();
    const QRect area = QRectF(middle - QPointF(size.width(), size.height()) / 2, size).toRect() & a.rect();
    int count = 0;
    for (int y = area.top(); y <= area.bottom(); ++y)
      for (int x = area.left(); x <= area.right(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    return count;
  }

  Editor editor{std::make_shared<Catalog>(std::vector<std::filesystem::path>{})};
  PlanView view{editor, GetParam()};
};

class SideMarks : public PlanMarks {};

TEST_P(SideMarks, AHeightIsDrawnWhereItIsHit) {
  const QImage before = picture();
  DimensionId id;
  // Upright, half a metre to the left of what it measures.
  change([&](Home& home) {
    id = home.newId<DimensionId>();
    home.dimensions.set(id, Dimension{.start = {1, 1}, .end = {1, 1}, .endElevation = 2.1, .offset = 0.5});
  });
  const QImage after = picture();
  EXPECT_GT(differing(before, after, {0.5, 0.5}, {0.06, 0.3}), 0.25 / view.pixel()) << "the line";
  EXPECT_GT(differing(before, after, {0.75, 2.1}, {0.3, 0.06}), 0.25 / view.pixel()) << "what it measures";
  EXPECT_GT(differing(before, after, {0.5 - 0.13, 1.05}, {0.2, 0.8}), 30) << "the text";

  EditorSettings settings = editor.settings();
  settings.unit = LengthUnit::FeetInches;
  editor.setSettings(settings);
  const QImage feet = picture();
  EXPECT_GT(differing(after, feet, {0.5 - 0.13, 1.05}, {0.2, 0.8}), 10) << "the user's unit";
  settings.unit = LengthUnit::Centimetre;
  editor.setSettings(settings);
  EXPECT_EQ(differing(picture(), after), 0) << "what was patched in is what is painted anew";

  const QImage plain = picture();
  test::shoot(view, "dimension-side");
  Elements chosen;
  chosen.dimensions = {id};
  editor.select(chosen);
  EXPECT_GT(differing(plain, picture(), {0.5, 1.8}, {0.1, 0.2}), 5) << "and it is marked when selected";
  editor.select({});
  editor.undo();
  EXPECT_EQ(differing(picture(), before), 0);
}

TEST_P(SideMarks, WhatIsMeasuredOnTheFloorIsLeftToThePlan) {
  const QImage before = picture();
  change([](Home& home) {
    home.dimensions.set(home.newId<DimensionId>(), Dimension{.start = {0, 0}, .end = {6, 4}, .offset = 0.4});
  });
  EXPECT_EQ(differing(picture(), before), 0);
}

TEST_P(SideMarks, AHomeWithoutLevelsIsAsHighAsItsWallsUsuallyAre) {
  change([](Home& home) {
    home.wallHeight = 2.5;
    bool first = true;
    for (const auto& [id, wall] : Home(home).walls) {
      Wall other = *wall;
      other.heightAtStart = other.heightAtEnd = first ? 3.4 : 2.7;
      first = false;
      home.walls.set(id, other);
    }
  });
  EXPECT_DOUBLE_EQ(ceilingHeight(editor.home(), {}), 2.7);
  EXPECT_NEAR(view.drawnBox().max.y, 3.4, 1e-6);
  const QImage before = picture();
  change([](Home& home) { home.wallHeight = 3; });
  EXPECT_EQ(differing(picture(), before), 0) << "the height of new walls is not that of the ceiling";
}

TEST_P(SideMarks, TheFitShowsTheCeilingOfALevel) {
  Home home = test::smallFlat();
  const auto level = home.newId<LevelId>();
  home.levels.set(level, Level{.name = "Ground", .height = 3.1});
  for (const auto& [id, wall] : Home(home).walls) {
    Wall other = *wall;
    other.level = level;
    home.walls.set(id, other);
  }
  for (const auto& [id, opening] : Home(home).openings) home.openings.erase(id);
  for (const auto& [id, piece] : Home(home).furniture) home.furniture.erase(id);
  editor.open(std::make_unique<Document>(std::move(home)));
  editor.setLevel(level);
  EXPECT_DOUBLE_EQ(ceilingHeight(editor.home(), level), 3.1);
  EXPECT_NEAR(view.drawnBox().max.y, 3.1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Planes, SideMarks, testing::Values(Plane::XZ, Plane::YZ));

class CameraNames : public PlanMarks {};

TEST_P(CameraNames, AreShownOfCamerasThatAreSelectedOrUnderThePointerOnly) {
  const Vec3 eye{4.5, 2, 1.6};
  const CameraId named = addCamera("From the door to the window", eye);
  const QImage withName = picture();
  const auto rename = [&](const char* name) {
    change([&](Home& home) {
      Camera camera = *home.cameras.find(named);
      camera.name = name;
      home.cameras.set(named, camera);
    });
  };
  rename("");
  EXPECT_EQ(differing(picture(), withName), 0);
  const auto hover = [&](QPointF at) {
    QMouseEvent move(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&view, &move);
  };
  hover(view.toView(project(view.plane(), eye)));
  const QImage hovered = picture();
  rename("From the door to the window");
  const Vec2 below = project(view.plane(), eye) - Vec2{0, 20 * view.pixel()};
  const QSizeF room(120 * view.pixel(), 14 * view.pixel());
  EXPECT_GT(differing(hovered, picture(), below, room), 60);
  hover({2, 2});
  EXPECT_EQ(differing(picture(), withName), 0);

  Elements chosen;
  chosen.cameras = {named};
  editor.select(chosen);
  const QImage selected = picture();
  rename("");
  EXPECT_GT(differing(selected, picture(), below, room), 60);
}

TEST_P(CameraNames, DoNotCoverEachOther) {
  const Vec3 eye{4.5, 2, 1.6};
  Elements chosen;
  chosen.cameras = {addCamera("From the door", eye)};
  chosen.cameras.push_back(addCamera("", eye));
  editor.select(chosen);
  const QImage one = picture();
  change([&](Home& home) {
    home.cameras.set(chosen.cameras.back(), Camera{.name = "From the door", .eye = eye});
  });
  const QImage two = picture();
  test::shoot(view, "camera-names");
  const Vec2 at = project(view.plane(), eye), away{0, 20 * view.pixel()};
  const QSizeF room(60 * view.pixel(), 10 * view.pixel());
  EXPECT_EQ(differing(one, two, at - away, room), 0) << "the first stays as it was";
  EXPECT_GT(differing(one, two, at + away, room), 60) << "the second stands above";
}

INSTANTIATE_TEST_SUITE_P(Planes, CameraNames, testing::Values(Plane::XY, Plane::XZ, Plane::YZ));

}  // namespace
}  // namespace idap
