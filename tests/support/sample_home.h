// Homes for tests: one that uses every field with a value of its own, and big regular ones.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/home.h"

namespace idap::test {

inline SharedBytes bytesOf(std::string_view text) {
  Bytes bytes;
  for (const char c : text) bytes.push_back(std::byte(c));
  return std::make_shared<const Bytes>(std::move(bytes));
}

inline Finish fullFinish() {
  Finish finish;
  finish.material = "oak";
  finish.color = Color{0.1f, 0.2f, 0.7f};
  finish.texture = TextureRef{"textures/wood.jpg", {0.3, 0.4}, {0.05, -0.06}, 0.7, true};
  finish.roughness = 0.35;
  finish.metalness = 0.1;
  finish.transmission = 0.25;
  return finish;
}

inline TextStyle fullStyle() {
  TextStyle style;
  style.font = "DejaVu Sans";
  style.size = 0.27;
  style.bold = style.italic = true;
  style.alignment = TextAlignment::Right;
  style.color = Color{0.9f, 0.3f, 0.33f};
  return style;
}

inline void fill(Piece& piece, LevelId level, GroupId group) {
  piece.level = level;
  piece.group = group;
  piece.name = "Stuhl \"Größe\" \xE6\xA4\x85";
  piece.description = "two\nlines";
  piece.model.catalogId = "idap/chair-windsor";
  piece.model.asset = "models/chair/chair.obj";
  piece.model.parameters = {{"doors", 3}, {"top-thickness", 0.035}};
  piece.model.rotation = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}};
  piece.model.backFacesShown = true;
  piece.model.smoothed = false;
  piece.position = {1.0 / 3, 2.1, 0.45};
  piece.size = {0.51, 0.62, 0.93};
  piece.angle = 0.1;
  piece.pitch = 0.2;
  piece.roll = 0.3;
  piece.mirrored = true;
  piece.finish = fullFinish();
  piece.slotFinishes = {{"seat", fullFinish()}, {"legs", plain(Color{0.5f, 0.25f, 0.125f})}};
  piece.visible = false;
  piece.nameVisible = true;
  piece.locked = true;
  piece.price = 129.99;
  piece.properties = {{"creator", "Somebody"}, {"licence", "CC0"}};
}

// At least one element of each kind, every field different from its default. Valid.
inline Home fullHome() {
  Home home;
  home.name = "Full";
  home.title = "Title";
  home.notes = "Notes with \ttabs\nand \xF0\x9F\x8F\xA0";
  home.currency = "CHF";
  home.wallHeight = 2.62;
  home.site = Site{0.9, -0.2, 0.3, "Europe/Berlin", 1'600'000'000'123, {3, 4}, 2, false};
  home.environment.ground = fullFinish();
  home.environment.skyColor = Color{0.2f, 0.4f, 0.8f};
  home.environment.skyTexture = TextureRef{"pictures/sky.jpg", {2, 3}, {}, 0, false};
  home.environment.wallTransparency = 0.4;

  const auto level = home.newId<LevelId>();
  home.levels.set(level, Level{"Upstairs", 2.7, 0.2, 2.4, 3, false, false});
  const auto outer = home.newId<GroupId>(), inner = home.newId<GroupId>();
  home.groups.set(outer, Group{{}, "Dining", true});
  home.groups.set(inner, Group{outer, "Chairs", false});

  const auto first = home.newId<WallId>(), second = home.newId<WallId>();
  Wall wall;
  wall.level = level;
  wall.start = {0.2, 0.3};
  wall.end = {4.1, 0.1};
  wall.arcExtent = 0.5;
  wall.thickness = 0.24;
  wall.heightAtStart = 2.4;
  wall.heightAtEnd = 1.1;
  wall.left = {fullFinish(), Baseboard{0.02, 0.09, fullFinish()}};
  wall.right = {plain(Color{0, 0, 0}), Baseboard{}};
  wall.top = fullFinish();
  wall.neighbourAtStart = wall.neighbourAtEnd = second;
  wall.pattern = "hatchUp";
  home.walls.set(first, wall);
  Wall other;
  other.start = {4.1, 0.1};
  other.end = {4.1, 5};
  other.neighbourAtStart = first;
  home.walls.set(second, other);

  Room room;
  room.level = level;
  room.name = "Kitchen";
  room.points = {{0, 0}, {4, 0}, {4, 3.3}, {0.1, 3}};
  room.floor = fullFinish();
  room.ceiling = plain(Color{0.9f, 0.9f, 0.9f});
  room.floorVisible = room.ceilingVisible = room.areaVisible = false;
  room.ceilingFlat = true;
  room.nameOffset = {0.1, 0.2};
  room.areaOffset = {0.3, 0.4};
  room.nameAngle = 0.5;
  room.areaAngle = 0.6;
  room.nameStyle = fullStyle();
  room.areaStyle = fullStyle();
  home.rooms.set(home.newId<RoomId>(), room);

  Opening window;
  fill(window, level, inner);
  window.kind = OpeningKind::Window;
  window.wall = first;
  window.cutOut = "M0,0 h1 v1 z";
  window.cutsWalls = false;
  window.cutsBothSides = true;
  window.wallThickness = 0.6;
  window.wallDistance = 0.2;
  window.sashes = {Sash{{0.1, 0.2}, 0.5, 0.3, 1.9}, Sash{{0.9, 0.2}, 0.5, 1.2, 2.9}};
  home.openings.set(home.newId<OpeningId>(), window);

  Furniture lamp;
  fill(lamp, level, outer);
  lamp.lamp = Lamp{1234,
                   4000,
                   Color{1, 0.5f, 0.1f},
                   0.7,
                   false,
                   0.6,
                   {LightSource{{0.1, 0.2, 0.3}, 0.05, Color{0, 1, 0}, 2}, LightSource{}}};
  lamp.staircaseCutOut = "M0,0 v1 h0.5 v-1 z";
  lamp.dropOnTopHeight = 0.44;
  home.furniture.set(home.newId<FurnitureId>(), lamp);

  home.cameras.set(home.newId<CameraId>(),
                   Camera{"From the door", {1, 2, 1.7}, 0.4, 0.1, 0.9, Lens::Fisheye, 1'500'000'000'000});
  home.dimensions.set(home.newId<DimensionId>(),
                      Dimension{level, {0.5, 0}, {4, 0}, 0.1, 0.2, -0.5, 0.3, Color{1, 0, 0}, 0.2});
  home.labels.set(home.newId<LabelId>(), Label{level, "Label", {1, 1}, 0.3, 0.4, 0.5, fullStyle()});
  home.polylines.set(home.newId<PolylineId>(), Polyline{level,
                                                        {{0, 0}, {1, 1}, {2, 0}},
                                                        true,
                                                        true,
                                                        0.03,
                                                        LineDash::DashDotDot,
                                                        LineArrow::Disc,
                                                        LineArrow::Open,
                                                        Color{0.3f, 0.6f, 0.9f},
                                                        0.9});
  Picture picture;
  picture.name = "By night";
  picture.settings.view = Camera{"Bed", {1, 1, 1.5}, 0.3, 0.2, 1, Lens::Orthographic, 1'500'000'000'001};
  picture.settings.fromAbove = true;
  picture.settings.width = 320;
  picture.settings.height = 200;
  picture.settings.classic = true;
  picture.settings.samples = 0;
  picture.settings.seconds = 12.5;
  picture.settings.lamps = PictureLamps::Off;
  picture.made = 1'600'000'000'456;
  picture.samples = 33;
  picture.asset = "pictures/12.png";
  home.pictures.set(home.newId<PictureId>(), picture);
  home.backgrounds = {{level, Background{"pictures/plan.png", 0.0123, {-1, -2}, false}}};
  home.properties = {{"key", "value"}};
  home.assets = std::make_shared<const Assets>(Assets{{"models/chair/chair.obj", bytesOf("v 0 0 0\n")},
                                                      {"models/chair/chair.mtl", bytesOf("newmtl a\n")},
                                                      {"textures/wood.jpg", bytesOf("wood")},
                                                      {"pictures/sky.jpg", bytesOf("sky")},
                                                      {"pictures/12.png", bytesOf("night")},
                                                      {"pictures/plan.png", bytesOf("plan")}});
  home.nextId += 10;
  return home;
}

