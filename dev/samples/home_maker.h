// What the makers of sample homes share: walls, rooms and openings with finishes, and furniture from the
// built-in catalog, on the floor, against a wall or on a table. Metres; the plan's y is north.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "catalog/catalog.h"
#include "model/home.h"

namespace idap::samples {

constexpr double kSouth = 0, kEast = kPi / 2, kNorth = kPi,
                 kWest = -kPi / 2;  // where a piece's front looks to

class HomeMaker {
 public:
  HomeMaker(const char* name, double height);

  Home take() { return std::move(home_); }

  // Walls with the room on their left.
  WallId wall(Vec2 from, Vec2 to, double thickness, const char* left, const char* right);
  // Four walls, joined, around an interior from (0,0) to (width,depth).
  struct Shell {
    WallId south, east, north, west;
  };
  Shell shell(double width, double depth, double thickness, const char* inside, const char* outside);
  void join(WallId first, WallId second);  // first's end to second's start
  void paint(WallId wall, const char* left, const char* right = nullptr);

  void room(const char* name, Polygon points, const char* floor);

  // An opening whose middle is at that place of a wall; front: where the room that it opens into lies.
  void opening(const char* id, WallId host, Vec2 at, double front, double sill, Vec2 size);

  // On the floor, or with its base at a height; what hangs from the ceiling does so.
  FurnitureId put(const char* id, Vec2 at, double front = kSouth, double height = -1, Vec3 size = {});
  // The middle of its back at a point of a wall's face. Pictures and the like keep the catalog's height.
  FurnitureId against(const char* id, Vec2 at, double front, double height = -1, Vec3 size = {});
  void finish(FurnitureId id, const char* slot, const char* material);
  void finish(FurnitureId id, const char* slot, Color color);

  void camera(const char* name, Vec3 eye, Vec3 target, double fieldOfViewDegrees);

 private:
  CatalogPiecePtr find(const std::string& id) const;

  Catalog catalog_;
  Home home_;
  double height_;
};

Finish material(const char* id);

}  // namespace idap::samples
