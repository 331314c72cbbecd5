#include "model/edits/level_edits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "base/error.h"
#include "model/edits/element_edits.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

constexpr double kSameHeight = 1e-6;  // m

const Level& existing(const Home& home, LevelId id) {
  if (const Level* level = home.levels.find(id)) return *level;
  throw InvalidHome("level " + std::to_string(id.value) + " does not exist");
}

// Calls f with each table whose elements stand on a level.
template <class F>
void onLevels(Home& home, F f) {
  f(home.walls);
  f(home.rooms);
  f(home.openings);
  f(home.furniture);
  f(home.dimensions);
  f(home.labels);
  f(home.polylines);
}

// Puts the levels of a new elevation into the home, and takes along the people (cameras) who stand in one.
void raise(Home& home, const std::map<LevelId, Level>& changed) {
  const Home before = home;
  const std::vector<LevelId> order = levelsInOrder(before);
  const auto rise = [&](double z) {
    for (auto id = order.rbegin(); id != order.rend(); ++id) {
      const Level& level = *before.levels.find(*id);
      if (z < level.elevation - level.floorThickness || z > level.elevation + level.height) continue;
      const auto found = changed.find(*id);
      return found == changed.end() ? 0.0 : found->second.elevation - level.elevation;
    }
    return 0.0;
  };
  for (const auto& [id, level] : changed) home.levels.set(id, level);
  changeWhere(
      home.cameras, [&](const Camera& camera) { return rise(camera.eye.z) != 0; },
      [&](Camera& camera) { camera.eye.z += rise(camera.eye.z); });
  if (home.observer) home.observer->eye.z += rise(home.observer->eye.z);
}

}  // namespace

std::vector<LevelId> levelsInOrder(const Home& home) {
  std::vector<LevelId> ids;
  for (const auto& [id, level] : home.levels) ids.push_back(id);
  std::sort(ids.begin(), ids.end(), [&home](LevelId a, LevelId b) {
    const Level &x = *home.levels.find(a), &y = *home.levels.find(b);
    return std::tie(x.elevation, x.order, a) < std::tie(y.elevation, y.order, b);
  });
  return ids;
}

LevelEdit withLevels(const Home& home, std::string name) {
  if (!home.levels.empty()) return {home, levelsInOrder(home).front()};
  Home next = home;
  const auto id = next.newId<LevelId>();
  Level ground;
  ground.name = std::move(name);
  ground.height = home.wallHeight;
  next.levels.set(id, std::move(ground));
  onLevels(next, [id](auto& table) {
    changeWhere(
        table, [](const auto& element) { return !element.level; },
        [id](auto& element) { element.level = id; });
  });
  if (auto entry = next.backgrounds.extract(LevelId{})) {
    entry.key() = id;
    next.backgrounds.insert(std::move(entry));
  }
  return {std::move(next), id};
}

LevelEdit addLevel(const Home& home, LevelId aboveId, std::string name, bool sameElevation) {
  const Level& above = existing(home, aboveId);
  Level added;
  added.name = std::move(name);
  added.floorThickness = above.floorThickness;
  added.height = above.height;
  Home next = home;
  const auto id = next.newId<LevelId>();
  if (sameElevation) {
    added.elevation = above.elevation;
    for (const auto& [otherId, other] : home.levels)
      if (std::abs(other->elevation - above.elevation) < kSameHeight)
        added.order = std::max(added.order, other->order + 1);
  } else {
    added.elevation = above.elevation + above.height + added.floorThickness;
    std::map<LevelId, Level> higher;
    double lift = 0;
    for (const auto& [otherId, other] : home.levels) {
      if (other->elevation <= above.elevation + kSameHeight) continue;
      higher.emplace(otherId, *other);
      lift = std::max(lift, added.elevation + added.height + other->floorThickness - other->elevation);
    }
    if (lift > kSameHeight) {
      for (auto& [otherId, level] : higher) level.elevation += lift;
      raise(next, higher);
    }
  }
  next.levels.set(id, std::move(added));
  return {std::move(next), id};
}