// A two-room flat of 6 m by 4 m with a door, a window and a table in a group. Valid.
inline Home smallFlat() {
  Home home;
  const Vec2 corners[] = {{0, 0}, {6, 0}, {6, 4}, {0, 4}};
  WallId ids[5];
  for (WallId& id : ids) id = home.newId<WallId>();
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.start = corners[i];
    wall.end = corners[(i + 1) % 4];
    wall.thickness = 0.2;
    wall.neighbourAtStart = ids[(i + 3) % 4];
    wall.neighbourAtEnd = ids[(i + 1) % 4];
    home.walls.set(ids[i], wall);
  }
  Wall middle;
  middle.start = {3, 0};
  middle.end = {3, 4};
  home.walls.set(ids[4], middle);

  Opening door;
  door.name = "Door";
  door.position = {3, 1, 0};
  door.size = {0.9, 0.1, 2.05};
  door.angle = kPi / 2;
  door.wall = ids[4];
  home.openings.set(home.newId<OpeningId>(), door);
  Opening window;
  window.name = "Window";
  window.kind = OpeningKind::Window;
  window.position = {4.5, 0, 0.9};
  window.size = {1.2, 0.2, 1.2};
  window.wall = ids[0];
  home.openings.set(home.newId<OpeningId>(), window);

  const auto group = home.newId<GroupId>();
  home.groups.set(group, Group{{}, "Dining", true});
  Furniture table;
  table.name = "Table";
  table.group = group;
  table.position = {1.5, 2, 0};
  table.size = {1.4, 0.8, 0.75};
  home.furniture.set(home.newId<FurnitureId>(), table);
  return home;
}

// A grid of pieces.
inline Home manyPieces(std::size_t count) {
  Home home;
  Table<FurnitureId, Furniture>::Chunk entries;
  for (std::size_t i = 0; i < count; ++i) {
    Furniture piece;
    piece.name = "Piece " + std::to_string(i);
    piece.position = {double(i % 100), double(i / 100), 0};
    entries.emplace_back(home.newId<FurnitureId>(), std::make_shared<const Furniture>(std::move(piece)));
  }
  home.furniture = Table<FurnitureId, Furniture>::of(std::move(entries));
  return home;
}

}  // namespace idap::test
