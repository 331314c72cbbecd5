#include "scene/wall_solid.h"

#include <algorithm>

#include "model/visibility.h"

namespace idap {

namespace {

// A wall that ends this little below the slab above was meant to carry it.
constexpr double kLargestGap = 0.35;
constexpr double kLowestFullWall = 1.8;
constexpr double kOverlap = 0.0002;  // m, of walls that stand on each other

// True where a floor or a wall of the storey lies over the wall.
bool isUnder(const Home& home, const Storey& above, const Wall& wall) {
  const std::vector<Vec2> line = wallCentreLine(wall);
  const Vec2 points[] = {line.front(), line[line.size() / 2], (wall.start + wall.end) / 2, line.back()};
  for (const auto& [id, room] : home.rooms) {
    if (room->level != above.id || !room->floorVisible) continue;
    for (const Vec2& p : points) {
      if (contains(room->points, p)) return true;
    }
  }
  for (const auto& [id, other] : home.walls) {
    if (other->level != above.id) continue;
    const Vec2 d = other->end - other->start;
    for (const Vec2& p : points) {
      const double t = std::clamp(alongWall(*other, p), 0.0, 1.0);
      if (other->arcExtent == 0 && length(p - other->start - d * t) < other->thickness) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Storey> shownStoreys(const Home& home, bool hiddenToo) {
  std::vector<Storey> storeys;
  if (home.levels.empty()) return {{LevelId{}, 0, Level{}.floorThickness, home.wallHeight}};
  for (const auto& [id, level] : home.levels) {
    if (level->viewable && (level->visible || hiddenToo)) {
      storeys.push_back({id, level->elevation, std::max(level->floorThickness, 0.0), level->height});
    }
  }
  std::stable_sort(storeys.begin(), storeys.end(),
                   [](const Storey& a, const Storey& b) { return a.elevation < b.elevation; });
  return storeys;
}

std::size_t storeyOf(const std::vector<Storey>& storeys, LevelId level) {
  const auto found =
      std::find_if(storeys.begin(), storeys.end(), [&](const Storey& s) { return s.id == level; });
  return static_cast<std::size_t>(found - storeys.begin());
}

bool isShownOn(const Home& home, const std::vector<Storey>& storeys, const Piece& piece) {
  return piece.visible && storeyOf(storeys, piece.level) < storeys.size() && groupsShown(home, piece.group);
}

std::vector<WallSolid> wallSolids(const Home& home, const std::vector<Storey>& storeys) {
  std::vector<WallSolid> solids;
  for (const auto& [id, wall] : home.walls) {
    const auto storey = std::ranges::find(storeys, wall->level, &Storey::id);
    if (storey == storeys.end()) continue;
    if (!isFinite(wall->start) || !isFinite(wall->end) || !(length(wall->end - wall->start) > 1e-4) ||
        !(wall->thickness > 1e-4) || !(std::max(wall->heightAtStart, wall->heightAtEnd) > 1e-3)) {
      continue;
    }
    WallSolid solid;
    solid.id = id;
    solid.wall = wall;
    solid.storey = static_cast<std::size_t>(storey - storeys.begin());
    solid.floor = storey->elevation;
    solid.bottom = storey->elevation - std::max(storey->floorThickness, 0.05) - kOverlap;
    solid.outline = wallOutline(home, id, *wall);
    solid.polygon = solid.outline.polygon();
    solid.box = bounds(solid.polygon);
    if (solid.flatTop() && wall->heightAtStart >= kLowestFullWall) {
      const double top = storey->elevation + wall->heightAtStart;
      for (auto above = storey + 1; above != storeys.end(); ++above) {
        const double gap = above->elevation - above->floorThickness - top;
        if (gap > 1e-6 && gap <= kLargestGap && isUnder(home, *above, *wall)) {
          solid.raised = gap;
          break;
        }
      }
    }
    solids.push_back(std::move(solid));
  }
  return solids;
}

}  // namespace idap
