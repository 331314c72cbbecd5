#include "home_maker.h"

#include "base/error.h"

namespace idap::samples {

Finish material(const char* id) {
  Finish finish;
  finish.material = id;
  return finish;
}

HomeMaker::HomeMaker(const char* name, double height)
    : catalog_(std::vector<std::filesystem::path>{}), height_(height) {
  home_.name = name;
  home_.wallHeight = height;
  home_.site = {.latitude = 13.7563 * kPi / 180,
                .longitude = 100.5018 * kPi / 180,
                .timeZone = "Asia/Bangkok",
                .time = 1797840000000,  // 2026-12-21 15:00 there
                .compassPosition = {-1.2, -1.2},
                .compassDiameter = 0.8};
  home_.environment.ground = {.color = Color{0.52f, 0.58f, 0.42f}};
}

WallId HomeMaker::wall(Vec2 from, Vec2 to, double thickness, const char* left, const char* right) {
  Wall w;
  w.start = from;
  w.end = to;
  w.thickness = thickness;
  w.heightAtStart = w.heightAtEnd = height_;
  w.left.finish = material(left);
  w.right.finish = material(right);
  const auto id = home_.newId<WallId>();
  home_.walls.set(id, w);
  return id;
}

HomeMaker::Shell HomeMaker::shell(double width, double depth, double thickness, const char* inside,
                                  const char* outside) {
  const double o = thickness / 2;
  const Vec2 corner[] = {{-o, -o}, {width + o, -o}, {width + o, depth + o}, {-o, depth + o}};
  WallId ids[4];
  for (int k = 0; k < 4; ++k) ids[k] = wall(corner[k], corner[(k + 1) % 4], thickness, inside, outside);
  const Baseboard baseboard{.thickness = 0.012, .height = 0.08, .finish = material("white-lacquer")};
  for (int k = 0; k < 4; ++k) {
    Wall w = *home_.walls.find(ids[k]);
    w.neighbourAtEnd = ids[(k + 1) % 4];
    w.neighbourAtStart = ids[(k + 3) % 4];
    w.left.baseboard = baseboard;
    home_.walls.set(ids[k], w);
  }
  return {ids[0], ids[1], ids[2], ids[3]};
}

void HomeMaker::join(WallId first, WallId second) {
  Wall a = *home_.walls.find(first), b = *home_.walls.find(second);
  a.neighbourAtEnd = second;
  b.neighbourAtStart = first;
  home_.walls.set(first, a);
  home_.walls.set(second, b);
}

void HomeMaker::paint(WallId id, const char* left, const char* right) {
  Wall w = *home_.walls.find(id);
  if (left) w.left.finish = material(left);
  if (right) w.right.finish = material(right);
  home_.walls.set(id, w);
}

void HomeMaker::room(const char* name, Polygon points, const char* floor) {
  Room r;
  r.name = name;
  r.points = std::move(points);
  r.floor = material(floor);
  r.ceiling = material("white-paint");
  home_.rooms.set(home_.newId<RoomId>(), r);
}

CatalogPiecePtr HomeMaker::find(const std::string& id) const {
  CatalogPiecePtr piece = catalog_.find("idap/" + id);
  if (!piece) throw Error("the catalog has no piece idap/" + id);
  return piece;
}

void HomeMaker::opening(const char* id, WallId host, Vec2 at, double front, double sill, Vec2 size) {
  Opening o = makeOpening(*find(id), {at.x, at.y, 0}, front);
  o.position.z = sill;
  o.size = {size.x, o.size.y, size.y};
  o.wall = host;
  home_.openings.set(home_.newId<OpeningId>(), o);
}

FurnitureId HomeMaker::put(const char* id, Vec2 at, double front, double height, Vec3 size) {
  const CatalogPiecePtr piece = find(id);
  Furniture f = makeFurniture(*piece, {at.x, at.y, 0}, front);
  if (height >= 0) f.position.z = height;
  for (int axis = 0; axis < 3; ++axis) {
    if (size[axis] > 0) f.size[axis] = size[axis];
  }
  if (piece->ceilingMounted) f.position.z = height_ - f.size.z;
  const auto newId = home_.newId<FurnitureId>();
  home_.furniture.set(newId, f);
  return newId;
}

FurnitureId HomeMaker::against(const char* id, Vec2 at, double front, double height, Vec3 size) {
  const double depth = size.y > 0 ? size.y : find(id)->size.y;
  const double out = depth / 2 + 0.015;  // past the baseboard
  return put(id, {at.x + std::sin(front) * out, at.y - std::cos(front) * out}, front, height, size);
}

void HomeMaker::finish(FurnitureId id, const char* slot, const char* materialId) {
  Furniture f = *home_.furniture.find(id);
  f.slotFinishes[slot] = material(materialId);
  home_.furniture.set(id, f);
}

void HomeMaker::finish(FurnitureId id, const char* slot, Color color) {
  Furniture f = *home_.furniture.find(id);
  f.slotFinishes[slot].color = color;
  home_.furniture.set(id, f);
}

void HomeMaker::camera(const char* name, Vec3 eye, Vec3 target, double fieldOfViewDegrees) {
  Camera c;
  c.name = name;
  c.eye = eye;
  const Vec3 d = target - eye;
  c.yaw = std::atan2(-d.x, d.y);
  c.pitch = std::atan2(-d.z, std::hypot(d.x, d.y));
  c.fieldOfView = fieldOfViewDegrees * kPi / 180;
  home_.cameras.set(home_.newId<CameraId>(), c);
}

}  // namespace idap::samples
