#include "editor/commands/command.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "model/edits/level_edits.h"
#include "model/edits/piece_edits.h"
#include "model/edits/wall_edits.h"
#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

// Of the small flat: walls 1..4 around (6 x 4, counter-clockwise from the origin), 5 across at x = 3.
constexpr WallId kBottom{1}, kRight{2}, kMiddle{5};
constexpr OpeningId kDoor{6}, kWindow{7};
constexpr GroupId kDining{8};
constexpr FurnitureId kTable{9};

class Commands : public testing::Test {
 protected:
  Commands() {
    editor.subscribe({.said = [this](const Text& text, Editor::Severity) { said.push_back(text.source); }});
  }

  static std::shared_ptr<const Catalog> builtIn() {
    static const auto catalog = std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
    return catalog;
  }
  void open(Home home) { editor.open(std::make_unique<Document>(std::move(home))); }
  bool enabled(const char* id) {
    const Command* command = findCommand(id);
    return command && (!command->enabled || command->enabled(editor));
  }
  bool checked(const char* id) { return findCommand(id)->checked(editor); }
  // Runs what must be enabled, and sees that undo takes it back and redo does it again.
  void run(const char* id) {
    SCOPED_TRACE(id);
    const Command* command = findCommand(id);
    ASSERT_TRUE(command);
    ASSERT_TRUE(enabled(id));
    const Home before = editor.home();
    command->run(editor);
    EXPECT_NO_THROW(requireValid(editor.home()));
    const Home after = editor.home();
    if (after == before) return;
    const Elements selection = editor.selection();
    const LevelId level = editor.level();
    editor.undo();
    EXPECT_EQ(editor.home(), before) << "one undo takes all of it back";
    editor.redo();
    EXPECT_EQ(editor.home(), after);
    editor.setLevel(level);
    editor.select(selection);
  }
  const Home& home() const { return editor.home(); }
  const Furniture& table() const { return *home().furniture.find(kTable); }

  Editor editor{builtIn()};
  std::vector<std::string> said;
};

TEST_F(Commands, HaveNamesTipsAndIdsOfTheirOwn) {
  std::set<std::string> ids;
  std::map<std::string, std::string> shortcuts;
  for (const Command& command : commands()) {
    SCOPED_TRACE(command.id);
    EXPECT_TRUE(ids.insert(command.id).second);
    EXPECT_NE(*command.name, '\0');
    EXPECT_NE(*command.tip, '\0');
    EXPECT_TRUE(command.run);
    EXPECT_EQ(findCommand(command.id), &command);
    if (*command.shortcut) {
      EXPECT_TRUE(shortcuts.emplace(command.shortcut, command.id).second)
          << command.shortcut << " is taken by " << shortcuts[command.shortcut];
    }
  }
  for (const ToolEntry& tool : tools())
    EXPECT_FALSE(shortcuts.contains(tool.info->shortcut)) << tool.info->id << ' ' << tool.info->shortcut;
  for (const char* taken : {"V",      "W",
                            "O",      "D",
                            "N",      "M",
                            "T",      "L",
                            "P",      "C",
                            "E",      "F2",
                            "F9",     "F11",
                            "Ctrl+F", "Ctrl+N",
                            "Ctrl+O", "Ctrl+S",
                            "Ctrl+Q", "Ctrl+P",
                            "Ctrl+Z", "Ctrl+Shift+Z",
                            "Ctrl+C", "Ctrl+X",
                            "Ctrl+V"})
    EXPECT_FALSE(shortcuts.contains(taken)) << taken;
  EXPECT_EQ(findCommand("no such"), nullptr);
}

TEST_F(Commands, AreDisabledWhereTheyWouldDoNothing) {
  for (const char* id : {"delete",
                         "duplicate",
                         "rotate-left",
                         "mirror",
                         "lock",
                         "hide",
                         "show",
                         "show-all",
                         "group",
                         "ungroup",
                         "align-left",
                         "distribute-vertically",
                         "reset-elevation",
                         "to-floor",
                         "lamps-on",
                         "lamps-off",
                         "join-walls",
                         "split-wall",
                         "reverse-wall",
                         "straighten-wall",
                         "walls-around-room",
                         "rooms-of-areas",
                         "flip-horizontally",
                         "level-up",
                         "level-down",
                         "delete-level",
                         "level-alone",
                         "level-visible",
                         "select-all-levels"})
    EXPECT_FALSE(enabled(id)) << id;
  // And run from a button all the same, they do no harm.
  const Home before = home();
  for (const Command& command : commands())
    if (command.enabled && !command.enabled(editor)) command.run(editor);
  EXPECT_EQ(home(), before);
}

