#include "editor/editor.h"

#include <gtest/gtest.h>

#include "editor/tools/tool_driver.h"
#include "model/edits/element_edits.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct EditorOf : ToolDriver {
  EditorOf() {
    Home home_;
    piece = home_.newId<FurnitureId>();
    Furniture box;
    box.position = {1, 1, 0};
    box.size = {1, 1, 1};
    home_.furniture.set(piece, box);
    editor.open(std::make_unique<Document>(home_));
  }
  FurnitureId piece;
};

Home without(const Home& home, FurnitureId id) { return deleteElements(home, only(id)); }

TEST_F(EditorOf, TellsWhatChanged) {
  std::vector<Editor::Change> changes;
  int homes = 0;
  const int handle = editor.subscribe(
      {.changed = [&](Editor::Change change) { changes.push_back(change); },
       .homeChanged = [&](const Home& before, const Home& after) { homes += !(before == after); }});
  editor.select(only(piece));
  EXPECT_EQ(changes.front(), Editor::Change::Selection);
  changes.clear();
  editor.select(only(piece));  // as it was
  EXPECT_TRUE(changes.empty());
  EXPECT_TRUE(editor.apply("Delete", [&](const Home& home) { return without(home, piece); }));
  EXPECT_EQ(homes, 1);
  EXPECT_EQ(changes.front(), Editor::Change::Home);
  editor.unsubscribe(handle);
  editor.undo();
  EXPECT_EQ(homes, 1);
}

TEST_F(EditorOf, SelectionDropsWhatIsGoneAndStaysGone) {
  editor.select(only(piece));
  editor.apply("Delete", [&](const Home& home) { return without(home, piece); });
  EXPECT_TRUE(empty(editor.selection()));
  editor.undo();
  EXPECT_TRUE(editor.home().furniture.contains(piece));
  EXPECT_TRUE(empty(editor.selection()));
  editor.select(only(FurnitureId{12345}));
  EXPECT_TRUE(empty(editor.selection()));
}

TEST_F(EditorOf, RefusesWhatWouldBreakTheHome) {
  const bool done = editor.apply("Break", [&](const Home& home) {
    Home next = home;
    Furniture box = *home.furniture.find(piece);
    box.size.x = -1;
    next.furniture.set(piece, box);
    return next;
  });
  EXPECT_FALSE(done);
  EXPECT_EQ(said.size(), 1u);
  EXPECT_FALSE(document().canUndo());
}

TEST_F(EditorOf, UndoDuringADragTakesBackTheDragOnly) {
  editor.apply("Rename", [](const Home& home) {
    Home next = home;
    next.name = "mine";
    return next;
  });
  press({1, 1});
  pointer(PointerEvent::Kind::Move, {3, 1});
  EXPECT_NEAR(home().furniture.find(piece)->position.x, 3, 1e-9);
  editor.undo();
  EXPECT_NEAR(home().furniture.find(piece)->position.x, 1, 1e-9);
  EXPECT_EQ(home().name, "mine");
  EXPECT_FALSE(document().inTransaction());
  release({3, 1});
  EXPECT_NEAR(home().furniture.find(piece)->position.x, 1, 1e-9);
  editor.undo();
  EXPECT_EQ(home().name, "");
}

TEST_F(EditorOf, AnotherEditTakesBackTheDragFirst) {
  press({1, 1});
  pointer(PointerEvent::Kind::Move, {3, 1});
  EXPECT_TRUE(editor.apply("Rename", [](const Home& home) {
    Home next = home;
    next.name = "mine";
    return next;
  }));
  EXPECT_NEAR(home().furniture.find(piece)->position.x, 1, 1e-9);
  EXPECT_EQ(document().undoName(), "Rename");
}

TEST_F(EditorOf, ToolsGiveWayToSelecting) {
  EXPECT_TRUE(editor.selecting());
  editor.takeTool("wall");
  EXPECT_FALSE(editor.selecting());
  editor.takeTool("no such tool");
  EXPECT_FALSE(editor.selecting());
  EXPECT_TRUE(key(Key::Escape));
  EXPECT_TRUE(editor.selecting());
  editor.select(only(piece));
  EXPECT_TRUE(key(Key::Escape));
  EXPECT_TRUE(empty(editor.selection()));
  EXPECT_FALSE(key(Key::Escape));
}

TEST_F(EditorOf, ChangingToolOrLevelTakesBackTheDrag) {
  press({1, 1});
  pointer(PointerEvent::Kind::Move, {3, 1});
  editor.takeTool("wall");
  EXPECT_NEAR(home().furniture.find(piece)->position.x, 1, 1e-9);
  EXPECT_FALSE(document().inTransaction());
}

TEST_F(EditorOf, OpensOnTheLowestStoreyAboveGround) {
  Home home_;
  const auto cellar = home_.newId<LevelId>(), ground = home_.newId<LevelId>(), upper = home_.newId<LevelId>();
  home_.levels.set(cellar, Level{.elevation = -2.6});
  home_.levels.set(ground, Level{.elevation = 0});
  home_.levels.set(upper, Level{.elevation = 2.6});
  press({1, 1});  // half a drag of the old document
  pointer(PointerEvent::Kind::Move, {3, 1});
  editor.open(std::make_unique<Document>(home_));
  EXPECT_EQ(editor.level(), ground);
  EXPECT_TRUE(editor.selecting());
  editor.setLevel(upper);
  EXPECT_NEAR(editor.elevation(), 2.6, 1e-9);
  editor.setLevel(LevelId{77});
  EXPECT_EQ(editor.level(), upper);
}

TEST_F(EditorOf, ListenersNeverFindWhatIsGoneSelected) {
  editor.select(only(piece));
  std::vector<std::size_t> found;
  editor.subscribe(
      {.changed = [&](Editor::Change) { found.push_back(count(editor.selection())); },
       .homeChanged = [&](const Home&, const Home&) { found.push_back(count(editor.selection())); }});
  editor.apply("Delete", [&](const Home& now) { return deleteElements(now, only(piece)); });
  ASSERT_FALSE(found.empty());
  for (const std::size_t selected : found) EXPECT_EQ(selected, 0u);
}

TEST_F(EditorOf, ListenersMayComeAndGoWhileTold) {
  int told = 0, handle = 0;
  handle = editor.subscribe({.changed = [&](Editor::Change) {
    ++told;
    editor.unsubscribe(handle);
    editor.subscribe({});
  }});
  editor.select(only(piece));
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace idap
