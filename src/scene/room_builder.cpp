#include "scene/room_builder.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "base/error.h"
#include "geometry/svg_path.h"
#include "scene/sloped_ceiling.h"

namespace idap {

namespace {

constexpr double kUnderWall = 0.02;  // m that floors and ceilings reach into walls
constexpr double kGap = 0.04;        // m; rooms drawn up to twice this off their walls are meant to touch
constexpr double kBelowSlab =
    0.002;                          // m that a ceiling hangs below wall tops and slabs, never in their plane
constexpr double kNearWall = 0.15;  // m; corners this near a wall take its height
constexpr double kLowestFullWall = 1.8;  // m; lower ones are parapets
constexpr double kLeastArea = 1e-5;      // m2

Regions withoutSlivers(Regions regions) {
  std::erase_if(regions, [](const Region& r) { return signedArea(r.outer) < kLeastArea; });
  return regions;
}

bool inside(const Regions& regions, Vec2 p) {
  for (const Region& r : regions) {
    if (!contains(r.outer, p)) continue;
    if (std::none_of(r.holes.begin(), r.holes.end(), [&](const Polygon& h) { return contains(h, p); })) {
      return true;
    }
  }
  return false;
}

void append(Regions& all, const Regions& more) { all.insert(all.end(), more.begin(), more.end()); }

constexpr double kFar = 8 * kGap;  // m from a room: walls further away change nothing of it

bool isNear(const WallSolid& wall, const Box2& around) {
  return wall.box.min.x < around.max.x + kFar && wall.box.max.x > around.min.x - kFar &&
         wall.box.min.y < around.max.y + kFar && wall.box.max.y > around.min.y - kFar;
}

// around: only walls near it; none: all.
std::vector<Polygon> wallOutlines(const std::vector<WallSolid>& walls, std::size_t storey, double reaching,
                                  const std::optional<Box2>& around = {}) {
  std::vector<Polygon> outlines;
  for (const WallSolid& wall : walls) {
    if (wall.storey != storey || (around && !isNear(wall, *around))) continue;
    const double top = wall.floor + wall.raised + std::max(wall.wall->heightAtStart, wall.wall->heightAtEnd);
    if (top >= reaching) outlines.push_back(wall.polygon);
  }
  return outlines;
}

// The parts of walls that a floor or ceiling reaches into.
Regions margin(const Regions& plan, const Regions& walls, double reach) {
  return withoutSlivers(intersect(buffer(plan, reach), walls));
}

double distanceToWall(const WallSolid& wall, Vec2 p) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < wall.polygon.size(); ++i) {
    const Vec2 a = wall.polygon[i], d = wall.polygon[(i + 1) % wall.polygon.size()] - a;
    const double l2 = dot(d, d);
    const double t = l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0;
    nearest = std::min(nearest, length(p - a - d * t));
  }
  return contains(wall.polygon, p) ? 0 : nearest;
}

double fullHeight(const WallSolid& wall) {
  return std::max(wall.wall->heightAtStart, wall.wall->heightAtEnd);
}

}  // namespace

std::vector<StairHole> stairHoles(const Home& home, const std::vector<Storey>& storeys) {
  std::vector<StairHole> holes;
  for (const auto& [id, piece] : home.furniture) {
    if (piece->staircaseCutOut.empty() || !isShownOn(home, storeys, *piece)) continue;
    std::vector<Polygon> rings;
    try {
      rings = parseSvgPath(piece->staircaseCutOut);
    } catch (const ParseError&) {
      continue;
    }
    for (Polygon& ring : rings) {
      for (Vec2& p : ring) {
        Vec2 q{(p.x - 0.5) * piece->size.x, (0.5 - p.y) * piece->size.y};
        if (piece->mirrored) q.x = -q.x;
        p = rotated(q, piece->angle) + Vec2{piece->position.x, piece->position.y};
      }
    }
    StairHole hole;
    hole.region = unite(rings);
    hole.bottom = elevationOf(home, piece->level) + piece->position.z;
    hole.top = hole.bottom + piece->size.z;
    if (!hole.region.empty()) holes.push_back(std::move(hole));
  }
  return holes;
}

