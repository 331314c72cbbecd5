#include "model/home.h"

#include "model/visibility.h"

#include <algorithm>

namespace idap {

namespace {

bool sameAssets(const Assets& a, const Assets& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && (x.second == y.second || (x.second && y.second && *x.second == *y.second));
  });
}

}  // namespace

bool operator==(const Home& a, const Home& b) {
  return a.name == b.name && a.title == b.title && a.notes == b.notes && a.currency == b.currency &&
         a.wallHeight == b.wallHeight && a.site == b.site && a.environment == b.environment &&
         a.levels == b.levels && a.walls == b.walls && a.rooms == b.rooms && a.openings == b.openings &&
         a.furniture == b.furniture && a.groups == b.groups && a.cameras == b.cameras &&
         a.pictures == b.pictures && a.dimensions == b.dimensions && a.labels == b.labels &&
         a.polylines == b.polylines && a.backgrounds == b.backgrounds && a.properties == b.properties &&
         a.nextId == b.nextId &&
         (a.assets == b.assets || (a.assets && b.assets && sameAssets(*a.assets, *b.assets)));
}

double elevationOf(const Home& home, LevelId level) {
  const Level* found = home.levels.find(level);
  return found ? found->elevation : 0;
}

bool groupsShown(const Home& home, GroupId group) {
  // Bounded, so that groups in a circle cannot hang a home that was not validated.
  for (std::size_t steps = 0; group && steps <= home.groups.size(); ++steps) {
    const Group* found = home.groups.find(group);
    if (!found) break;
    if (!found->visible) return false;
    group = found->parent;
  }
  return true;
}

bool isShown(const Home& home, const Piece& piece) {
  if (!piece.visible) return false;
  if (const Level* level = home.levels.find(piece.level); level && !(level->visible && level->viewable))
    return false;
  return groupsShown(home, piece.group);
}

}  // namespace idap
