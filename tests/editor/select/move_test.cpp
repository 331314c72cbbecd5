#include <gtest/gtest.h>

#include "editor/snap.h"
#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct Moving : ToolDriver {
  // Clear inside: 0.1 .. 4.9 by 0.1 .. 3.9.
  Moving() { walls = test::addWalls(start, {{0, 0}, {5, 0}, {5, 4}, {0, 4}}); }
  FurnitureId put(Vec3 position, Vec3 size = {0.5, 0.5, 0.5}) {
    const auto id = start.newId<FurnitureId>();
    Furniture piece;
    piece.position = position;
    piece.size = size;
    start.furniture.set(id, piece);
    return id;
  }
  void open() { editor.open(std::make_unique<Document>(start)); }
  Vec3 at(FurnitureId id) const { return home().furniture.find(id)->position; }
  Home start;
  std::vector<WallId> walls;
};

TEST_F(Moving, OneStepOfUndo) {
  const FurnitureId a = put({2, 2, 0});
  open();
  drag({2, 2}, {3, 1.5});
  EXPECT_NEAR(at(a).x, 3, 0.01);
  EXPECT_EQ(undoSteps(), 1);
  EXPECT_EQ(document().undoName(), "Move");
  editor.undo();
  EXPECT_NEAR(at(a).x, 2, 1e-12);
}