TEST_F(Commands, DeleteLeavesWhatIsLocked) {
  open(test::smallFlat());
  Elements chosen;
  chosen.furniture = {kTable};
  editor.select(chosen);
  run("lock");
  EXPECT_TRUE(table().locked);
  EXPECT_TRUE(checked("lock"));
  EXPECT_FALSE(enabled("delete"));
  chosen.openings = {kDoor};
  editor.select(chosen);
  run("delete");
  EXPECT_TRUE(home().furniture.contains(kTable));
  EXPECT_FALSE(home().openings.contains(kDoor));
  EXPECT_EQ(said.size(), 1u);
  run("lock");
  EXPECT_FALSE(table().locked);
  run("delete");
  EXPECT_TRUE(home().furniture.empty());
}

TEST_F(Commands, RoomsAndDimensionsFollow) {
  RoomEdit room = addRoomAt(test::smallFlat(), {}, {1, 1});
  // A stub of a wall in the room, which its floor leaves out until it is deleted.
  const WallEdit stub = addWall(room.home, test::wall({0, 3}, {1, 3}));
  room.home = addRoomAt(deleteElements(stub.home, Elements{.rooms = {room.room}}), {}, {1, 1}).home;
  Dimension dimension;
  dimension.start = {0.8, 1.6};
  dimension.end = {2.2, 1.6};
  room.home.dimensions.set(room.home.newId<DimensionId>(), dimension);
  open(room.home);
  const double area = floorArea(*home().rooms.begin()->second);
  Elements chosen;
  chosen.walls = {stub.wall};
  editor.select(chosen);
  run("delete");
  EXPECT_NEAR(floorArea(*home().rooms.begin()->second), area + 0.9 * 0.2, 1e-6);
  chosen = {};
  chosen.groups = {kDining};
  chosen.openings = {kWindow};
  editor.select(chosen);
  run("align-centre-horizontal");
  EXPECT_NEAR(home().dimensions.begin()->second->start.x, 3.8, 1e-9);
}

TEST_F(Commands, DuplicateSelectsTheCopies) {
  open(test::smallFlat());
  Elements chosen;
  chosen.groups = {kDining};
  editor.select(chosen);
  run("duplicate");
  ASSERT_EQ(editor.selection().groups.size(), 1u);
  EXPECT_NE(editor.selection().groups[0], kDining);
  EXPECT_EQ(home().furniture.size(), 2u);
}

TEST_F(Commands, ADuplicatedWindowGoesAsideInItsWall) {
  open(test::smallFlat());
  Elements chosen;
  chosen.openings = {kWindow};
  editor.select(chosen);
  run("duplicate");
  ASSERT_EQ(editor.selection().openings.size(), 1u);
  const Opening& copy = *home().openings.find(editor.selection().openings[0]);
  EXPECT_EQ(copy.wall, kBottom);
  EXPECT_NEAR(copy.position.y, 0, 1e-12);
  EXPECT_NEAR(copy.position.x, 4.5 - 1.3, 1e-9);
}

TEST_F(Commands, SelectAllMeansWhatCanBeSelectedHere) {
  LevelEdit two = withLevels(test::smallFlat(), "Ground");
  two = addLevel(two.home, two.level, "First");
  Furniture upstairs;
  upstairs.level = two.level;
  two.home = addFurniture(two.home, upstairs).home;
  open(two.home);
  EXPECT_EQ(home().levels.find(editor.level())->name, "Ground");
  run("select-all");
  EXPECT_EQ(editor.selection().walls.size(), 5u);
  EXPECT_EQ(editor.selection().groups.size(), 1u);
  EXPECT_TRUE(editor.selection().furniture.empty());
  run("select-all-levels");
  EXPECT_EQ(editor.selection().furniture.size(), 1u);
  run("lock-base");
  EXPECT_TRUE(checked("lock-base"));
  EXPECT_TRUE(editor.selection().walls.empty()) << "what is locked now is let go";
  run("select-all");
  EXPECT_TRUE(editor.selection().walls.empty() && editor.selection().openings.empty());
  EXPECT_EQ(editor.selection().groups.size(), 1u);
}

TEST_F(Commands, RotateTurnsAboutTheMiddleAndFourTimesIsOnce) {
  open(test::smallFlat());
  Elements chosen;
  chosen.groups = {kDining};
  editor.select(chosen);
  run("rotate-left");
  EXPECT_NEAR(table().angle, kPi / 2, 1e-12);
  EXPECT_NEAR(table().position.x, 1.5, 1e-9);
  run("rotate-right");
  EXPECT_NEAR(table().angle, 0, 1e-12);
  chosen = {};
  chosen.openings = {kDoor};
  editor.select(chosen);
  const Vec3 before = home().openings.find(kDoor)->position;
  run("rotate-left");
  const Opening& door = *home().openings.find(kDoor);
  EXPECT_EQ(door.position, before) << "a door stays in its wall";
  EXPECT_NEAR(std::abs(door.angle - kPi / 2), kPi, 1e-9) << "and opens to the other side";
}

