#include "editor/tools/wall_room.h"

#include <algorithm>
#include <cmath>

#include "model/wall_path.h"

namespace idap {

std::vector<Stretch> freeStretches(const Home& home, WallId id, double low, double high, OpeningId except) {
  const Wall* wall = home.walls.find(id);
  if (!wall) return {};
  const WallPath path(*wall);
  std::vector<Stretch> taken;

  const auto meets = [&](const Wall& other, Vec2 at, Vec2 direction) {
    const double distance = path.nearest(at);
    if (length(path.point(distance) - at) > wall->thickness / 2 + 1e-3) return;
    // In line it takes nothing; the flatter the angle, the more.
    const double sine = std::abs(cross(path.direction(distance), direction));
    if (sine < 0.05) return;
    const double half = other.thickness / 2 / std::max(sine, 0.3);
    taken.push_back({distance - half, distance + half});
  };
  for (const auto& [otherId, other] : home.walls) {
    if (otherId == id || other->level != wall->level) continue;
    const WallPath its(*other);
    meets(*other, other->start, its.direction(0));
    meets(*other, other->end, its.direction(its.length()));
    for (const Vec2 end : {wall->start, wall->end}) {
      const double distance = its.nearest(end);
      if (length(its.point(distance) - end) < 1e-3) meets(*other, end, its.direction(distance));
    }
  }
  for (const auto& [openingId, opening] : home.openings) {
    if (openingId == except || opening->wall != id) continue;
    if (opening->position.z >= high - 1e-6 || opening->position.z + opening->size.z <= low + 1e-6) continue;
    const double distance = path.nearest({opening->position.x, opening->position.y});
    taken.push_back({distance - opening->size.x / 2, distance + opening->size.x / 2});
  }

  std::sort(taken.begin(), taken.end(), [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<Stretch> free;
  double at = 0;
  for (const Stretch& stretch : taken) {
    if (stretch.from > at + 1e-6) free.push_back({at, std::min(stretch.from, path.length())});
    at = std::max(at, stretch.to);
  }
  if (at < path.length() - 1e-6) free.push_back({at, path.length()});
  return free;
}

}  // namespace idap
