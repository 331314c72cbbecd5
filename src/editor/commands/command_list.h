// The commands of each file of this folder, and what they share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editor/commands/command.h"

namespace idap {

std::vector<Command> editCommands();
std::vector<Command> visibilityCommands();
std::vector<Command> furnitureCommands();
std::vector<Command> alignCommands();
std::vector<Command> wallCommands();
std::vector<Command> planCommands();
std::vector<Command> levelCommands();

// What of the selection may be changed: locked pieces, and groups with one in them, stay as they are.
Elements changeable(const Editor& editor);
// The same with the members of groups.
Elements changeablePieces(const Editor& editor);

// All that can be selected on a level, or on all; without the base plan while it is locked.
Elements selectable(const Editor& editor, std::optional<LevelId> level);
Elements withoutBase(Elements elements);

// Openings of the selection in walls that are not selected: these keep to their wall.
Elements openingsInWalls(const Home& home, const Elements& selection);

// After an edit: rooms between the walls that changed, and dimensions of what moved, follow.
Home followed(const Editor& editor, const Home& before, Home after);

// The name of what a command makes, in the language of the user's names; they become part of the home.
enum class NewName { Level, Group };
std::string newName(const Editor& editor, NewName what, int number = 0);

}  // namespace idap