TEST_F(Commands, MirrorChangesTheHandsOfADoor) {
  open(test::smallFlat());
  Elements chosen;
  chosen.openings = {kDoor};
  editor.select(chosen);
  run("mirror");
  EXPECT_TRUE(home().openings.find(kDoor)->mirrored);
  run("mirror");
  EXPECT_FALSE(home().openings.find(kDoor)->mirrored);
}

TEST_F(Commands, HiddenPiecesComeBackTogether) {
  open(test::smallFlat());
  Elements chosen;
  chosen.groups = {kDining};
  chosen.openings = {kDoor};
  editor.select(chosen);
  run("hide");
  EXPECT_FALSE(home().groups.find(kDining)->visible);
  EXPECT_TRUE(table().visible) << "the group is hidden as one";
  EXPECT_FALSE(isShown(home(), table()));
  editor.select({});
  run("select-all");
  EXPECT_TRUE(editor.selection().groups.empty()) << "what cannot be seen is not selected";
  run("show-all");
  EXPECT_TRUE(isShown(home(), table()));
  EXPECT_TRUE(home().openings.find(kDoor)->visible);
  EXPECT_FALSE(enabled("show-all"));
}

TEST_F(Commands, GroupAndUngroupKeepTheSelection) {
  open(test::manyPieces(3));
  Elements chosen;
  chosen.furniture = {FurnitureId{1}, FurnitureId{2}};
  editor.select(chosen);
  run("group");
  ASSERT_EQ(editor.selection().groups.size(), 1u);
  EXPECT_EQ(home().groups.begin()->second->name, "Group");
  EXPECT_FALSE(enabled("group"));
  run("ungroup");
  EXPECT_EQ(editor.selection().furniture, chosen.furniture);
  EXPECT_TRUE(home().groups.empty());
  EditorSettings settings = editor.settings();
  settings.language = "th";
  editor.setSettings(settings);
  run("group");
  EXPECT_EQ(home().groups.begin()->second->name, "กลุ่ม");
}

TEST_F(Commands, AligningNeedsTwoAndOneThatIsFree) {
  open(test::smallFlat());
  Elements chosen;
  chosen.openings = {kDoor, kWindow};
  editor.select(chosen);
  EXPECT_FALSE(enabled("align-left")) << "walls hold both";
  chosen.groups = {kDining};
  editor.select(chosen);
  for (const Command& command : commands())
    if (std::string(command.submenu) == "Align") run(command.id);
  run("distribute-horizontally");
}

TEST_F(Commands, PiecesComeDownToTheFloorOrTheTable) {
  Home start = test::smallFlat();
  Furniture vase;
  vase.position = {1.5, 2, 2};
  vase.size = {0.2, 0.2, 0.3};
  const FurnitureEdit edit = addFurniture(start, vase);
  open(edit.home);
  Elements chosen;
  chosen.furniture = {edit.furniture};
  editor.select(chosen);
  run("reset-elevation");
  EXPECT_DOUBLE_EQ(home().furniture.find(edit.furniture)->position.z, 0.75);
  run("to-floor");
  EXPECT_EQ(home().furniture.find(edit.furniture)->position.z, 0);
}

TEST_F(Commands, LampsOfTheSelectionOrAll) {
  Home start = test::manyPieces(3);
  for (const FurnitureId id : {FurnitureId{1}, FurnitureId{2}}) {
    Furniture lamp = *start.furniture.find(id);
    lamp.lamp = Lamp{};
    start.furniture.set(id, lamp);
  }
  open(start);
  EXPECT_FALSE(enabled("lamps-on"));
  Elements chosen;
  chosen.furniture = {FurnitureId{1}};
  editor.select(chosen);
  run("lamps-off");
  EXPECT_FALSE(home().furniture.find(FurnitureId{1})->lamp->on);
  EXPECT_TRUE(home().furniture.find(FurnitureId{2})->lamp->on);
  editor.select({});
  run("lamps-off");
  EXPECT_FALSE(home().furniture.find(FurnitureId{2})->lamp->on);
  run("lamps-on");
  EXPECT_TRUE(home().furniture.find(FurnitureId{1})->lamp->on);
}

