#include <gtest/gtest.h>

#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct SelectToolOf : ToolDriver {
  FurnitureId put(Vec3 position, Vec3 size = {0.5, 0.5, 0.5}) {
    const auto id = start.newId<FurnitureId>();
    Furniture piece;
    piece.position = position;
    piece.size = size;
    start.furniture.set(id, piece);
    return id;
  }
  void open() { editor.open(std::make_unique<Document>(start)); }
  std::vector<AnyId> selected() const { return list(editor.selection()); }
  Home start;
};

using Ids = std::vector<AnyId>;

TEST_F(SelectToolOf, ClickSelectsAndClickOnNothingClears) {
  const FurnitureId a = put({0, 0, 0}), b = put({2, 0, 0});
  open();
  click({0, 0});
  EXPECT_EQ(selected(), Ids{a});
  click({2, 0});
  EXPECT_EQ(selected(), Ids{b});
  click({5, 5});
  EXPECT_TRUE(selected().empty());
  EXPECT_FALSE(document().canUndo());
}

TEST_F(SelectToolOf, ShiftAddsAndControlToggles) {
  const FurnitureId a = put({0, 0, 0}), b = put({2, 0, 0});
  open();
  click({0, 0});
  modifiers.shift = true;
  click({2, 0});
  EXPECT_EQ(selected(), (Ids{a, b}));
  click({5, 5});
  EXPECT_EQ(selected(), (Ids{a, b}));
  modifiers = {.control = true};
  click({0, 0});
  EXPECT_EQ(selected(), Ids{b});
  click({0, 0});
  EXPECT_EQ(selected(), (Ids{a, b}));
}

TEST_F(SelectToolOf, RectangleSelects) {
  const FurnitureId a = put({0, 0, 0}), b = put({2, 0, 0});
  open();
  drag({-1, -1}, {1, 1});
  EXPECT_EQ(selected(), Ids{a});
  modifiers.shift = true;
  drag({1.2, -1}, {3, 1});
  EXPECT_EQ(selected(), (Ids{a, b}));
  modifiers = {};
  press({3, 1});
  pointer(PointerEvent::Kind::Move, {-1, -1});
  EXPECT_EQ(overlay().shapes.size(), 1u);
  EXPECT_TRUE(key(Key::Escape));
  EXPECT_TRUE(overlay().shapes.empty());
  EXPECT_EQ(selected(), (Ids{a, b}));
}

TEST_F(SelectToolOf, RepeatedClicksGoThroughWhatLiesThere) {
  Room room;
  room.points = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
  const FurnitureId table = put({0, 0, 0}, {2, 1, 0.7}), vase = put({0, 0, 0.7}, {0.2, 0.2, 0.3});
  const RoomEdit edit = addRoom(start, room);
  start = edit.home;
  open();
  click({0, 0});
  EXPECT_EQ(selected(), Ids{vase});
  click({0, 0});
  EXPECT_EQ(selected(), Ids{table});
  click({0.01, 0});
  EXPECT_EQ(selected(), Ids{edit.room});
  click({0, 0});
  EXPECT_EQ(selected(), Ids{vase});
  click({0, 0});
  drag({0, 0}, {1, 0.5});  // what a click brought up is what moves
  EXPECT_NEAR(home().furniture.find(table)->position.x, 1, 0.11);
  EXPECT_NEAR(home().furniture.find(vase)->position.x, 0, 1e-9);
}

TEST_F(SelectToolOf, ADoubleClickIsForTheWindowAndDoesNotCycle) {
  const FurnitureId under = put({0, 0, 0}, {2, 2, 0.2}), upper = put({0, 0, 0.2});
  (void)under;
  open();
  click({0, 0});
  doubleClick({0, 0});
  EXPECT_EQ(selected(), Ids{upper});
}

TEST_F(SelectToolOf, DoubleClickGoesIntoAGroup) {
  Elements two;
  two.furniture = {put({0, 0, 0}), put({2, 0, 0})};
  const GroupEdit edit = groupElements(start, two, "pair");
  start = edit.home;
  open();
  click({0, 0});
  EXPECT_EQ(selected(), Ids{edit.group});
  doubleClick({0, 0});
  EXPECT_EQ(selected(), Ids{two.furniture[0]});
  click({2, 0});  // inside the group from now on
  EXPECT_EQ(selected(), Ids{two.furniture[1]});
  drag({2, 0}, {4, 1});
  EXPECT_NEAR(home().furniture.find(two.furniture[1])->position.x, 4, 0.01);
  EXPECT_NEAR(home().furniture.find(two.furniture[0])->position.x, 0, 1e-9);
  click({9, 9});
  click({0, 0});
  EXPECT_EQ(selected(), Ids{edit.group});
}

