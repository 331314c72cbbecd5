#include "model/room_geometry.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/wall_outline.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kMinArea = 0.1;     // m2
constexpr double kMitreLimit = 8;    // times half the thickness, as far as the corner of two walls may reach
constexpr double kSamePlace = 1e-3;  // m

struct End {
  Vec2 point;
  Vec2 outward;  // unit, away from the wall
  double half;   // thickness
};

End endOf(const Wall& wall, bool atEnd) {
  const WallPath path(wall);
  if (atEnd) return {wall.end, path.direction(path.length()), wall.thickness / 2};
  return {wall.start, -path.direction(0), wall.thickness / 2};
}

// Fills the notch that two walls with square ends leave on the outside of their corner.
void addCorner(const End& a, const End& b, std::vector<Polygon>& pieces) {
  const double turn = cross(a.outward, -b.outward);
  if (std::abs(turn) < 1e-6) return;
  // The outside of the corner is to the right when the way from a into b turns left.
  const double side = turn > 0 ? -1 : 1;
  const Vec2 fromA = a.point + perpendicular(a.outward) * (side * a.half);
  const Vec2 fromB = b.point - perpendicular(b.outward) * (side * b.half);
  // fromA + s * a.outward meets fromB + t * b.outward.
  const double s = cross(fromB - fromA, b.outward) / cross(a.outward, b.outward);
  if (s < 0 || s > kMitreLimit * std::max(a.half, b.half)) {
    pieces.push_back({a.point, fromA, fromB});
    return;
  }
  pieces.push_back({a.point, fromA, fromA + a.outward * s, fromB});
}

// What the walls of a level cover. Ends at one place that no joint was made of are closed too: files have
// such corners.
std::vector<Polygon> bodies(const Home& home, LevelId level) {
  std::vector<Polygon> pieces;
  std::vector<End> loose;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != level) continue;
    pieces.push_back(wallOutline(home, id, *wall).polygon());
    for (const bool atEnd : {false, true}) {
      const Wall* other = home.walls.find(atEnd ? wall->neighbourAtEnd : wall->neighbourAtStart);
      const bool joined = other && (other->neighbourAtStart == id || other->neighbourAtEnd == id);
      if (!joined) loose.push_back(endOf(*wall, atEnd));
    }
  }
  std::sort(loose.begin(), loose.end(), [](const End& a, const End& b) { return a.point.x < b.point.x; });
  for (std::size_t i = 0; i < loose.size(); ++i)
    for (std::size_t j = i + 1; j < loose.size() && loose[j].point.x - loose[i].point.x <= kSamePlace; ++j)
      if (length(loose[i].point - loose[j].point) <= kSamePlace) addCorner(loose[i], loose[j], pieces);
  return pieces;
}

// The middle of the longest stretch of the room on a horizontal line.
Vec2 middleAt(const Polygon& points, double y, double& longest) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  }
  std::sort(crossings.begin(), crossings.end());
  Vec2 middle{0, y};
  longest = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (const double width = crossings[i + 1] - crossings[i]; width > longest) {
      longest = width;
      middle.x = (crossings[i] + crossings[i + 1]) / 2;
    }
  return middle;
}

std::vector<Polygon> findAreas(const Home& home, LevelId level, double gap) {
  Regions walls = unite(bodies(home, level));
  if (gap > 0) walls = buffer(walls, gap);
  std::vector<Polygon> areas;
  for (const Region& region : walls)
    for (const Polygon& hole : region.holes) {
      Regions open = repair(hole);
      if (gap > 0) open = buffer(open, gap);
      for (Region& found : open)
        if (signedArea(found.outer) > kMinArea) areas.push_back(std::move(found.outer));
    }
  return areas;
}

// The areas found last, by the identity of the walls they lie between: while a wall is dragged or the pointer
// looks for a room, the same walls are asked for over and over.
class FoundAreas {
 public:
  const std::vector<Polygon>& of(const Home& home, LevelId level, double gap) {
    for (Entry& entry : entries_)
      if (&entry.walls.chunks() == &home.walls.chunks() && entry.level == level && entry.gap == gap) {
        entry.used = ++clock_;
        return entry.areas;
      }
    Entry& oldest = *std::min_element(entries_.begin(), entries_.end(),
                                      [](const Entry& a, const Entry& b) { return a.used < b.used; });
    oldest = {home.walls, level, gap, ++clock_, findAreas(home, level, gap)};
    return oldest.areas;
  }

 private:
  struct Entry {
    Table<WallId, Wall> walls;  // kept, so that no others come to lie where they are
    LevelId level;
    double gap = -1;
    std::uint64_t used = 0;
    std::vector<Polygon> areas;
  };
  std::array<Entry, 6> entries_;
  std::uint64_t clock_ = 0;
};

}  // namespace

double floorArea(const Room& room) { return area(repair(room.points)); }

Vec2 roomCentre(const Room& room) {
  if (room.points.empty()) return {};
  const Vec2 base = room.points.front();  // near the room: less is lost far from the origin
  double twice = 0;
  Vec2 sum;
  for (std::size_t i = 0; i < room.points.size(); ++i) {
    const Vec2 a = room.points[i] - base, b = room.points[(i + 1) % room.points.size()] - base;
    twice += cross(a, b);
    sum += (a + b) * cross(a, b);
  }
  const Box2 box = bounds(room.points);
  if (std::abs(twice) > 1e-9) {
    const Vec2 centre = base + sum / (3 * twice);
    if (contains(room.points, centre)) return centre;
  }
  Vec2 best = (box.min + box.max) / 2;
  double widest = 0;
  for (int i = 1; i < 16; ++i) {
    double width = 0;
    const Vec2 middle = middleAt(room.points, box.min.y + (box.max.y - box.min.y) * i / 16.0, width);
    if (width > widest * 1.001) {
      widest = width;
      best = middle;
    }
  }
  return best;
}

std::vector<Polygon> closedAreas(const Home& home, LevelId level, double gap) {
  thread_local FoundAreas found;
  return found.of(home, level, gap);
}

std::optional<Polygon> closedAreaAt(const Home& home, LevelId level, Vec2 point, double gap) {
  std::optional<Polygon> best;  // the smallest, where one lies in another
  for (Polygon& found : closedAreas(home, level, gap))
    if (contains(found, point) && (!best || signedArea(found) < signedArea(*best))) best = std::move(found);
  return best;
}

}  // namespace idap
