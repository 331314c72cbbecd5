#include "model/edits/wall_edits.h"
#include "model/room_geometry.h"
#include "model/wall_path.h"
#include "tool_driver.h"

namespace idap {
namespace {

class WallTool : public ToolDriver {
 protected:
  WallTool() { editor.takeTool("wall"); }
};

TEST_F(WallTool, DrawsWhatIsClicked) {
  const Home empty = home();
  click({0, 0});
  move({3.02, 0.01});
  ASSERT_EQ(home().walls.size(), 1u) << "shown while it is drawn";
  EXPECT_TRUE(document().inTransaction());
  click({3.02, 0.01});
  rightClick({5, 5});
  ASSERT_EQ(home().walls.size(), 1u);
  const Wall& wall = newest(home().walls);
  expectNear(wall.start, {0, 0});
  EXPECT_NEAR(wall.end.y, 0, 1e-6) << "straight by snapping";
  EXPECT_EQ(wall.thickness, editor.settings().wallThickness);
  EXPECT_EQ(wall.heightAtStart, home().wallHeight);
  EXPECT_FALSE(document().inTransaction());
  editor.undo();
  EXPECT_EQ(home(), empty);
}

TEST_F(WallTool, TakesTypedLengthsAnglesAndThickness) {
  click({0, 0});
  move({1, 0.02});
  EXPECT_TRUE(type("325cm"));
  EXPECT_TRUE(key(Key::Enter));
  expectNear(home().walls.begin()->second->end, {3.25, 0});
  type("2m");
  key(Key::Tab);
  type("90");
  key(Key::Tab);
  type("24cm");
  key(Key::Enter);
  EXPECT_TRUE(key(Key::Enter));  // nothing typed: the chain ends
  ASSERT_EQ(home().walls.size(), 2u);
  const Wall& second = newest(home().walls);
  expectNear(second.start, {3.25, 0});
  expectNear(second.end, {3.25, 2});
  EXPECT_NEAR(second.thickness, 0.24, 1e-12);
  EXPECT_TRUE(second.neighbourAtStart) << "joined to the first";
  EXPECT_FALSE(document().inTransaction());
  EXPECT_EQ(undoSteps(), 2);
}

TEST_F(WallTool, DrawsAWholeRoomFromTheKeyboard) {
  click({0, 0});
  move({1, 0});
  // The pointer stays where it is: angles are typed.
  for (const char* angle : {"0", "90", "180", "270"}) {
    type("4m");
    key(Key::Tab);
    type(angle);
    key(Key::Enter);
  }
  EXPECT_FALSE(document().inTransaction());
  ASSERT_EQ(home().walls.size(), 4u);
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 3.9 * 3.9, 1e-3);
}

TEST_F(WallTool, ALengthWithoutADirectionGoesOnStraight) {
  click({0, 0});
  click({0, 2});
  type("1m");
  key(Key::Enter);
  key(Key::Enter);
  expectNear(newest(home().walls).end, {0, 3});
}

TEST_F(WallTool, ReadsTheUsersUnit) {
  EditorSettings settings;
  settings.unit = LengthUnit::FeetInches;
  editor.setSettings(settings);
  click({0, 0});
  move({1, 0});
  type("10'8\"");
  key(Key::Enter);
  rightClick({1, 0});
  EXPECT_NEAR(newest(home().walls).end.x, 3.2512, 1e-9);
}

TEST_F(WallTool, ThicknessAloneIsKeptForTheChain) {
  click({0, 0});
  move({2, 0});
  key(Key::Tab);
  key(Key::Tab);
  type("30cm");
  key(Key::Enter);
  EXPECT_TRUE(document().inTransaction()) << "still drawing";
  click({2, 0});
  click({2, 3});
  rightClick({4, 4});
  for (const auto& [id, wall] : home().walls) EXPECT_NEAR(wall->thickness, 0.3, 1e-12);
}

TEST_F(WallTool, ClosingEndsTheChainAndMakesARoom) {
  click({0, 0});
  click({4, 0});
  click({4, 3});
  click({0, 3});
  click({0.03, 0.04});
  ASSERT_EQ(home().walls.size(), 4u);
  for (const auto& [id, wall] : home().walls) {
    EXPECT_TRUE(wall->neighbourAtStart);
    EXPECT_TRUE(wall->neighbourAtEnd);
  }
  EXPECT_FALSE(document().inTransaction());
  ASSERT_EQ(home().rooms.size(), 1u);
  EXPECT_NEAR(floorArea(newest(home().rooms)), 3.9 * 2.9, 1e-3);
  EXPECT_EQ(undoSteps(), 4) << "one for each wall, the room with the last";
  move({2, 2});
  EXPECT_EQ(home().walls.size(), 4u) << "nothing is drawn any more";
}

TEST_F(WallTool, NoRoomsWhereTheUserWantsNone) {
  EditorSettings settings;
  settings.roomAreas = false;
  editor.setSettings(settings);
  for (const Vec2 p : {Vec2{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}) click(p);
  EXPECT_EQ(home().walls.size(), 4u);
  EXPECT_TRUE(home().rooms.empty());
}

TEST_F(WallTool, EndsOnTheMiddleOfAnotherWall) {
  openRoom(4, 3);
  editor.takeTool("wall");
  click({2, 2.96});
  click({2, 0.02});
  EXPECT_FALSE(document().inTransaction()) << "it has come to a wall";
  ASSERT_EQ(home().walls.size(), 5u);
  const Wall& wall = newest(home().walls);
  EXPECT_NEAR(wall.start.y, 3.05, 1e-6);
  EXPECT_NEAR(wall.end.y, -0.05, 1e-6);
  EXPECT_EQ(closedAreas(home(), {}).size(), 2u);
}

TEST_F(WallTool, AWallThroughARoomMakesTwo) {
  for (const Vec2 p : {Vec2{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}}) click(p);
  ASSERT_EQ(home().rooms.size(), 1u);
  const Home before = home();
  click({2, 3});
  click({2, 0});
  ASSERT_EQ(home().walls.size(), 5u);
  ASSERT_EQ(home().rooms.size(), 2u);
  for (const auto& [id, room] : home().rooms) EXPECT_NEAR(floorArea(*room), 1.9 * 2.9, 1e-3);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(WallTool, LengthsDrawnFreelyAreRound) {
  click({0, 0});
  click({2.5137, 0.02});
  rightClick({5, 5});
  EXPECT_NEAR(newest(home().walls).end.x, 2.51, 1e-9);
}

TEST_F(WallTool, BackspaceTakesTheLastWallBack) {
  click({0, 0});
  click({4, 0});
  click({4, 3});
  move({2, 3});
  EXPECT_TRUE(key(Key::Backspace));
  EXPECT_EQ(home().walls.size(), 2u) << "the first, and the second on its way again";
  move({4, 1});
  click({4, 2});
  ASSERT_EQ(home().walls.size(), 2u);
  expectNear(newest(home().walls).start, {4, 0});
  EXPECT_NEAR(newest(home().walls).end.y, 2, 1e-6);
  key(Key::Backspace);
  key(Key::Backspace);
  key(Key::Backspace);
  EXPECT_TRUE(home().walls.empty());
  EXPECT_FALSE(document().inTransaction());
  EXPECT_FALSE(document().canUndo());
}

TEST_F(WallTool, EscapeEndsTheChainThenTheTool) {
  const Home empty = home();
  click({0, 0});
  move({2, 0});
  EXPECT_TRUE(key(Key::Escape));
  EXPECT_EQ(home(), empty);
  EXPECT_FALSE(editor.selecting());
  key(Key::Escape);
  EXPECT_TRUE(editor.selecting());
}

TEST_F(WallTool, DoubleClickEndsTheChain) {
  click({0, 0});
  doubleClick({3, 0});
  EXPECT_EQ(home().walls.size(), 1u);
  EXPECT_FALSE(document().inTransaction());
}

TEST_F(WallTool, DrawsWithTheButtonHeld) {
  drag({0, 0}, {3, 0});
  ASSERT_EQ(home().walls.size(), 1u);
  move({3, 1});
  EXPECT_EQ(home().walls.size(), 2u) << "and the next one is begun";
  rightClick({4, 4});
  ASSERT_EQ(home().walls.size(), 1u);
  expectNear(newest(home().walls).end, {3, 0}, 1e-3);
}

TEST_F(WallTool, ShiftBendsTheWall) {
  click({0, 0});
  move({4, 0});
  modifiers.shift = true;
  press({4, 0});
  release({4, 0});
  modifiers.shift = false;
  move({2, -2});
  click({2, -2});
  rightClick({5, 5});
  ASSERT_EQ(home().walls.size(), 1u);
  const Wall& wall = newest(home().walls);
  expectNear(wall.end, {4, 0});
  EXPECT_NEAR(wall.arcExtent, kPi, 1e-3) << "half a circle, to the right of its chord and so turning left";
  const WallPath path(wall);
  expectNear(path.point(path.length() / 2), {2, -2}, 1e-2);
}

TEST_F(WallTool, ArcCanBeTyped) {
  click({0, 0});
  move({4, 0});
  type("3m");
  key(Key::BackTab);
  type("-90");
  key(Key::Enter);
  rightClick({5, 5});
  const Wall& wall = newest(home().walls);
  expectNear(wall.end, {3, 0});
  EXPECT_NEAR(wall.arcExtent, -kPi / 2, 1e-9);
}

TEST_F(WallTool, IsOnlyForThePlan) {
  plane = Plane::XZ;
  click({0, 0});
  click({3, 1});
  EXPECT_TRUE(home().walls.empty());
  EXPECT_FALSE(overlay().note.empty());
  EXPECT_EQ(editor.tool().cursor(editor, plane), Cursor::Forbidden);
}

TEST_F(WallTool, RefusesAWallOnAWall) {
  click({0, 0});
  click({3, 0});
  rightClick({1, 1});
  click({0, 0});
  move({3, 0});
  EXPECT_FALSE(overlay().note.empty());
  click({3, 0});
  key(Key::Escape);
  EXPECT_EQ(home().walls.size(), 1u);
}

TEST_F(WallTool, ShowsWhatCanBeTyped) {
  click({1, 1});
  move({1, 3});
  const Overlay shown = overlay();
  ASSERT_EQ(shown.fields.size(), 4u);
  EXPECT_NEAR(shown.fields[0].value, 2, 1e-6);
  EXPECT_NEAR(shown.fields[1].value, kPi / 2, 1e-6);
  EXPECT_TRUE(shown.fields[0].active);
  ASSERT_EQ(shown.measures.size(), 1u);
}

TEST_F(WallTool, AnotherEditEndsTheChainAndKeepsItsWalls) {
  click({0, 0});
  click({3, 0});
  move({3, 2});
  editor.apply("Rename", [](const Home& before) {
    Home next = before;
    next.name = "House";
    return next;
  });
  EXPECT_EQ(home().walls.size(), 1u);
  EXPECT_EQ(home().name, "House");
  move({5, 5});
  EXPECT_EQ(home().walls.size(), 1u);
}

}  // namespace
}  // namespace idap
