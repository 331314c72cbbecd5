// Rooms that follow the walls around them.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "model/edits/anchors.h"
#include "model/edits/wall_shape_edits.h"
#include "model/room_geometry.h"
#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kNearFace = 0.02;     // m from a wall's face to the edge of an area that it bounds
constexpr double kNearOutline = 0.02;  // m between a room's outline and that of the area it fills
constexpr double kSameArea = 0.3;      // of 3: below this, two areas have nothing to do with each other
constexpr double kSeveral = 0.5;       // the share of an area that makes it part of another

struct Area {
  Polygon ring;
  Box2 box;
  double size = 0;                                    // m2
  double border = 0;                                  // m
  std::map<std::pair<WallId, bool>, double> borders;  // m along the left (true) or right side of a wall
};

struct Face {
  WallId id;
  WallPath path;
  double half;
  Box2 box;
};

std::vector<Face> facesOf(const Home& home, LevelId level) {
  std::vector<Face> faces;
  for (const auto& [id, wall] : home.walls) {
    if (wall->level != level) continue;
    Face face{id, WallPath(*wall), wall->thickness / 2, {}};
    const double reach = face.half + kNearFace;
    for (const Vec2 p : face.path.face(0, 0.05)) {
      face.box.add(p - Vec2{reach, reach});
      face.box.add(p + Vec2{reach, reach});
    }
    faces.push_back(std::move(face));
  }
  return faces;
}

void addBorders(Area& area, const std::vector<Face>& faces) {
  for (std::size_t i = 0; i < area.ring.size(); ++i) {
    const Vec2 a = area.ring[i], b = area.ring[(i + 1) % area.ring.size()];
    const Vec2 middle = (a + b) / 2;
    Box2 spot;
    spot.add(middle);
    const Face* nearest = nullptr;
    double best = kNearFace;
    bool left = false;
    for (const Face& face : faces) {
      if (!face.box.overlaps(spot)) continue;
      const double along = face.path.nearest(middle);
      const Vec2 from = middle - face.path.point(along);
      const double gap = std::abs(length(from) - face.half);
      if (gap >= best) continue;
      best = gap;
      nearest = &face;
      left = dot(from, perpendicular(face.path.direction(along))) > 0;
    }
    const double edge = length(b - a);
    area.border += edge;
    if (nearest) area.borders[{nearest->id, left}] += edge;
  }
}

std::vector<Area> areasOf(const Home& home, LevelId level) {
  const std::vector<Face> faces = facesOf(home, level);
  std::vector<Area> areas;
  for (Polygon& ring : closedAreas(home, level)) {
    Area area;
    area.box = bounds(ring);
    area.size = std::abs(signedArea(ring));
    area.ring = std::move(ring);
    addBorders(area, faces);
    areas.push_back(std::move(area));
  }
  return areas;
}

double overlap(const Area& a, const Area& b) {
  if (!a.box.overlaps(b.box)) return 0;
  if (a.ring == b.ring) return a.size;
  return area(intersect({{a.ring, {}}}, {{b.ring, {}}}));
}

bool fills(const Room& room, const Area& found) {
  if (room.points == found.ring) return true;
  const Box2 box = bounds(room.points);
  if (length(box.min - found.box.min) > 2 * kNearOutline ||
      length(box.max - found.box.max) > 2 * kNearOutline)
    return false;
  const Regions own = repair(room.points), theirs{{found.ring, {}}};
  return area(subtract(own, theirs)) + area(subtract(theirs, own)) < found.border * kNearOutline / 2;
}

// How much one area is what became of another, 0 to 3: the sides of walls it lies between count twice, the
// place it covers once.
double likeness(const Area& before, const Area& after, double shared) {
  double border = 0;
  for (const auto& [side, length] : before.borders)
    if (const auto found = after.borders.find(side); found != after.borders.end())
      border += std::min(length, found->second);
  const double most = std::max(before.border, after.border);
  return 2 * border / most + shared / (before.size + after.size - shared);
}

Vec2 namePoint(const Room& room) { return roomCentre(room) + room.nameOffset; }

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

// What became of the areas between walls.
struct Matching {
  std::vector<Area> before, after;
  std::vector<std::vector<double>> shared;     // m2, [before][after]
  std::vector<std::vector<RoomId>> rooms;      // that filled each area before
  std::vector<std::size_t> afterOf, beforeOf;  // kNone: none

  Matching(const Home& was, const Home& is, LevelId level)
      : before(areasOf(was, level)), after(areasOf(is, level)), rooms(before.size()) {
    for (const auto& [id, room] : was.rooms) {
      if (room->level != level) continue;
      for (std::size_t i = 0; i < before.size(); ++i)
        if (fills(*room, before[i])) rooms[i].push_back(id);
    }
    struct Pair {
      double likeness;
      std::size_t before, after;
    };
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < before.size(); ++i) {
      shared.emplace_back();
      for (std::size_t j = 0; j < after.size(); ++j) {
        shared[i].push_back(overlap(before[i], after[j]));
        double like = likeness(before[i], after[j], shared[i][j]);
        // Of two equal parts a room keeps the one its name stands in.
        if (!rooms[i].empty() && contains(after[j].ring, namePoint(*was.rooms.find(rooms[i][0]))))
          like += 0.01;
        if (like > kSameArea) pairs.push_back({like, i, j});
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.likeness > b.likeness; });
    afterOf.assign(before.size(), kNone);
    beforeOf.assign(after.size(), kNone);
    for (const Pair& pair : pairs) {
      if (afterOf[pair.before] != kNone || beforeOf[pair.after] != kNone) continue;
      afterOf[pair.before] = pair.after;
      beforeOf[pair.after] = pair.before;
    }
  }

  bool partOf(std::size_t old, std::size_t now) const {
    return shared[old][now] > kSeveral * after[now].size;
  }
  bool wentInto(std::size_t old, std::size_t now) const {
    return shared[old][now] > kSeveral * before[old].size;
  }
};