RoomBuilder::RoomBuilder(const Home& home, const std::vector<Storey>& storeys,
                         const std::vector<WallSolid>& walls, const std::vector<std::vector<WallCut>>& cuts,
                         bool ceilings, StructureMemo* known)
    : storeys_(storeys), walls_(walls), cuts_(cuts), holes_(stairHoles(home, storeys)), ceilings_(ceilings) {
  StructureMemo none;
  StructureMemo& memo = known ? *known : none;
  std::vector<std::pair<RoomId, std::shared_ptr<const idap::Room>>> drawn(home.rooms.begin(),
                                                                          home.rooms.end());
  std::vector<std::optional<Room>> plans(drawn.size());
  tbb::parallel_for(std::size_t{0}, drawn.size(),
                    [&](std::size_t i) { plans[i] = planOf(drawn[i].first, drawn[i].second, memo); });
  for (std::optional<Room>& plan : plans)
    if (plan) rooms_.push_back(std::move(*plan));
  layFloors(memo);
  layDoorsteps(memo);
  findCeilings();
}

std::optional<RoomBuilder::Room> RoomBuilder::planOf(RoomId id, const std::shared_ptr<const idap::Room>& room,
                                                     StructureMemo& memo) const {
  const auto storey = std::ranges::find(storeys_, room->level, &Storey::id);
  if (storey == storeys_.end()) return std::nullopt;
  Room r;
  r.id = id;
  r.room = room;
  r.storey = static_cast<std::size_t>(storey - storeys_.begin());
  const std::vector<Polygon> outlines = wallOutlines(walls_, r.storey, -1e300, bounds(room->points));
  r.plan = memo.regions.get(MemoKey('p').add(room->points).add(outlines).take(), [&] {
    Regions plan = repair(room->points);
    if (plan.empty()) return plan;
    const Regions wallsHere = unite(outlines);
    if (!wallsHere.empty()) {
      // A narrow gap between the drawn outline and a wall is closed.
      const Regions closed = buffer(buffer(unite(plan, wallsHere), kGap), -kGap);
      plan = unite(plan, intersect(closed, buffer(plan, 2 * kGap)));
      plan = subtract(plan, wallsHere);
    }
    return withoutSlivers(std::move(plan));
  });
  if (r.plan.empty()) return std::nullopt;
  r.box = bounds(r.plan);
  return r;
}

// Floors and ceilings reach into the walls of a storey, but never through the thinnest.
double RoomBuilder::reachUnderWalls(std::size_t storey) const {
  double reach = kUnderWall;
  for (const WallSolid& wall : walls_) {
    if (wall.storey == storey) reach = std::min(reach, 0.4 * wall.wall->thickness);
  }
  return reach;
}

void RoomBuilder::layFloors(StructureMemo& memo) {
  std::vector<Regions> holes(storeys_.size());
  std::vector<double> reach(storeys_.size());
  for (std::size_t s = 0; s < storeys_.size(); ++s) {
    const double z = storeys_[s].elevation;
    for (const StairHole& hole : holes_) {
      if (hole.bottom < z - 0.05 && hole.top >= z - 0.05) append(holes[s], hole.region);
    }
    reach[s] = reachUnderWalls(s);
  }
  const auto laid = [&](std::size_t i) { return rooms_[i].room->floorVisible; };
  const auto beside = [&](const Room& a, const Room& b) {
    Box2 near = a.box;
    near.min = near.min - Vec2{kFar, kFar}, near.max = near.max + Vec2{kFar, kFar};
    return a.storey == b.storey && near.overlaps(b.box);
  };
  // Of rooms that overlap the later one shows.
  tbb::parallel_for(std::size_t{0}, rooms_.size(), [&](std::size_t i) {
    Room& room = rooms_[i];
    if (!laid(i)) return;
    Regions taken = holes[room.storey];
    for (std::size_t j = i + 1; j < rooms_.size(); ++j) {
      if (laid(j) && beside(room, rooms_[j])) append(taken, rooms_[j].plan);
    }
    if (taken.empty()) {
      room.floor = room.plan;
    } else {
      room.floor = memo.regions.get(MemoKey('f').add(room.plan).add(taken).take(),
                                    [&] { return withoutSlivers(subtract(room.plan, taken)); });
    }
  });
  // What each would cover under the walls; where two would, the later one does.
  std::vector<Regions> under(rooms_.size());
  tbb::parallel_for(std::size_t{0}, rooms_.size(), [&](std::size_t i) {
    const Room& room = rooms_[i];
    if (room.floor.empty()) return;
    const std::vector<Polygon> walls = wallOutlines(walls_, room.storey, -1e300, room.box);
    if (walls.empty()) return;
    Regions taken = holes[room.storey];
    for (std::size_t j = 0; j < rooms_.size(); ++j) {
      if (laid(j) && beside(room, rooms_[j])) append(taken, rooms_[j].floor);
    }
    const double far = reach[room.storey];
    under[i] = memo.regions.get(MemoKey('u').add(room.floor).add(walls).add(far).add(taken).take(), [&] {
      return withoutSlivers(subtract(margin(room.floor, unite(walls), far), taken));
    });
  });
  const std::vector<Regions> wanted = under;
  tbb::parallel_for(std::size_t{0}, rooms_.size(), [&](std::size_t i) {
    if (under[i].empty()) return;
    Regions taken;
    for (std::size_t j = i + 1; j < rooms_.size(); ++j) {
      if (beside(rooms_[i], rooms_[j])) append(taken, wanted[j]);
    }
    rooms_[i].floor =
        memo.regions.get(MemoKey('w').add(rooms_[i].floor).add(under[i]).add(taken).take(), [&] {
          if (!taken.empty()) under[i] = withoutSlivers(subtract(under[i], taken));
          return unite(rooms_[i].floor, under[i]);
        });
  });
}

