#include "model/edits/piece_edits.h"

#include "base/error.h"
#include "model/edits/table_edits.h"

namespace idap {

namespace {

template <class F>
Home changeRoom(const Home& home, RoomId id, F change) {
  const Room* room = home.rooms.find(id);
  if (!room) throw InvalidHome("room " + std::to_string(id.value) + " does not exist");
  Home next = home;
  Room copy = *room;
  change(copy.points);
  next.rooms.set(id, std::move(copy));
  return next;
}

[[noreturn]] void noSuchPoint(RoomId id, std::size_t index) {
  throw InvalidHome("room " + std::to_string(id.value) + " has no point " + std::to_string(index));
}

}  // namespace

FurnitureEdit addFurniture(const Home& home, Furniture furniture) {
  Home next = home;
  const auto id = next.newId<FurnitureId>();
  next.furniture.set(id, std::move(furniture));
  return {std::move(next), id};
}

OpeningEdit addOpening(const Home& home, Opening opening) {
  Home next = home;
  const auto id = next.newId<OpeningId>();
  next.openings.set(id, std::move(opening));
  return {std::move(next), id};
}

Home changePieces(const Home& home, const Elements& elements, const std::function<void(Piece&)>& change) {
  const Elements all = withGroups(home, elements);
  Home next = home;
  changeEach(next.openings, all.openings, change);
  changeEach(next.furniture, all.furniture, change);
  return next;
}

Home changeFurniture(const Home& home, const Elements& elements,
                     const std::function<void(Furniture&)>& change) {
  Home next = home;
  changeEach(next.furniture, withGroups(home, elements).furniture, change);
  return next;
}

Home moveRoomPoint(const Home& home, RoomId id, std::size_t index, Vec2 to) {
  return changeRoom(home, id, [&](Polygon& points) {
    if (index >= points.size()) noSuchPoint(id, index);
    points[index] = to;
  });
}

Home addRoomPoint(const Home& home, RoomId id, std::size_t at, Vec2 point) {
  return changeRoom(home, id, [&](Polygon& points) {
    if (at > points.size()) noSuchPoint(id, at);
    points.insert(points.begin() + static_cast<std::ptrdiff_t>(at), point);
  });
}

Home removeRoomPoint(const Home& home, RoomId id, std::size_t index) {
  return changeRoom(home, id, [&](Polygon& points) {
    if (index >= points.size()) noSuchPoint(id, index);
    if (points.size() <= 3) throw InvalidHome("a room needs three points");
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
  });
}

Home makeRoomHome(double x, double y, double z, double wallThickness, std::string roomName) {
  Home home;
  home.wallHeight = z;
  home.site.compassPosition = {-1.2, -1.2};  // clear of the walls and their dimensions
  const double h = wallThickness / 2;
  const Vec2 corners[] = {{-h, -h}, {x + h, -h}, {x + h, y + h}, {-h, y + h}};
  WallId ids[4];
  for (WallId& id : ids) id = home.newId<WallId>();
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.start = corners[i];
    wall.end = corners[(i + 1) % 4];
    wall.thickness = wallThickness;
    wall.heightAtStart = wall.heightAtEnd = z;
    wall.neighbourAtStart = ids[(i + 3) % 4];
    wall.neighbourAtEnd = ids[(i + 1) % 4];
    home.walls.set(ids[i], wall);
  }
  Room room;
  room.name = std::move(roomName);
  room.points = {{0, 0}, {x, 0}, {x, y}, {0, y}};
  home.rooms.set(home.newId<RoomId>(), std::move(room));
  return home;
}

}  // namespace idap
