#include <algorithm>

#include "editor/commands/command_list.h"
#include "model/edits/level_edits.h"
#include "model/edits/wall_shape_edits.h"
#include "model/wall_path.h"

namespace idap {

namespace {

const std::vector<WallId>& walls(const Editor& editor) { return editor.selection().walls; }
bool anyWall(const Editor& editor) { return !walls(editor).empty(); }
bool twoWalls(const Editor& editor) {
  if (walls(editor).size() != 2) return false;
  const Wall *a = editor.home().walls.find(walls(editor)[0]), *b = editor.home().walls.find(walls(editor)[1]);
  return a && b && a->level == b->level;
}
bool anyRoundWall(const Editor& editor) {
  return std::any_of(walls(editor).begin(), walls(editor).end(), [&](WallId id) {
    const Wall* wall = editor.home().walls.find(id);
    return wall && wall->arcExtent != 0;
  });
}
bool anyRoom(const Editor& editor) { return !editor.selection().rooms.empty(); }
bool anyWallOnLevel(const Editor& editor) {
  const auto& all = editor.home().walls;
  return std::any_of(all.begin(), all.end(),
                     [&](const auto& entry) { return entry.second->level == editor.level(); });
}

void join(Editor& editor) {
  if (!twoWalls(editor)) return;
  const std::vector<WallId> pair = walls(editor);
  editor.apply(QT_TRANSLATE_NOOP("idap", "Join walls"),
               [&](const Home& home) { return followed(editor, home, joinWalls(home, pair[0], pair[1])); });
}

void split(Editor& editor) {
  Elements halves = editor.selection();
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Split walls"), [&](Home home) {
    for (const WallId id : walls(editor)) {
      WallEdit edit = splitWall(home, id, WallPath(*home.walls.find(id)).length() / 2);
      home = std::move(edit.home);
      halves.walls.push_back(edit.wall);
    }
    return home;
  });
  if (done) editor.select(std::move(halves));
}

void reverse(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Reverse walls"), [&](Home home) {
    for (const WallId id : walls(editor)) home = reverseWall(home, id);
    return home;
  });
}

void straighten(Editor& editor) {
  editor.apply(QT_TRANSLATE_NOOP("idap", "Straighten walls"), [&](const Home& home) {
    Home next = home;
    for (const WallId id : walls(editor)) {
      const Wall& wall = *next.walls.find(id);
      next = bendWall(next, id, (wall.start + wall.end) / 2);
    }
    return followed(editor, home, std::move(next));
  });
}

void wallsAround(Editor& editor) {
  const EditorSettings& settings = editor.settings();
  editor.apply(QT_TRANSLATE_NOOP("idap", "Walls around room"), [&](const Home& before) {
    Home home = before;
    for (const RoomId id : editor.selection().rooms) {
      const Room* room = home.rooms.find(id);
      const double height =
          settings.wallHeight > 0 ? settings.wallHeight : newWallHeight(home, room ? room->level : LevelId{});
      home = wallsAroundRoom(home, id, settings.wallThickness, height);
    }
    return home;
  });
}

void roomsOfAreas(Editor& editor) {
  Elements made;
  const bool done = editor.apply(QT_TRANSLATE_NOOP("idap", "Make rooms"), [&](const Home& home) {
    RoomsEdit edit = roomsOfClosedAreas(home, editor.level());
    made.rooms = std::move(edit.rooms);
    return std::move(edit.home);
  });
  if (!done) return;
  if (made.rooms.empty())
    editor.say(QT_TRANSLATE_NOOP("idap", "Walls close no area here that has no room yet"));
  else
    editor.select(std::move(made));
}

}  // namespace

std::vector<Command> wallCommands() {
  return {
      {.id = "join-walls",
       .name = QT_TRANSLATE_NOOP("idap", "Join walls"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Prolongs or shortens the two selected walls to where they meet, so that "
                                "their corner is closed"),
       .shortcut = "J",
       .menu = Menu::Walls,
       .enabled = twoWalls,
       .run = join,
       .inContextMenu = true},
      {.id = "split-wall",
       .name = QT_TRANSLATE_NOOP("idap", "Split in the middle"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Makes two walls of each selected one, to move or finish one part alone"),
       .shortcut = "Shift+W",
       .menu = Menu::Walls,
       .enabled = anyWall,
       .run = split,
       .inContextMenu = true},
      {.id = "reverse-wall",
       .name = QT_TRANSLATE_NOOP("idap", "Reverse"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Exchanges start and end, left and right of the selected walls; they look "
                                "as before"),
       .menu = Menu::Walls,
       .enabled = anyWall,
       .run = reverse},
      {.id = "straighten-wall",
       .name = QT_TRANSLATE_NOOP("idap", "Straighten"),
       .tip = QT_TRANSLATE_NOOP("idap", "Makes the selected round walls straight again"),
       .menu = Menu::Walls,
       .enabled = anyRoundWall,
       .run = straighten,
       .inContextMenu = true},
      {.id = "walls-around-room",
       .name = QT_TRANSLATE_NOOP("idap", "Walls around room"),
       .tip =
           QT_TRANSLATE_NOOP("idap", "Puts walls along the outline of the selected rooms, outside of them"),
       .menu = Menu::Walls,
       .enabled = anyRoom,
       .run = wallsAround,
       .inContextMenu = true,
       .separatorBefore = true},
      {.id = "rooms-of-areas",
       .name = QT_TRANSLATE_NOOP("idap", "Make rooms of closed areas"),
       .tip = QT_TRANSLATE_NOOP("idap",
                                "Gives every area that walls close on this level a room with a floor and a "
                                "ceiling, where it has none yet"),
       .menu = Menu::Walls,
       .enabled = anyWallOnLevel,
       .run = roomsOfAreas},
  };
}

}  // namespace idap