// The floor goes on through doors: to the middle of the wall from either side.
void RoomBuilder::layDoorsteps(StructureMemo& memo) {
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const WallSolid& wall = walls_[w];
    for (const WallCut& cut : cuts_[w]) {
      const OpeningCut& o = *cut.opening;
      if (!o.atFloor || o.storey != wall.storey) continue;
      const double u0 = o.box.min.x - 0.003, u1 = o.box.max.x + 0.003, middle = (u0 + u1) / 2;
      double low = 0, high = 0;
      if (!wallSpanAt(wall, o, middle, low, high)) continue;
      const auto roomAt = [&](double v) -> Room* {
        for (auto room = rooms_.rbegin(); room != rooms_.rend(); ++room) {
          if (room->storey == wall.storey && room->room->floorVisible &&
              inside(room->plan, o.plan(middle, v))) {
            return &*room;
          }
        }
        return nullptr;
      };
      Room* before = roomAt(low - 0.05);
      Room* behind = roomAt(high + 0.05);
      if (!before) before = behind;
      if (!behind) behind = before;
      if (!before) continue;
      const double half = (low + high) / 2, reach = high - low + 0.5;
      const auto lay = [&](Room& room, double v0, double v1) {
        const Polygon across{o.plan(u0, v0), o.plan(u1, v0), o.plan(u1, v1), o.plan(u0, v1)};
        const Box2 box = bounds(wall.polygon);
        Regions taken;
        for (const Room& other : rooms_) {
          if (other.storey == wall.storey && bounds(other.floor).overlaps(box)) append(taken, other.floor);
        }
        const Regions step =
            memo.regions.get(MemoKey('s').add(wall.polygon).add(across).add(taken).take(), [&] {
              const Regions inWall = intersect({{wall.polygon, {}}}, {{across, {}}});
              return withoutSlivers(taken.empty() ? inWall : subtract(inWall, taken));
            });
        room.doorsteps.insert(room.doorsteps.end(), step.begin(), step.end());
      };
      if (before == behind) {
        lay(*before, low - reach, high + reach);
      } else {
        lay(*before, low - reach, half);
        lay(*behind, half, high + reach);
      }
    }
  }
}

bool RoomBuilder::touchesSlope(const Room& room) const {
  const auto& points = room.room->points;
  for (const WallSolid& wall : walls_) {
    if (wall.storey != room.storey || wall.flatTop()) continue;
    int near = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      if (distanceToWall(wall, a) < kNearWall) ++near;
      if (distanceToWall(wall, (a + b) / 2) < kNearWall) ++near;
    }
    if (near >= 2) return true;
  }
  return false;
}

// The commonest height of the walls around it, by their length; parapets do not count.
double RoomBuilder::flatCeiling(const Room& room) const {
  const Storey& storey = storeys_[room.storey];
  std::map<double, double> lengths;
  const auto& points = room.room->points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    const int steps = std::clamp(static_cast<int>(length(b - a) / 0.25), 1, 200);
    for (int k = 0; k < steps; ++k) {
      const Vec2 p = a + (b - a) * ((k + 0.5) / steps);
      const WallSolid* nearest = nullptr;
      double distance = kNearWall;
      for (const WallSolid& wall : walls_) {
        if (wall.storey != room.storey || fullHeight(wall) < kLowestFullWall) continue;
        if (p.x < wall.box.min.x - kNearWall || p.x > wall.box.max.x + kNearWall ||
            p.y < wall.box.min.y - kNearWall || p.y > wall.box.max.y + kNearWall) {
          continue;
        }
        const double d = distanceToWall(wall, p);
        if (d < distance) distance = d, nearest = &wall;
      }
      if (nearest) {
        const double height = std::round((nearest->topAt(p) - storey.elevation) * 1000) / 1000;
        lengths[height] += length(b - a) / steps;
      }
    }
  }
  double height = storey.height, longest = 0;
  for (const auto& [h, l] : lengths) {
    if (l > longest + 1e-6) longest = l, height = h;
  }
  double z = storey.elevation + height;
  // Never through the slab of a floor above.
  for (std::size_t s = room.storey + 1; s < storeys_.size(); ++s) {
    const double under = storeys_[s].elevation - storeys_[s].floorThickness;
    if (under > storey.elevation + 1.5 && under < z) {
      for (const Room& above : rooms_) {
        if (above.storey == s && !above.floor.empty() && area(intersect(above.plan, room.plan)) > 0.01)
          z = under;
      }
    }
  }
  return z - kBelowSlab;
}