TEST_F(Commands, WallsAreSplitJoinedReversedAndStraightened) {
  open(test::smallFlat());
  Elements chosen;
  chosen.walls = {kRight};
  editor.select(chosen);
  run("split-wall");
  EXPECT_EQ(home().walls.size(), 6u);
  EXPECT_EQ(editor.selection().walls.size(), 2u);
  run("reverse-wall");
  Home bent = home();
  Wall arc = *bent.walls.find(kRight);
  arc.arcExtent = 1;
  bent.walls.set(kRight, arc);
  open(bent);
  EXPECT_FALSE(enabled("straighten-wall"));
  editor.select(chosen);
  run("straighten-wall");
  EXPECT_EQ(home().walls.find(kRight)->arcExtent, 0);
  EXPECT_FALSE(enabled("join-walls"));

  Home loose;
  const WallEdit a = addWall(loose, test::wall({0, 0}, {3, 0}));
  const WallEdit b = addWall(a.home, test::wall({4, 3}, {4, 1}));
  open(b.home);
  chosen.walls = {a.wall, b.wall};
  editor.select(chosen);
  run("join-walls");
  EXPECT_EQ(home().walls.find(a.wall)->end, (Vec2{4, 0}));
}

TEST_F(Commands, WallsThatCannotBeJoinedAreToldWhy) {
  const WallEdit a = addWall({}, test::wall({0, 0}, {3, 0}));
  const WallEdit b = addWall(a.home, test::wall({0, 1}, {3, 1}));
  open(b.home);
  Elements chosen;
  chosen.walls = {a.wall, b.wall};
  editor.select(chosen);
  run("join-walls");
  EXPECT_EQ(home(), b.home);
  EXPECT_EQ(said.size(), 1u);
}

TEST_F(Commands, RoomsAndWallsMakeEachOther) {
  open(test::smallFlat());
  run("rooms-of-areas");
  EXPECT_EQ(home().rooms.size(), 2u);
  EXPECT_EQ(editor.selection().rooms.size(), 2u);
  run("rooms-of-areas");
  EXPECT_EQ(home().rooms.size(), 2u);
  EXPECT_EQ(said.size(), 1u);

  Home drawn;
  Room room;
  room.points = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const RoomEdit edit = addRoom(drawn, room);
  open(edit.home);
  EXPECT_FALSE(enabled("rooms-of-areas"));
  Elements chosen;
  chosen.rooms = {edit.room};
  editor.select(chosen);
  run("walls-around-room");
  EXPECT_EQ(home().walls.size(), 4u);
  EXPECT_EQ(home().walls.begin()->second->heightAtStart, home().wallHeight);
}

TEST_F(Commands, ThePlanIsFlipped) {
  open(test::smallFlat());
  run("flip-horizontally");
  EXPECT_NEAR(home().openings.find(kWindow)->position.x, 1.5, 1e-9);
  run("flip-vertically");
  EXPECT_NEAR(home().openings.find(kWindow)->position.y, 4, 1e-9);
}

TEST_F(Commands, SwitchesShowAndChangeTheSettings) {
  for (const char* id : {"snapping", "grid-snapping", "room-areas", "show-grid", "show-rulers",
                         "show-level-below", "lock-base"}) {
    const bool before = checked(id);
    const EditorSettings settings = editor.settings();
    run(id);
    EXPECT_NE(checked(id), before) << id;
    run(id);
    EXPECT_EQ(editor.settings(), settings);
  }
}

TEST_F(Commands, LevelsAreAddedMovedShownAndDeleted) {
  open(test::smallFlat());
  run("add-level");
  EXPECT_EQ(home().levels.size(), 2u);
  EXPECT_EQ(home().levels.find(editor.level())->name, "Level 1");
  EXPECT_DOUBLE_EQ(editor.elevation(), 2.62);
  const LevelId first = editor.level();
  run("add-level-same");
  EXPECT_DOUBLE_EQ(editor.elevation(), 2.62);
  EXPECT_EQ(home().levels.find(editor.level())->name, "Level 2");
  EXPECT_FALSE(enabled("level-up"));
  run("level-down");
  EXPECT_LT(home().levels.find(editor.level())->order, home().levels.find(first)->order);
  run("level-visible");
  EXPECT_FALSE(checked("level-visible"));
  run("level-visible");
  run("level-alone");
  EXPECT_TRUE(checked("level-alone"));
  EXPECT_FALSE(home().levels.find(first)->visible);
  run("level-alone");
  EXPECT_TRUE(home().levels.find(first)->visible);
  run("delete-level");
  EXPECT_EQ(home().levels.size(), 2u);
  EXPECT_TRUE(home().levels.contains(editor.level()));
  run("delete-level");
  EXPECT_FALSE(enabled("delete-level"));
}

}  // namespace
}  // namespace idap