TEST_F(Moving, EscapeTakesBack) {
  const FurnitureId a = put({2, 2, 0});
  open();
  press({2, 2});
  pointer(PointerEvent::Kind::Move, {3, 1.5});
  EXPECT_TRUE(key(Key::Escape));
  EXPECT_NEAR(at(a).x, 2, 1e-12);
  pointer(PointerEvent::Kind::Move, {3.5, 1.5});
  release({3.5, 1.5});
  EXPECT_NEAR(at(a).x, 2, 1e-12);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(Moving, SnapsFlushAndAltDoesNot) {
  const FurnitureId a = put({2.5, 2, 0});
  open();
  drag({2.5, 2}, {2.4, 3.6});
  EXPECT_NEAR(at(a).y, 3.65, 1e-9);
  modifiers.alt = true;
  drag({2.4, 3.65}, {2.4, 3.58});
  EXPECT_NEAR(at(a).y, 3.58, 1e-9);
}

TEST_F(Moving, AWardrobeTurnsItsBackToTheNextWall) {
  const FurnitureId a = put({2.5, 3.6, 0}, {1, 0.6, 2});  // its back at the upper wall
  const FurnitureId free = put({2, 1.5, 0}, {1, 0.6, 1});
  open();
  drag({2.5, 3.6}, {0.45, 2});
  EXPECT_NEAR(at(a).x, 0.4, 1e-9);
  EXPECT_NEAR(std::remainder(home().furniture.find(a)->angle - kPi / 2, 2 * kPi), 0, 1e-9);
  drag({2, 1.5}, {4.35, 1.5});
  EXPECT_NEAR(at(free).x, 4.4, 1e-9);
  EXPECT_EQ(home().furniture.find(free)->angle, 0);
}

TEST_F(Moving, ShiftKeepsToOneAxis) {
  const FurnitureId a = put({2, 2, 0});
  open();
  click({2, 2});
  press({2, 2});
  modifiers.shift = true;
  pointer(PointerEvent::Kind::Move, {3.3, 2.2});
  release({3.3, 2.2});
  EXPECT_NEAR(at(a).y, 2, 1e-12);
  EXPECT_GT(at(a).x, 3.1);
}

TEST_F(Moving, ControlCopies) {
  const FurnitureId a = put({2, 2, 0});
  open();
  click({2, 2});
  press({2, 2});
  modifiers.control = true;
  pointer(PointerEvent::Kind::Move, {3, 1.2});
  release({3, 1.2});
  EXPECT_EQ(home().furniture.size(), 2u);
  EXPECT_NEAR(at(a).x, 2, 1e-12);
  ASSERT_EQ(editor.selection().furniture.size(), 1u);
  EXPECT_NEAR(at(editor.selection().furniture[0]).x, 3, 0.03);
  EXPECT_EQ(document().undoName(), "Duplicate");
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(Moving, DistancesCanBeTyped) {
  const FurnitureId a = put({2, 2, 0});
  open();
  press({2, 2});
  pointer(PointerEvent::Kind::Move, {1.5, 1.3});
  ASSERT_EQ(overlay().measures.size(), 4u);
  ASSERT_EQ(overlay().fields.size(), 1u);
  EXPECT_NEAR(overlay().fields[0].value, 1.3 - 0.25 - 0.1, 0.05);  // the wall below is the nearest
  EXPECT_TRUE(type("30"));                                         // cm, the unit of the settings
  EXPECT_NEAR(at(a).y, 0.1 + 0.3 + 0.25, 1e-6);
  EXPECT_TRUE(key(Key::Tab));
  EXPECT_TRUE(type("1m"));
  EXPECT_TRUE(key(Key::Enter));
  EXPECT_FALSE(document().inTransaction());
  release({1.5, 1.3});
  const Vec3 p = at(a);
  const double sides[]{p.x - 0.35, 4.65 - p.x, p.y - 0.35, 3.65 - p.y};
  EXPECT_TRUE(
      std::any_of(std::begin(sides), std::end(sides), [](double d) { return std::abs(d - 1) < 1e-6; }));
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(Moving, HeightMovesFromTheSide) {
  const FurnitureId a = put({2, 2, 0});
  open();
  plane = Plane::XZ;
  drag({2, 0.25}, {2.6, 1.4});
  EXPECT_NEAR(at(a).z, 1.15, 0.01);
  EXPECT_NEAR(at(a).x, 2.6, 0.11);
  EXPECT_NEAR(at(a).y, 2, 1e-12);
  plane = Plane::YZ;
  drag({2, 1.4}, {1, 0.28});
  EXPECT_NEAR(at(a).z, 0, 1e-9);  // the floor holds it
  EXPECT_NEAR(at(a).y, 1, 0.11);
}

TEST_F(Moving, LockedPiecesStay) {
  const FurnitureId a = put({2, 2, 0}), b = put({3, 1, 0});
  Furniture locked = *start.furniture.find(a);
  locked.locked = true;
  start.furniture.set(a, locked);
  open();
  drag({2, 2}, {2.5, 2.5});
  EXPECT_NEAR(at(a).x, 2, 1e-12);
  EXPECT_EQ(said.size(), 1u);
  EXPECT_TRUE(overlay().handles.empty());
  modifiers.shift = true;
  click({3, 1});
  modifiers = {};
  drag({3, 1}, {3.5, 1.4});
  EXPECT_NEAR(at(a).x, 2, 1e-12);
  EXPECT_NEAR(at(b).x, 3.5, 0.05);
}

TEST_F(Moving, LampGoesOntoTheTableAndDownAgain) {
  put({3.5, 2, 0}, {1.4, 0.8, 0.74});
  const FurnitureId lamp = put({1, 1, 0}, {0.25, 0.25, 0.4});
  open();
  drag({1, 1}, {3.4, 2.1});
  EXPECT_NEAR(at(lamp).z, 0.74, 1e-9);
  drag({3.4, 2.1}, {1.3, 1.2});
  EXPECT_NEAR(at(lamp).z, 0, 1e-9);
}

TEST_F(Moving, AGroupMovesTogetherAndSnapsByItsBox) {
  Elements two;
  two.furniture = {put({1.5, 2, 0}), put({2.5, 2, 0})};
  const GroupEdit edit = groupElements(start, two, "pair");
  start = edit.home;
  open();
  drag({1.5, 2}, {1.5, 3.61});
  EXPECT_NEAR(at(two.furniture[0]).y, 3.65, 1e-9);
  EXPECT_NEAR(at(two.furniture[1]).y, 3.65, 1e-9);
}

TEST_F(Moving, DoorSlidesAndJumpsBetweenWalls) {
  open();
  const Opening door = makeOpening(*editor.catalog().find("idap/door-flush"), {});
  const auto in = snapOpening(editor, door, {2, 0.25}, 0.5);
  const auto id = start.newId<OpeningId>();
  start.openings.set(id, *in);
  open();
  const auto now = [&] { return *home().openings.find(id); };
  drag({2.2, 0.05}, {3.2, 0.02});
  EXPECT_NEAR(now().position.x, 3, 1e-9);
  EXPECT_NEAR(now().angle, in->angle, 1e-9);  // the pointer stayed in the wall: it opens as before
  drag({3, 0}, {3, -0.2});
  EXPECT_NEAR(std::abs(std::remainder(now().angle - in->angle, 2 * kPi)), kPi, 1e-9);
  drag({3, 0}, {4.95, 2});
  EXPECT_EQ(now().wall, walls[1]);
  EXPECT_NEAR(now().position.x, 5, 1e-6);
  EXPECT_EQ(undoSteps(), 3);
}

TEST_F(Moving, DoorFindsTheMiddleOfItsWall) {
  open();
  const auto in =
      snapOpening(editor, makeOpening(*editor.catalog().find("idap/door-flush"), {}), {1.5, 0.25}, 0.5);
  const auto id = start.newId<OpeningId>();
  start.openings.set(id, *in);
  open();
  press({1.5, 0});
  pointer(PointerEvent::Kind::Move, {2.56, 0.02});
  EXPECT_EQ(overlay().guides.size(), 1u);
  release({2.56, 0.02});
  EXPECT_NEAR(home().openings.find(id)->position.x, 2.5, 1e-9);
}

TEST_F(Moving, DoorDistanceFromTheCornerCanBeTyped) {
  open();
  const auto in =
      snapOpening(editor, makeOpening(*editor.catalog().find("idap/door-flush"), {}), {2, 0.25}, 0.5);
  const auto id = start.newId<OpeningId>();
  start.openings.set(id, *in);
  open();
  press({2, 0});
  pointer(PointerEvent::Kind::Move, {1.5, 0.02});
  EXPECT_EQ(overlay().measures.size(), 2u);
  type("20");
  key(Key::Enter);
  release({1.5, 0.02});
  EXPECT_NEAR(home().openings.find(id)->position.x, 0.1 + 0.2 + 0.45, 1e-9);
}

TEST_F(Moving, WallMovesParallelAndNeighboursFollow) {
  open();
  drag({2, 0}, {2.3, -1});
  const Wall& wall = *home().walls.find(walls[0]);
  expectNear(wall.start, {0, -1}, 0.05);
  EXPECT_NEAR(wall.start.x, 0, 1e-9);
  EXPECT_NEAR(wall.end.x, 5, 1e-9);
  EXPECT_NEAR(wall.start.y, wall.end.y, 1e-12);
  EXPECT_EQ(home().walls.find(walls[1])->start, wall.end);
  EXPECT_EQ(home().walls.find(walls[3])->end, wall.start);
}

TEST_F(Moving, SlantedNeighboursKeepTheirDirection) {
  start = {};
  walls = test::addWalls(start, {{-1, 2}, {0, 0}, {4, 0}, {4, 3}}, false);
  open();
  modifiers.alt = true;
  drag({2, 0}, {2, 1});
  expectNear(home().walls.find(walls[1])->start, {-0.5, 1}, 1e-9);
  expectNear(home().walls.find(walls[1])->end, {4, 1}, 1e-9);
}

TEST_F(Moving, RoomsFollowTheWall) {
  const RoomEdit edit = addRoomAt(start, {}, {2, 2});
  start = edit.home;
  open();
  modifiers.alt = true;
  drag({2, 0}, {2, -1});
  const Box2 box = bounds(home().rooms.find(edit.room)->points);
  EXPECT_NEAR(box.min.y, -0.9, 1e-6);
  EXPECT_NEAR(box.max.y, 3.9, 1e-6);
  EXPECT_EQ(undoSteps(), 1);
}

TEST_F(Moving, DimensionFollowsThePieceItMeasures) {
  const FurnitureId a = put({2, 2, 0});
  const auto id = start.newId<DimensionId>();
  start.dimensions.set(id, Dimension{.start = {0.1, 1.75}, .end = {1.75, 1.75}});
  open();
  drag({2, 2}, {3, 2});
  EXPECT_NEAR(home().dimensions.find(id)->end.x, at(a).x - 0.25, 1e-9);
  EXPECT_NEAR(home().dimensions.find(id)->start.x, 0.1, 1e-9);
}

TEST_F(Moving, EverythingElseMovesToo) {
  const auto label = start.newId<LabelId>();
  start.labels.set(label, Label{.text = "Here", .position = {2, 2}});
  const auto line = start.newId<PolylineId>();
  start.polylines.set(line, Polyline{.points = {{1, 1}, {2, 1}}});
  const auto camera = start.newId<CameraId>();
  Camera eye;
  eye.eye = {4, 1, 1.6};
  start.cameras.set(camera, eye);
  open();
  modifiers.alt = true;
  drag({2, 2.05}, {3, 3.05});
  expectNear(home().labels.find(label)->position, {3, 3});
  drag({1.5, 1}, {1.5, 1.5});
  expectNear(home().polylines.find(line)->points[0], {1, 1.5});
  drag({4, 1}, {4, 2});
  EXPECT_NEAR(home().cameras.find(camera)->eye.y, 2, 1e-9);
  plane = Plane::XZ;
  drag({4, 1.6}, {4, 1.2});
  EXPECT_NEAR(home().cameras.find(camera)->eye.z, 1.2, 1e-9);
}

}  // namespace
}  // namespace idap
