// Storeys: adding, ordering, removing. A home without levels is one storey; adding one to it makes two.
#pragma once

#include "model/home.h"

namespace idap {

struct LevelEdit {
  Home home;
  LevelId level;  // the new one
};

// The level that a home without any gets before another is added: all that is there moves onto it. A home
// with levels comes back unchanged, with its lowest.
LevelEdit withLevels(const Home& home, std::string name);

// Above the given one by its height and the new floor's thickness (sameElevation: beside it, at its height).
// A level above that would overlap moves up with all above it.
LevelEdit addLevel(const Home& home, LevelId above, std::string name, bool sameElevation = false);

// With all that stands on it. Throws InvalidHome for the last level.
Home deleteLevel(const Home& home, LevelId level);

// From below, by elevation and order.
std::vector<LevelId> levelsInOrder(const Home& home);

// Exchanges a level with the one above (up) or below it, elevations following.
Home reorderLevel(const Home& home, LevelId level, bool up);

Home setLevel(const Home& home, LevelId id, const Level& level);

// The highest viewable level that lies lower than this one; LevelId{} for none.
LevelId levelBelow(const Home& home, LevelId level);

// m from the floor of a storey to its ceiling: the level's own height. A home without levels has none; there
// it is the height that most of its walls have, of two as common the taller; without walls that of new ones.
double ceilingHeight(const Home& home, LevelId level);

// The height that new walls of a storey get: the level's, or without levels the home's for new walls.
double newWallHeight(const Home& home, LevelId level);

}  // namespace idap
