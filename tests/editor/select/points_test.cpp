#include <gtest/gtest.h>

#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "model/wall_path.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct Points : ToolDriver {
  void open(AnyId id) {
    editor.open(std::make_unique<Document>(start));
    editor.select(only(id));
  }
  Home start;
};

TEST_F(Points, CornerTakesAllItsWallsAlong) {
  const auto walls = test::addWalls(start, {{0, 0}, {5, 0}, {5, 4}, {0, 4}});
  const RoomEdit room = addRoomAt(start, {}, {2, 2});
  start = room.home;
  open(walls[1]);
  modifiers.alt = true;
  drag({5, 4}, {6, 5});
  expectNear(home().walls.find(walls[1])->end, {6, 5}, 0.11);
  EXPECT_EQ(home().walls.find(walls[1])->end, home().walls.find(walls[2])->start);
  EXPECT_GT(bounds(home().rooms.find(room.room)->points).max.x, 5.5);
  EXPECT_EQ(document().undoName(), "Move corner");
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home().walls.find(walls[2])->start, (Vec2{5, 4}));
}

TEST_F(Points, WallsLengthAndAngleCanBeTyped) {
  const auto walls = test::addWalls(start, {{0, 0}, {4, 0}}, false);
  open(walls[0]);
  press({4, 0});
  pointer(PointerEvent::Kind::Move, {4.5, 0.1});
  EXPECT_EQ(overlay().fields.size(), 2u);
  type("325");
  key(Key::Tab);
  type("90");
  key(Key::Enter);
  release({4.5, 0.1});
  expectNear(home().walls.find(walls[0])->end, {0, 3.25});
}

TEST_F(Points, WallBendsAndStraightens) {
  const auto walls = test::addWalls(start, {{0, 0}, {4, 0}}, false);
  open(walls[0]);
  modifiers.alt = true;
  drag({2, 0}, {2.2, 1});
  const WallPath path(*home().walls.find(walls[0]));
  expectNear(path.point(path.length() / 2), {2, 1}, 1e-6);
  modifiers = {};
  press({2, 1});
  pointer(PointerEvent::Kind::Move, {2, 1.1});
  type("-180");
  key(Key::Enter);
  release({2, 1.1});
  EXPECT_NEAR(home().walls.find(walls[0])->arcExtent, -kPi, 1e-6);
  const WallPath half(*home().walls.find(walls[0]));
  const Vec2 top = half.point(half.length() / 2);
  drag(top, {2, 0.05});
  EXPECT_EQ(home().walls.find(walls[0])->arcExtent, 0);
}

TEST_F(Points, WallHeightsFromTheSide) {
  const auto walls = test::addWalls(start, {{0, 0}, {4, 0}}, false);
  open(walls[0]);
  plane = Plane::XZ;
  drag({4, 2.5}, {4, 3.2});
  EXPECT_NEAR(home().walls.find(walls[0])->heightAtEnd, 3.2, 1e-9);
  EXPECT_NEAR(home().walls.find(walls[0])->heightAtStart, 2.5, 1e-9);
  plane = Plane::YZ;  // seen end on
  drag({0, (3.2 + 2.5) / 2}, {0, 2});
  drag({0, 2.5}, {0, 2});
}

TEST_F(Points, RoomsPointsMoveComeAndGo) {
  Room room;
  room.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const RoomEdit edit = addRoom(start, room);
  start = edit.home;
  open(edit.room);
  const auto now = [&]() -> const Polygon& { return home().rooms.find(edit.room)->points; };
  drag({4, 3}, {5, 3.02});
  expectNear(now()[2], {5, 3});  // straight on
  doubleClick({2, 0.02});
  ASSERT_EQ(now().size(), 5u);
  expectNear(now()[1], {2, 0.02});
  move({2, 0.02});
  EXPECT_TRUE(key(Key::Delete));
  EXPECT_EQ(now().size(), 4u);
  EXPECT_EQ(document().undoName(), "Remove point");
  EXPECT_EQ(undoSteps(), 3);
  EXPECT_TRUE(home().rooms.contains(edit.room));
}

TEST_F(Points, PolylinesPoints) {
  const auto line = start.newId<PolylineId>();
  start.polylines.set(line, Polyline{.points = {{0, 0}, {2, 0}}});
  open(line);
  drag({2, 0}, {3, 0});
  doubleClick({1, 0});
  ASSERT_EQ(home().polylines.find(line)->points.size(), 3u);
  expectNear(home().polylines.find(line)->points[2], {3, 0});
  move({1, 0});
  key(Key::Delete);
  EXPECT_EQ(home().polylines.find(line)->points.size(), 2u);
  move({0, 0});
  key(Key::Delete);  // two points are the least: the whole line goes
  EXPECT_TRUE(home().polylines.empty());
}

TEST_F(Points, DimensionsEndsAndOffset) {
  test::addWalls(start, {{3, 0}, {3, 4}}, false);
  const auto id = start.newId<DimensionId>();
  start.dimensions.set(id, Dimension{.start = {0, 1}, .end = {2, 1}, .offset = 0.3});
  open(id);
  drag({2, 1}, {2.87, 1.02});
  expectNear(home().dimensions.find(id)->end, {2.9, 1}, 0.021);
  const Vec2 middle{1.45, 1.3};
  drag(middle, {1.45, 1.8});
  EXPECT_NEAR(home().dimensions.find(id)->offset, 0.8, 0.02);
}

TEST_F(Points, CamerasAimAndLens) {
  const auto id = start.newId<CameraId>();
  Camera camera;
  camera.eye = {0, 0, 1.6};
  camera.fieldOfView = kPi / 3;
  start.cameras.set(id, camera);
  open(id);
  drag({0, 0.9}, {-1.2, 0.02});
  EXPECT_NEAR(home().cameras.find(id)->yaw, kPi / 2, 1e-9);  // to the left
  const Vec2 side = rotated(Vec2{-0.9, 0}, kPi / 6);
  drag(side, rotated(Vec2{-1.5, 0}, kPi / 4));
  EXPECT_NEAR(home().cameras.find(id)->fieldOfView, kPi / 2, 1e-9);
  plane = Plane::XZ;
  modifiers.alt = true;
  drag({-0.9, 1.6}, {-0.9, 0.7});
  EXPECT_NEAR(home().cameras.find(id)->pitch, kPi / 4, 1e-6);
  EXPECT_NEAR(home().cameras.find(id)->yaw, kPi / 2, 1e-6);
}

TEST_F(Points, LabelsTurn) {
  const auto id = start.newId<LabelId>();
  start.labels.set(id, Label{.text = "Here", .position = {1, 1}});
  open(id);
  const Vec2 from = overlay().handles.at(0).at;
  drag(from, Vec2{1, 1} + rotated(from - Vec2{1, 1}, 0.8));
  EXPECT_NEAR(home().labels.find(id)->angle, kPi / 4, 1e-9);
}

}  // namespace
}  // namespace idap
