#include "editor/tools/place_tool.h"

#include "editor/snap.h"
#include "model/edits/level_edits.h"
#include "tool_driver.h"

namespace idap {
namespace {

class PlaceTool : public ToolDriver {
 protected:
  CatalogPiecePtr piece(const char* id) {
    CatalogPiecePtr found = editor.catalog().find(id);
    EXPECT_TRUE(found) << id;
    return found;
  }
  void take(const char* id, bool once = false) { editor.setTool(makePlaceTool(piece(id), once)); }
};

TEST_F(PlaceTool, FollowsThePointerAndStaysWhereItIsClicked) {
  openRoom(6, 5);
  const Home before = home();
  take("idap/table-dining");
  move({3, 2.5});
  ASSERT_EQ(home().furniture.size(), 1u);
  move({2.5, 2.2});
  ASSERT_EQ(home().furniture.size(), 1u) << "one ghost";
  click({2.5, 2.2});
  leave();
  ASSERT_EQ(home().furniture.size(), 1u);
  EXPECT_NEAR(newest(home().furniture).position.z, 0, 1e-9);
  EXPECT_EQ(editor.selection().furniture.size(), 1u);
  EXPECT_FALSE(editor.selecting()) << "more of the same may follow";
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(PlaceTool, LeavesNothingWhenThePointerGoesOrEscapeIsPressed) {
  openRoom(6, 5);
  const Home before = home();
  take("idap/chair-dining");
  move({3, 2.5});
  leave();
  EXPECT_EQ(home(), before);
  move({3, 2.5});
  key(Key::Escape);
  EXPECT_EQ(home(), before);
  EXPECT_TRUE(editor.selecting());
  EXPECT_FALSE(document().canUndo());
}

TEST_F(PlaceTool, OnceIsOnce) {
  openRoom(6, 5);
  take("idap/chair-dining", true);
  move({3, 2.5});
  release({3, 2.5});  // dropped
  EXPECT_EQ(home().furniture.size(), 1u);
  EXPECT_TRUE(editor.selecting());
}

TEST_F(PlaceTool, TurnsItsBackToTheWall) {
  openRoom(6, 5);
  take("idap/wardrobe-hinged");
  click({3, 4.6});
  const Furniture& wardrobe = newest(home().furniture);
  EXPECT_NEAR(wardrobe.angle, 0, 1e-9);
  EXPECT_NEAR(wardrobe.position.y + wardrobe.size.y / 2, 5, 1e-6);
  click({0.4, 2});
  const Furniture& second = newest(home().furniture);
  EXPECT_NEAR(std::remainder(second.angle - kPi / 2, 2 * kPi), 0, 1e-9);
  EXPECT_NEAR(second.position.x - second.size.y / 2, 0, 1e-6);
}

TEST_F(PlaceTool, RTurnsIt) {
  openRoom(6, 5);
  take("idap/table-dining");
  move({3, 2.5});
  EXPECT_TRUE(type("r"));
  EXPECT_NEAR(newest(home().furniture).angle, kPi / 2, 1e-9);
  modifiers.shift = true;
  type("R");
  modifiers.shift = false;
  EXPECT_NEAR(newest(home().furniture).angle, 0, 1e-9);
}

TEST_F(PlaceTool, DistancesCanBeTyped) {
  openRoom(6, 5);
  take("idap/table-dining");
  modifiers.alt = true;
  move({2, 2.5});
  modifiers.alt = false;
  const Overlay shown = overlay();
  ASSERT_GE(shown.fields.size(), 2u);
  EXPECT_STREQ(shown.fields[0].label, "Left");
  EXPECT_NEAR(shown.fields[0].value, 2 - 0.8, 1e-6);
  type("50");
  key(Key::Enter);
  EXPECT_FALSE(document().inTransaction());
  EXPECT_NEAR(newest(home().furniture).position.x, 0.5 + 0.8, 1e-6);
  EXPECT_NEAR(newest(home().furniture).position.y, 2.5, 1e-6);
}

TEST_F(PlaceTool, GoesOntoATable) {
  openRoom(6, 5);
  take("idap/table-dining", true);
  click({3, 2.5});
  const double top = newest(home().furniture).dropOnTopHeight.value_or(newest(home().furniture).size.z);
  take("idap/vase", true);
  click({3.2, 2.5});
  EXPECT_NEAR(newest(home().furniture).position.z, top, 1e-6);
}

TEST_F(PlaceTool, LampsHangFromTheCeiling) {
  openRoom(6, 5);
  take("idap/light-globe", true);
  click({3, 2.5});
  const Furniture& lamp = newest(home().furniture);
  EXPECT_NEAR(lamp.position.z + lamp.size.z, ceilingHeight(home(), {}), 1e-9);
  EXPECT_TRUE(lamp.lamp);
}

TEST_F(PlaceTool, StandsInTheMiddleOfTheRoomFromTheFront) {
  openRoom(6, 5);
  plane = Plane::XZ;
  take("idap/table-dining", true);
  click({2, 0.4});
  const Furniture& table = newest(home().furniture);
  EXPECT_NEAR(table.position.x, 2, 0.2);
  EXPECT_NEAR(table.position.y, 2.5, 0.3);
  EXPECT_NEAR(table.position.z, 0, 1e-6) << "on the floor";
}

TEST_F(PlaceTool, DoorsJumpIntoWalls) {
  openRoom(4, 3);
  const Home before = home();
  editor.takeTool("door");
  move({2, 1.5});
  EXPECT_FALSE(overlay().note.empty()) << "says that it needs a wall";
  click({2, 1.5});
  EXPECT_FALSE(said.empty());
  leave();
  EXPECT_EQ(home(), before);
  click({2, 0.1});
  ASSERT_EQ(home().openings.size(), 1u);
  const Opening& door = newest(home().openings);
  EXPECT_TRUE(door.wall);
  EXPECT_EQ(door.kind, OpeningKind::Door);
  EXPECT_NEAR(door.position.x, 2, 1e-6);
  EXPECT_EQ(editor.selection().openings.size(), 1u);
  leave();
  EXPECT_EQ(undoSteps(), 1);
  editor.undo();
  EXPECT_EQ(home(), before);
}

TEST_F(PlaceTool, TheWayADoorOpensGoesRound) {
  openRoom(4, 3);
  editor.takeTool("door");
  move({2, 0.1});
  const Opening first = newest(home().openings);
  type("r");
  const Opening second = newest(home().openings);
  EXPECT_NE(first.mirrored, second.mirrored);
  EXPECT_NEAR(first.angle, second.angle, 1e-9);
  type("r");
  const Opening third = newest(home().openings);
  EXPECT_NEAR(std::abs(std::remainder(third.angle - first.angle, 2 * kPi)), kPi, 1e-9);
  EXPECT_EQ(first.mirrored, third.mirrored);
  type("r");
  type("r");
  EXPECT_EQ(newest(home().openings), first);
}

TEST_F(PlaceTool, DistanceFromTheCornerAndSillCanBeTyped) {
  openRoom(4, 3);
  editor.takeTool("window");
  move({2, 0.1});
  const Overlay shown = overlay();
  ASSERT_EQ(shown.fields.size(), 3u);
  EXPECT_STREQ(shown.fields[0].label, "Left");
  EXPECT_NEAR(shown.fields[0].value, 2 - 0.7, 1e-6) << "from the corner of the room";
  type("30");
  key(Key::Tab);
  key(Key::Tab);
  type("110");
  key(Key::Enter);
  const Opening& window = newest(home().openings);
  EXPECT_NEAR(window.position.x, 0.3 + window.size.x / 2, 1e-6);
  EXPECT_NEAR(window.position.z, 1.1, 1e-9);
}

TEST_F(PlaceTool, WindowsChangeHeightFromTheFront) {
  openRoom(4, 3);
  plane = Plane::XZ;
  modifiers.alt = true;
  editor.takeTool("window");
  move({2, 1.2});
  click({1.5, 1.7});
  const Opening& window = newest(home().openings);
  EXPECT_TRUE(window.wall);
  EXPECT_NEAR(window.position.x, 1.5, 1e-6);
  EXPECT_NEAR(window.position.z, 1.7 - window.size.z / 2, 1e-6);
}

TEST_F(PlaceTool, BareOpeningsHaveNoDoor) {
  openRoom(4, 3);
  editor.takeTool("opening");
  click({2, 0.1});
  const Opening& opening = newest(home().openings);
  EXPECT_EQ(opening.kind, OpeningKind::Bare);
  EXPECT_TRUE(opening.model.catalogId.empty());
  EXPECT_TRUE(opening.wall);
}

TEST_F(PlaceTool, NamesAreInTheUsersLanguage) {
  EditorSettings settings;
  settings.language = "th";
  editor.setSettings(settings);
  EXPECT_EQ(readyOpening(editor, *piece("idap/door-flush"), {}).name, "ประตูเรียบ");
}

}  // namespace
}  // namespace idap
