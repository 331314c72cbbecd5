#include "editor/tools/unseen.h"

#include "model/room_geometry.h"

namespace idap {

namespace {

double depthOf(Plane plane, Vec2 p) { return plane == Plane::XZ ? p.y : p.x; }
double acrossOf(Plane plane, Vec2 p) { return plane == Plane::XZ ? p.x : p.y; }

// The middle of the stretch of a room that a line of sight runs through, where it is longest.
std::optional<double> middleInside(Plane plane, const Polygon& room, double across) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < room.size(); ++i) {
    const Vec2 a = room[i], b = room[(i + 1) % room.size()];
    const double u = acrossOf(plane, a), v = acrossOf(plane, b);
    if ((u <= across) == (v <= across)) continue;
    crossings.push_back(depthOf(plane, a) + (depthOf(plane, b) - depthOf(plane, a)) * (across - u) / (v - u));
  }
  std::sort(crossings.begin(), crossings.end());
  std::optional<double> middle;
  double longest = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (crossings[i + 1] - crossings[i] > longest) {
      longest = crossings[i + 1] - crossings[i];
      middle = (crossings[i] + crossings[i + 1]) / 2;
    }
  return middle;
}

}  // namespace

double unseenCoordinate(const Editor& editor, Plane plane, Vec2 at) {
  if (plane == Plane::XY) return editor.elevation();
  const Home& home = editor.home();
  if (const Box3 box = bounds(home, editor.selection()); !box.empty())
    return depthOf(plane, {box.centre().x, box.centre().y});
  double largest = 0;
  std::optional<double> found;
  for (const auto& [id, room] : home.rooms) {
    if (room->level != editor.level()) continue;
    const double area = floorArea(*room);
    if (area <= largest) continue;
    if (const auto middle = middleInside(plane, room->points, at.x)) {
      largest = area;
      found = middle;
    }
  }
  if (found) return *found;
  const Box3 all = bounds(home, everything(home, editor.level()));
  return all.empty() ? 0 : depthOf(plane, {all.centre().x, all.centre().y});
}

}  // namespace idap