void RoomBuilder::findCeilings() {
  tbb::parallel_for(std::size_t{0}, rooms_.size(), [&](std::size_t i) {
    rooms_[i].sloped = !rooms_[i].room->ceilingFlat && touchesSlope(rooms_[i]);
    rooms_[i].ceiling = flatCeiling(rooms_[i]);
  });
}

// Does the staircase lead through the ceiling at that height to a storey above?
bool RoomBuilder::goesOn(const StairHole& hole, std::size_t storey, double ceiling) const {
  return storeys_.size() > storey + 1 && hole.bottom < ceiling - 0.05 && hole.top >= ceiling - 0.05;
}

Regions RoomBuilder::ceilingRegion(std::size_t index, StructureMemo& memo) const {
  const Room& room = rooms_[index];
  const std::vector<Polygon> outlines =
      wallOutlines(walls_, room.storey, room.ceiling - 0.1, bounds(room.room->points));
  Regions away;
  for (const StairHole& hole : holes_) {
    if (goesOn(hole, room.storey, room.ceiling)) append(away, hole.region);
  }
  Box2 box = room.box;
  box.add(bounds(room.room->points).min), box.add(bounds(room.room->points).max);
  for (std::size_t j = index + 1; j < rooms_.size(); ++j) {
    const Room& other = rooms_[j];
    if (other.storey == room.storey && other.room->ceilingVisible && !other.sloped &&
        std::abs(other.ceiling - room.ceiling) < 1e-3 && other.box.overlaps(box)) {
      append(away, other.plan);
    }
  }
  const double reach = reachUnderWalls(room.storey);
  const std::string key =
      MemoKey('c').add(room.room->points).add(room.plan).add(outlines).add(reach).add(away).take();
  return memo.regions.get(key, [&] {
    Regions region = repair(room.room->points);
    if (const Regions walls = unite(outlines); !walls.empty()) {
      region = subtract(unite(region, room.plan), walls);
      region = unite(region, margin(region, walls, reach));
    }
    if (!away.empty()) region = subtract(region, away);
    return withoutSlivers(std::move(region));
  });
}

void RoomBuilder::addSlopedCeiling(const Room& room, MeshSink& sink) const {
  const double flat = room.ceiling + kBelowSlab;
  // The height over a corner: that of the lowest wall there, but for parapets beside higher walls.
  const auto heightAt = [&](Vec2 p) {
    double sloped = 1e300, lowest = 1e300;
    for (const WallSolid& wall : walls_) {
      if (wall.storey != room.storey || distanceToWall(wall, p) > kNearWall) continue;
      const double top = wall.topAt(p);
      if (!wall.flatTop()) sloped = std::min(sloped, top);
    }
    for (const WallSolid& wall : walls_) {
      if (wall.storey != room.storey || distanceToWall(wall, p) > kNearWall) continue;
      const double top = wall.topAt(p);
      const bool parapet = sloped < 1e300 ? top < sloped - 0.5 : wall.flatTop() && fullHeight(wall) < 0.5;
      if (!parapet) lowest = std::min(lowest, top);
    }
    return (lowest < 1e300 ? lowest : flat) - kBelowSlab;
  };
  // Ridges end where walls meet along the outline.
  std::vector<Vec2> breaks;
  for (const WallSolid& wall : walls_) {
    if (wall.storey != room.storey) continue;
    breaks.push_back(wall.wall->start);
    breaks.push_back(wall.wall->end);
  }
  const Regions outline = repair(room.room->points);
  for (const Region& region : outline) {
    const Mesh3 mesh = slopedCeiling(region.outer, breaks, heightAt);
    for (const auto& t : mesh.triangles) {
      const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
      const Vec3 across = cross(c - a, b - a);
      if (length(across) < 1e-12) continue;
      const Vec3 n = normalized(across);  // looks down
      Regions holes;
      for (const StairHole& hole : holes_) {
        if (goesOn(hole, room.storey, std::min({a.z, b.z, c.z})))
          holes.insert(holes.end(), hole.region.begin(), hole.region.end());
      }
      if (!holes.empty() && std::abs(n.z) > 1e-6) {
        sink.face(subtract({{{{a.x, a.y}, {b.x, b.y}, {c.x, c.y}}, {}}}, holes), kRoomCeiling, [&](Vec2 p) {
          const double z = a.z - (n.x * (p.x - a.x) + n.y * (p.y - a.y)) / n.z;
          return MeshSink::Vertex{{p.x, p.y, z}, n, p};
        });
        continue;
      }
      const auto i = sink.vertex({a, n, {a.x, a.y}});
      sink.vertex({c, n, {c.x, c.y}});
      sink.vertex({b, n, {b.x, b.y}});
      sink.triangle(i, i + 1, i + 2, kRoomCeiling);
    }
  }
}

