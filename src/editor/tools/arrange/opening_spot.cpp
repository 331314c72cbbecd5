#include "editor/tools/arrange/opening_spot.h"

#include <algorithm>
#include <cmath>

#include "editor/snap.h"
#include "editor/tools/arrange/room_space.h"
#include "editor/tools/wall_room.h"
#include "model/room_geometry.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kFromCorner =
    0.15;                          // m between a door and a corner: its frame, and a wardrobe's depth behind
constexpr double kPerMetre = 0.3;  // merit lost a metre away from where the user is at work

}  // namespace

std::optional<Opening> openingSpot(const Editor& editor, const Opening& ready, const CatalogPiece& piece,
                                   std::optional<Vec2> near) {
  const Home& home = editor.home();
  const std::vector<Polygon> areas = closedAreas(home, editor.level());
  const RoomSpace space = roomSpace(home, editor.level(), near);
  const bool door = ready.kind == OpeningKind::Door;
  const double width = ready.size.x, low = ready.position.z, high = low + ready.size.z;
  const bool entrance = std::any_of(piece.tags.begin(), piece.tags.end(), [](const std::string& tag) {
    return tag == "entrance" || tag == "patio";
  });
  WallId chosen;
  if (const auto one = single(editor.selection()); one && std::holds_alternative<WallId>(*one))
    chosen = std::get<WallId>(*one);

  const auto inside = [&](Vec2 p) {
    return std::any_of(areas.begin(), areas.end(), [p](const Polygon& area) { return contains(area, p); });
  };
  std::optional<Opening> found;
  double most = 0;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != editor.level() || (chosen && id != chosen)) continue;
    if (std::max(wall->heightAtStart, wall->heightAtEnd) < high - 0.3) continue;
    const WallPath path(*wall);
    const auto others = std::count_if(home.openings.begin(), home.openings.end(),
                                      [id = id](const auto& entry) { return entry.second->wall == id; });
    for (const Stretch& stretch : freeStretches(home, id, low, high)) {
      if (stretch.length() < width + 0.01) continue;
      std::vector<double> places{(stretch.from + stretch.to) / 2};
      if (stretch.length() > width + 2 * kFromCorner) {
        places.push_back(stretch.from + kFromCorner + width / 2);
        places.push_back(stretch.to - kFromCorner - width / 2);
      }
      for (std::size_t i = 0; i < places.size(); ++i) {
        const double distance = places[i];
        const Vec2 at = path.point(distance), side = perpendicular(path.direction(distance));
        const double beside = wall->thickness / 2 + 0.05;
        const bool left = inside(at + side * beside), right = inside(at - side * beside);
        const bool outer = left != right;
        double merit = 0.3 * std::min(stretch.length(), 5.0) - 0.7 * double(others);
        const bool middle = i == 0;
        if (door) {
          merit += (entrance ? outer : left && right) ? 1 : 0;
          if (middle) merit -= 0.5;
        } else {
          merit += outer ? 3 : 0;
          if (!middle) merit -= 1;
        }
        // The room that the user is in, or the largest.
        const bool mine =
            contains(space.area, at + side * beside) || contains(space.area, at - side * beside);
        merit += mine ? 2 : 0;
        const Corners before =
            rectangle(at, {width, wall->thickness + 2 * (door ? width : 0.3)}, std::atan2(-side.x, side.y));
        if (!space.free(before, std::max(low, 0.05), high)) merit -= 3;
        if (near) merit -= kPerMetre * length(at - *near);
        if (found && merit <= most + 1e-9) continue;
        // It opens into the room that it is seen from.
        const bool toLeft = left != right ? left : contains(space.area, at + side * beside);
        Opening wanted = ready;
        wanted.wall = id;
        const std::optional<Opening> placed =
            snapOpening(editor, wanted, at + side * (toLeft ? 0.01 : -0.01), wall->thickness);
        if (!placed || placed->wall != id) continue;
        found = placed;
        most = merit;
      }
    }
  }
  return found;
}

}  // namespace idap
