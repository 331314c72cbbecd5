// The home as a value: a copy is a few pointers, and shares all that was not changed. Metres, radians, Z up;
// the plan's x runs right, y up the page.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "base/bytes.h"
#include "model/annotation.h"
#include "model/camera.h"
#include "model/furniture.h"
#include "model/ids.h"
#include "model/level.h"
#include "model/opening.h"
#include "model/picture.h"
#include "model/room.h"
#include "model/site.h"
#include "model/table.h"
#include "model/wall.h"

namespace idap {

// Files that came with the home (models, textures, pictures) by path in its archive
// ("models/chair/chair.obj").
using Assets = std::map<std::string, SharedBytes>;

struct Background {  // a scanned plan under the drawing of a level
  std::string asset;
  double scale = 0.01;  // m a pixel
  Vec2 origin;
  bool visible = true;
  friend bool operator==(const Background&, const Background&) = default;
};

struct Home {
  std::string name;
  std::string title;  // on prints
  std::string notes;
  std::string currency = "EUR";
  double wallHeight = 2.5;  // m, for new walls
  Site site;
  Environment environment;

  Table<LevelId, Level> levels;  // none: one storey at elevation 0
  Table<WallId, Wall> walls;
  Table<RoomId, Room> rooms;
  Table<OpeningId, Opening> openings;
  Table<FurnitureId, Furniture> furniture;
  Table<GroupId, Group> groups;
  Table<CameraId, Camera> cameras;  // stored points of view, in order of id
  std::optional<Camera> observer;   // where the person in the home stood when the file was saved
  std::optional<Camera> aerial;     // the view from above of that moment
  Table<DimensionId, Dimension> dimensions;
  Table<LabelId, Label> labels;
  Table<PolylineId, Polyline> polylines;
  Table<PictureId, Picture> pictures;  // the gallery, in the order in which they were made

  std::map<LevelId, Background> backgrounds;  // LevelId{} for a home without levels
  std::map<std::string, std::string> properties;
  std::shared_ptr<const Assets> assets = std::make_shared<const Assets>();

  std::uint64_t nextId = 1;

  template <class IdType>
  IdType newId() {
    return IdType{nextId++};
  }

  friend bool operator==(const Home&, const Home&);
};

// The level's elevation; 0 for none or an unknown one.
double elevationOf(const Home& home, LevelId level);
// False when the piece itself, its level, or a group above it is hidden.
bool isShown(const Home& home, const Piece& piece);

}  // namespace idap