std::shared_ptr<const Mesh> RoomBuilder::buildFloor(std::size_t index, Vec3 centre,
                                                    StructureMemo* memo) const {
  const Room& room = rooms_[index];
  const Storey& storey = storeys_[room.storey];
  const auto build = [&]() -> std::shared_ptr<const Mesh> {
    MeshSink sink(centre);
    if (!room.floor.empty()) {
      sink.horizontal(room.floor, storey.elevation, true, kRoomFloor);
      if (storey.floorThickness > 1e-4) {
        const double under = storey.elevation - storey.floorThickness;
        sink.horizontal(room.floor, under, false, kRoomUnderside);
        sink.sides(room.floor, under, storey.elevation, kRoomUnderside);
      }
    }
    if (!room.doorsteps.empty()) sink.horizontal(room.doorsteps, storey.elevation, true, kRoomFloor);
    return sink.empty() ? nullptr : sink.take();
  };
  if (!memo) return build();
  MemoKey key('F');
  key.add(room.floor).add(room.doorsteps).add(storey.elevation).add(storey.floorThickness);
  return memo->meshes.get(key.add(Vec2{centre.x, centre.y}).add(centre.z).take(), build);
}

std::shared_ptr<const Mesh> RoomBuilder::buildCeiling(std::size_t index, Vec3 centre,
                                                      StructureMemo* memo) const {
  const Room& room = rooms_[index];
  if (!ceilings_ || !room.room->ceilingVisible) return nullptr;
  MeshSink sink(centre);
  if (room.sloped) {
    addSlopedCeiling(room, sink);
    return sink.empty() ? nullptr : sink.take();
  }
  StructureMemo none;
  const Regions region = ceilingRegion(index, memo ? *memo : none);
  const auto build = [&]() -> std::shared_ptr<const Mesh> {
    sink.horizontal(region, room.ceiling, false, kRoomCeiling);
    return sink.empty() ? nullptr : sink.take();
  };
  if (!memo) return build();
  const std::string key =
      MemoKey('C').add(region).add(room.ceiling).add(Vec2{centre.x, centre.y}).add(centre.z).take();
  return memo->meshes.get(key, build);
}

bool RoomBuilder::isIndoors(std::size_t storey, Vec2 point) const {
  for (const Room& room : rooms_) {
    if (room.storey == storey && room.room->ceilingVisible && inside(room.plan, point)) return true;
    // Below the floor of a room further up.
    if (room.storey > storey && !room.floor.empty() && inside(room.floor, point)) return true;
    // An open gallery: a ceiling over it further up.
    if (room.storey > storey && room.room->ceilingVisible && inside(room.plan, point)) return true;
  }
  return false;
}

std::optional<double> RoomBuilder::ceilingOver(std::size_t storey, Vec2 point) const {
  for (const Room& room : rooms_) {
    if (room.storey == storey && room.room->ceilingVisible && !room.sloped && inside(room.plan, point)) {
      return room.ceiling;
    }
  }
  return std::nullopt;
}

Regions RoomBuilder::footprint(std::size_t storey) const {
  Regions result = unite(wallOutlines(walls_, storey, -1e300));
  for (const Room& room : rooms_) {
    if (room.storey == storey && !room.floor.empty()) result = unite(result, room.floor);
  }
  return result;
}

}  // namespace idap