Home deleteLevel(const Home& home, LevelId id) {
  existing(home, id);
  if (home.levels.size() == 1) throw InvalidHome("a home keeps its last level");
  Elements all;
  const auto gather = [id](const auto& table, auto& ids) {
    for (const auto& [elementId, element] : table)
      if (element->level == id) ids.push_back(elementId);
  };
  gather(home.walls, all.walls);
  gather(home.rooms, all.rooms);
  gather(home.openings, all.openings);
  gather(home.furniture, all.furniture);
  gather(home.dimensions, all.dimensions);
  gather(home.labels, all.labels);
  gather(home.polylines, all.polylines);
  Home next = deleteElements(home, all);
  next.levels.erase(id);
  next.backgrounds.erase(id);
  return next;
}

Home reorderLevel(const Home& home, LevelId id, bool up) {
  existing(home, id);
  const std::vector<LevelId> order = levelsInOrder(home);
  const auto at = std::find(order.begin(), order.end(), id);
  if (up ? at + 1 == order.end() : at == order.begin()) return home;
  const LevelId lowerId = up ? id : *(at - 1), upperId = up ? *(at + 1) : id;
  const Level &lower = existing(home, lowerId), &upper = existing(home, upperId);
  Home next = home;
  std::map<LevelId, Level> changed{{lowerId, lower}, {upperId, upper}};
  if (upper.elevation - lower.elevation < kSameHeight) {
    // Orders of files can be equal: they are counted anew.
    int place = 0;
    for (const LevelId other : order) {
      const Level& level = existing(home, other);
      if (std::abs(level.elevation - lower.elevation) >= kSameHeight) continue;
      const int shift = other == lowerId ? 1 : other == upperId ? -1 : 0;
      Level counted = level;
      counted.order = place++ + shift;
      next.levels.set(other, std::move(counted));
    }
    return next;
  }
  // The two storeys change places and keep the air between them; what is above stays on top of them.
  const double air = upper.elevation - upper.floorThickness - (lower.elevation + lower.height);
  Level &rising = changed[lowerId], &sinking = changed[upperId];
  sinking.elevation = lower.elevation;
  rising.elevation = lower.elevation + upper.height + lower.floorThickness + air;
  std::swap(rising.order, sinking.order);
  for (const auto& [otherId, other] : home.levels)
    if (other->elevation > upper.elevation + kSameHeight) {
      Level moved = *other;
      moved.elevation += lower.floorThickness - upper.floorThickness;
      changed.emplace(otherId, std::move(moved));
    }
  raise(next, changed);
  return next;
}

Home setLevel(const Home& home, LevelId id, const Level& level) {
  existing(home, id);
  Home next = home;
  raise(next, {{id, level}});
  return next;
}

LevelId levelBelow(const Home& home, LevelId id) {
  const Level* level = home.levels.find(id);
  if (!level) return {};
  LevelId below;
  for (const LevelId other : levelsInOrder(home)) {
    const Level& candidate = *home.levels.find(other);
    if (candidate.elevation < level->elevation - kSameHeight && candidate.viewable) below = other;
  }
  return below;
}

double ceilingHeight(const Home& home, LevelId id) {
  if (const Level* level = home.levels.find(id)) return level->height;
  std::map<long long, std::size_t> walls;  // by height in mm
  for (const auto& [wallId, wall] : home.walls)
    if (wall->level == id) ++walls[std::llround(std::max(wall->heightAtStart, wall->heightAtEnd) * 1000)];
  std::size_t most = 0;
  double height = home.wallHeight;
  for (const auto& [millimetres, count] : walls)
    if (count >= most) most = count, height = static_cast<double>(millimetres) / 1000;
  return height;
}

double newWallHeight(const Home& home, LevelId id) {
  const Level* level = home.levels.find(id);
  return level ? level->height : home.wallHeight;
}

}  // namespace idap