TEST_F(SelectToolOf, DragOnTheFloorOfARoomSelectsUnlessTheRoomIsSelected) {
  Room room;
  room.points = {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}};
  const FurnitureId piece = put({0, 0, 0});
  const RoomEdit edit = addRoom(start, room);
  start = edit.home;
  open();
  drag({-1, -1}, {1, 1});
  EXPECT_EQ(selected(), Ids{piece});
  click({2, 2});
  EXPECT_EQ(selected(), Ids{edit.room});
  drag({2, 2}, {3, 2});
  EXPECT_NEAR(home().rooms.find(edit.room)->points[0].x, -2, 1e-9);
}

TEST_F(SelectToolOf, RightClickSelectsForTheMenu) {
  const FurnitureId a = put({0, 0, 0}), b = put({2, 0, 0});
  open();
  rightClick({2, 0});
  EXPECT_EQ(selected(), Ids{b});
  modifiers.shift = true;
  click({0, 0});
  modifiers = {};
  rightClick({0, 0});
  EXPECT_EQ(selected(), (Ids{a, b}));
}

TEST_F(SelectToolOf, ArrowKeysMoveInThePlaneOfTheView) {
  const FurnitureId a = put({0, 0, 0});
  open();
  click({0, 0});
  const auto at = [&] { return home().furniture.find(a)->position; };
  EXPECT_TRUE(key(Key::Right));
  EXPECT_NEAR(at().x, 0.01, 1e-12);
  modifiers.shift = true;
  key(Key::Up);
  EXPECT_NEAR(at().y, 0.1, 1e-12);
  modifiers = {.alt = true};
  key(Key::Left);
  EXPECT_NEAR(at().x, 0.009, 1e-12);
  modifiers = {};
  key(Key::PageUp);
  EXPECT_NEAR(at().z, 0.01, 1e-12);
  EXPECT_EQ(undoSteps(), 4);
  plane = Plane::XZ;
  move({3, 3});
  key(Key::Up);
  EXPECT_NEAR(at().z, 0.02, 1e-12);
  click({8, 8});
  EXPECT_FALSE(key(Key::Up));  // nothing is selected: the view may scroll
}

TEST_F(SelectToolOf, DeleteRemovesTheSelection) {
  const FurnitureId a = put({0, 0, 0});
  open();
  EXPECT_FALSE(key(Key::Delete));
  click({0, 0});
  EXPECT_TRUE(key(Key::Delete));
  EXPECT_FALSE(home().furniture.contains(a));
  EXPECT_EQ(document().undoName(), "Delete");
  editor.undo();
  EXPECT_TRUE(home().furniture.contains(a));
}

TEST_F(SelectToolOf, TheHintAndTheCursorSayWhatAPressWouldDo) {
  put({0, 0, 0}, {2, 2, 1});
  open();
  const Text idle = editor.tool().hint();
  EXPECT_EQ(editor.tool().cursor(editor, Plane::XY), Cursor::Arrow);
  click({0, 0});
  move({0.1, 0});
  EXPECT_EQ(editor.tool().cursor(editor, Plane::XY), Cursor::Move);
  EXPECT_FALSE(editor.tool().hint() == idle);
  move({1, 0});
  EXPECT_EQ(editor.tool().cursor(editor, Plane::XY), Cursor::SizeHorizontal);
  move({0, -1.18});
  EXPECT_EQ(editor.tool().cursor(editor, Plane::XY), Cursor::Rotate);
  const std::vector<Handle> handles = overlay().handles;
  EXPECT_TRUE(std::any_of(handles.begin(), handles.end(),
                          [](const Handle& h) { return h.active && h.kind == HandleKind::Rotate; }));
  leave();
  EXPECT_EQ(editor.tool().cursor(editor, Plane::XY), Cursor::Arrow);
}

TEST_F(SelectToolOf, TinyPiecesHaveFewHandles) {
  put({0, 0, 0}, {0.2, 0.2, 0.2});  // 20 pixels
  open();
  click({0, 0});
  const std::vector<Handle> handles = overlay().handles;
  ASSERT_EQ(handles.size(), 2u);
  EXPECT_EQ(handles[0].kind, HandleKind::ResizeCorner);
  EXPECT_EQ(handles[1].kind, HandleKind::Rotate);
}

}  // namespace
}  // namespace idap
