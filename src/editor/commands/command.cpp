#include "editor/commands/command.h"

#include <algorithm>
#include <set>
#include <utility>

#include "editor/commands/command_list.h"
#include "model/diff.h"
#include "model/edits/piece_edits.h"
#include "model/edits/wall_shape_edits.h"
#include "model/visibility.h"

namespace idap {

const std::vector<Command>& commands() {
  static const std::vector<Command> all = [] {
    std::vector<Command> joined;
    for (const auto& list : {editCommands(), visibilityCommands(), furnitureCommands(), alignCommands(),
                             wallCommands(), planCommands(), levelCommands()})
      joined.insert(joined.end(), list.begin(), list.end());
    return joined;
  }();
  return all;
}

const Command* findCommand(const std::string& id) {
  const auto found = std::find_if(commands().begin(), commands().end(),
                                  [&id](const Command& command) { return id == command.id; });
  return found == commands().end() ? nullptr : &*found;
}

Elements changeable(const Editor& editor) { return unlocked(editor.home(), editor.selection()); }

Elements changeablePieces(const Editor& editor) {
  Elements pieces;
  const Elements all = withGroups(editor.home(), changeable(editor));
  pieces.furniture = all.furniture;
  pieces.openings = all.openings;
  return pieces;
}

Elements withoutBase(Elements elements) {
  elements.walls.clear();
  elements.rooms.clear();
  elements.openings.clear();
  elements.dimensions.clear();
  elements.labels.clear();
  return elements;
}

Elements selectable(const Editor& editor, std::optional<LevelId> level) {
  const Home& home = editor.home();
  Elements all = everything(home, level);
  std::erase_if(all.furniture, [&](FurnitureId id) { return !isShown(home, *home.furniture.find(id)); });
  std::erase_if(all.openings, [&](OpeningId id) { return !isShown(home, *home.openings.find(id)); });
  std::erase_if(all.groups, [&](GroupId id) { return !groupsShown(home, id); });
  return editor.settings().baseLocked ? withoutBase(std::move(all)) : all;
}

Elements openingsInWalls(const Home& home, const Elements& selection) {
  Elements held;
  for (const OpeningId id : selection.openings)
    if (const Opening* opening = home.openings.find(id);
        opening && opening->wall &&
        std::find(selection.walls.begin(), selection.walls.end(), opening->wall) == selection.walls.end())
      held.openings.push_back(id);
  return held;
}

Home followed(const Editor& editor, const Home& before, Home after) {
  const Changes<WallId> walls = diff(before, after).walls;
  std::set<LevelId> levels;
  const auto gather = [&levels](const Home& home, const std::vector<WallId>& ids) {
    for (const WallId id : ids) levels.insert(home.walls.find(id)->level);
  };
  gather(after, walls.added);
  gather(after, walls.changed);
  gather(before, walls.removed);
  for (const LevelId level : levels) after = followWalls(before, after, level, editor.settings().roomAreas);
  return dimensionsFollow(before, after);
}

std::string newName(const Editor& editor, NewName what, int number) {
  const bool thai = editor.settings().language == "th";
  if (what == NewName::Group) return thai ? "กลุ่ม" : "Group";
  return (thai ? "ชั้น " : "Level ") + std::to_string(number);
}

}  // namespace idap