// An area is covered by a room unless that fills one that this lies in like an island.
bool covered(const Home& home, LevelId level, const Area& found, const std::vector<Area>& areas) {
  const Regions ground{{found.ring, {}}};
  return std::any_of(home.rooms.begin(), home.rooms.end(), [&](const auto& entry) {
    const Room& room = *entry.second;
    if (room.level != level || !bounds(room.points).overlaps(found.box)) return false;
    if (area(intersect(repair(room.points), ground)) <= kSeveral * found.size) return false;
    return fills(room, found) || std::none_of(areas.begin(), areas.end(), [&](const Area& other) {
             return other.size > found.size && fills(room, other);
           });
  });
}

RoomId addTo(Home& home, LevelId level, const Polygon& ring, const std::string& name, const Room* like) {
  Room room;
  if (like) {
    room = *like;
    room.nameOffset = room.areaOffset = {};
    room.nameAngle = room.areaAngle = 0;
  }
  room.level = level;
  room.name = name;
  room.points = ring;
  const auto id = home.newId<RoomId>();
  home.rooms.set(id, std::move(room));
  return id;
}

// Rooms that fill no area but were drawn to the corners of walls keep to these.
void carryCorners(const Home& before, Home& next, LevelId level, const Matching& match) {
  std::set<RoomId> filling;
  for (const auto& rooms : match.rooms) filling.insert(rooms.begin(), rooms.end());
  std::optional<Anchors> anchors;  // most levels have no such room
  for (const auto& [id, room] : next.rooms) {
    if (room->level != level || filling.contains(id)) continue;
    const Room* was = before.rooms.find(id);
    if (!was || was->points != room->points) continue;
    if (!anchors) anchors.emplace(before, next);
    Room moved = *room;
    for (Vec2& p : moved.points)
      if (const auto place = anchors->wallCorner(level, p)) p = *place;
    if (moved.points != room->points) next.rooms.set(id, std::move(moved));
  }
}

}  // namespace

Home followWalls(const Home& before, const Home& after, LevelId level, bool newRooms,
                 const std::string& name) {
  if (&before.walls.chunks() == &after.walls.chunks() || before.walls == after.walls) return after;
  const Matching match(before, after, level);
  Home next = after;
  std::set<std::size_t> merged;
  for (std::size_t j = 0; j < match.after.size(); ++j) {
    // Rooms whose area went into this one.
    const std::size_t heir = match.beforeOf[j];
    for (std::size_t i = 0; i < match.before.size(); ++i)
      if (i != heir && match.afterOf[i] == kNone && !match.rooms[i].empty() && match.wentInto(i, j))
        merged.insert(j);
    if (heir == kNone || merged.contains(j)) continue;
    for (const RoomId id : match.rooms[heir]) {
      const Room *was = before.rooms.find(id), *is = after.rooms.find(id);
      if (!is || is->points != was->points || is->points == match.after[j].ring) continue;
      if (match.before[heir].ring == match.after[j].ring) continue;
      Room room = *is;
      room.points = match.after[j].ring;
      next.rooms.set(id, std::move(room));
    }
  }
  carryCorners(before, next, level, match);
  if (!newRooms) return next;
  for (std::size_t j = 0; j < match.after.size(); ++j) {
    if (merged.contains(j)) continue;
    const std::size_t heir = match.beforeOf[j];
    if (heir != kNone) {
      // An area without a room stays so, unless it was cut in two just now.
      if (!match.rooms[heir].empty()) continue;
      bool cut = false;
      for (std::size_t other = 0; other < match.after.size(); ++other)
        cut = cut || (match.beforeOf[other] == kNone && match.partOf(heir, other));
      if (!cut) continue;
    }
    if (covered(next, level, match.after[j], match.after)) continue;
    const Room* like = nullptr;
    for (std::size_t i = 0; i < match.before.size(); ++i)
      if (!match.rooms[i].empty() && match.partOf(i, j) && match.afterOf[i] != kNone)
        like = after.rooms.find(match.rooms[i].front());
    addTo(next, level, match.after[j].ring, name, like);
  }
  return next;
}

RoomsEdit roomsOfClosedAreas(const Home& home, LevelId level, const std::string& name) {
  RoomsEdit edit{home, {}};
  const std::vector<Area> areas = areasOf(home, level);
  for (const Area& found : areas)
    if (!covered(edit.home, level, found, areas))
      edit.rooms.push_back(addTo(edit.home, level, found.ring, name, nullptr));
  return edit;
}

}  // namespace idap
