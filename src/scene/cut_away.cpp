#include "scene/cut_away.h"

#include <algorithm>

#include "render/accel/compiled_scene.h"
#include "scene/wall_solid.h"

namespace idap {

namespace {

constexpr double kBehindFace = 0.05;  // m that the eye must be in front of a wall to look at it from outside

}  // namespace

bool isOutside(const Home& home, Vec3 eye) {
  const std::vector<Storey> storeys = shownStoreys(home, true);
  bool any = false;
  double top = -1e300;
  for (const auto& [id, room] : home.rooms) {
    const std::size_t storey = storeyOf(storeys, room->level);
    if (storey == storeys.size()) continue;
    any = true;
    const double floor = storeys[storey].elevation, ceiling = floor + storeys[storey].height;
    top = std::max(top, ceiling);
    if (eye.z > floor - 0.1 && eye.z < ceiling && contains(room->points, {eye.x, eye.y})) return false;
  }
  // Somewhere over a lower room, under a higher ceiling: a gallery, a stairwell.
  for (const auto& [id, room] : home.rooms) {
    if (any && eye.z < top && eye.z > elevationOf(home, room->level) &&
        contains(room->points, {eye.x, eye.y}))
      return false;
  }
  if (any) return true;
  Box2 box;
  for (const auto& [id, wall] : home.walls) {
    box.add(wall->start), box.add(wall->end);
    top = std::max(top, elevationOf(home, wall->level) + std::max(wall->heightAtStart, wall->heightAtEnd));
  }
  if (box.empty()) return false;
  return eye.z > top || !box.overlaps({{eye.x, eye.y}, {eye.x, eye.y}});
}

std::vector<std::uint32_t> hiddenFrom(const BuiltScene& built, Vec3 eye, CutAway cut) {
  std::vector<std::uint32_t> hidden;
  if (cut == CutAway::Never) return hidden;
  for (const OuterWall& wall : built.outerWalls) {
    const Vec2 to{eye.x - wall.middle.x, eye.y - wall.middle.y};
    if (dot(to, wall.outward) > kBehindFace)
      hidden.insert(hidden.end(), wall.instances.begin(), wall.instances.end());
  }
  std::ranges::sort(hidden);
  return hidden;
}

void cutAway(render::CompiledScene& scene, const BuiltScene& built, Vec3 eye) {
  for (const std::uint32_t i : hiddenFrom(built, eye, CutAway::ByView)) scene.setVisibleToCamera(i, false);
  scene.commit();
}

}  // namespace idap
