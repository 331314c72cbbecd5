// Builds the sample home share/samples/apartment.idap: a two-room apartment of built-in pieces only.
//   ninja -C build/release make_apartment && build/release/dev/samples/make_apartment
//   share/samples/apartment.idap
#include <cstdio>
#include <string>

#include "catalog/catalog.h"
#include "formats/registry.h"

namespace {

using namespace idap;

constexpr double kOuter = 0.3, kInner = 0.1;         // m, wall thickness
constexpr double kWidth = 8.6, kDepth = 5.8;         // m, between the outer walls' centre lines
constexpr double kPartition = 5.2, kBathroom = 2.2;  // m, centre lines of the inner walls
constexpr double kSouth = 0, kEast = kPi / 2, kNorth = kPi,
                 kWest = -kPi / 2;  // where a piece's front looks to

class Apartment {
 public:
  Apartment() : catalog_(std::vector<std::filesystem::path>{}) {}

  Home build() {
    home_.name = "Apartment";
    home_.title = "A two-room apartment";
    home_.site = {.latitude = 13.7563 * kPi / 180,
                  .longitude = 100.5018 * kPi / 180,
                  .timeZone = "Asia/Bangkok",
                  .time = 1797840000000,  // 2026-12-21 15:00 there
                  .compassPosition = {-1.5, kDepth + 1},
                  .compassDiameter = 1};
    home_.environment.ground = {.color = Color{0.52f, 0.58f, 0.42f}};
    buildShell();
    furnishLivingRoom();
    furnishKitchen();
    furnishBedroom();
    furnishBathroom();
    addCameras();
    return std::move(home_);
  }

 private:
  static Finish material(const char* id) {
    Finish finish;
    finish.material = id;
    return finish;
  }

  WallId wall(Vec2 from, Vec2 to, double thickness, const char* left, const char* right) {
    Wall w;
    w.start = from;
    w.end = to;
    w.thickness = thickness;
    w.heightAtStart = w.heightAtEnd = 2.6;
    w.left.finish = material(left);
    w.right.finish = material(right);
    const Baseboard baseboard{.thickness = 0.012, .height = 0.08, .finish = material("white-lacquer")};
    w.left.baseboard = baseboard;
    if (thickness < kOuter) w.right.baseboard = baseboard;
    const auto id = home_.newId<WallId>();
    home_.walls.set(id, w);
    return id;
  }

  void join(WallId a, WallId b) {
    Wall first = *home_.walls.find(a), second = *home_.walls.find(b);
    first.neighbourAtEnd = b;
    second.neighbourAtStart = a;
    home_.walls.set(a, first);
    home_.walls.set(b, second);
  }

  void room(const char* name, Polygon points, const char* floor) {
    Room r;
    r.name = name;
    r.points = std::move(points);
    r.floor = material(floor);
    r.ceiling = material("white-paint");
    home_.rooms.set(home_.newId<RoomId>(), r);
  }

  CatalogPiecePtr find(const std::string& id) const {
    CatalogPiecePtr piece = catalog_.find("idap/" + id);
    if (!piece) throw Error("the catalog has no piece idap/" + id);
    return piece;
  }

  // An opening whose middle is at that place of a wall; inside: where the room lies, as for a piece's front.
  Opening& opening(const char* id, WallId host, Vec2 at, double front, double sill, Vec2 size) {
    static Opening last;
    last = makeOpening(*find(id), {at.x, at.y, 0}, front);
    last.position.z = sill;
    last.size = {size.x, last.size.y, size.y};
    last.wall = host;
    home_.openings.set(home_.newId<OpeningId>(), last);
    return last;
  }

  // Furniture on the floor, or standing at a height.
  FurnitureId put(const char* id, Vec2 at, double front = kSouth, double height = -1, Vec3 size = {}) {
    const CatalogPiecePtr piece = find(id);
    Furniture furniture = makeFurniture(*piece, {at.x, at.y, 0}, front);
    if (height >= 0) furniture.position.z = height;
    for (int axis = 0; axis < 3; ++axis) {
      if (size[axis] > 0) furniture.size[axis] = size[axis];
    }
    if (piece->ceilingMounted) furniture.position.z = 2.6 - furniture.size.z;
    const auto newId = home_.newId<FurnitureId>();
    home_.furniture.set(newId, furniture);
    return newId;
  }

  void finish(FurnitureId id, const char* slot, const char* materialId) {
    Furniture furniture = *home_.furniture.find(id);
    furniture.slotFinishes[slot] = material(materialId);
    home_.furniture.set(id, furniture);
  }

  void camera(const char* name, Vec3 eye, Vec3 target, double fov) {
    Camera c;
    c.name = name;
    c.eye = eye;
    const Vec3 d = target - eye;
    c.yaw = std::atan2(-d.x, d.y);
    c.pitch = std::atan2(-d.z, std::hypot(d.x, d.y));
    c.fieldOfView = fov * kPi / 180;
    home_.cameras.set(home_.newId<CameraId>(), c);
  }

  void buildShell() {
    const char* outside = "cream-paint";
    const WallId south = wall({0, 0}, {kWidth, 0}, kOuter, "warm-white-paint", outside);
    const WallId east = wall({kWidth, 0}, {kWidth, kDepth}, kOuter, "warm-white-paint", outside);
    const WallId north = wall({kWidth, kDepth}, {0, kDepth}, kOuter, "warm-white-paint", outside);
    const WallId west = wall({0, kDepth}, {0, 0}, kOuter, "sage-paint", outside);
    join(south, east);
    join(east, north);
    join(north, west);
    join(west, south);
    const WallId partition =
        wall({kPartition, 0}, {kPartition, kDepth}, kInner, "warm-white-paint", "warm-white-paint");
    wall({kPartition, kBathroom}, {kWidth, kBathroom}, kInner, "dusty-blue-paint", "white-tiles");

    const double o = kOuter / 2, i = kInner / 2;
    room("Living room", {{o, o}, {kPartition - i, o}, {kPartition - i, kDepth - o}, {o, kDepth - o}},
         "oak-herringbone");
    room("Bedroom",
         {{kPartition + i, kBathroom + i},
          {kWidth - o, kBathroom + i},
          {kWidth - o, kDepth - o},
          {kPartition + i, kDepth - o}},
         "light-oak-planks");
    room("Bathroom",
         {{kPartition + i, o}, {kWidth - o, o}, {kWidth - o, kBathroom - i}, {kPartition + i, kBathroom - i}},
         "grey-tiles");

    opening("door-sliding-glass", south, {2.5, 0}, kNorth, 0, {2.6, 2.2});
    opening("window-double", west, {0, 2.1}, kEast, 0.95, {1.5, 1.3});
    opening("window-double", north, {1.7, kDepth}, kSouth, 1.15, {1.3, 1.1});
    opening("window-triple", east, {kWidth, 3.9}, kWest, 0.85, {1.9, 1.4});
    opening("window-single", south, {6.6, 0}, kNorth, 1.4, {0.7, 0.8});
    opening("door-front", north, {4.5, kDepth}, kSouth, 0, {1.0, 2.15});
    opening("door-panelled", partition, {kPartition, 3.35}, kWest, 0, {0.85, 2.05});
    opening("door-panelled", partition, {kPartition, 0.75}, kWest, 0, {0.8, 2.05});
  }

  void furnishLivingRoom() {
    put("rug", {2.1, 2.05}, kEast, -1, {2.6, 1.9, 0});
    put("sofa-three", {0.66, 2.05}, kEast);
    put("table-coffee", {2.0, 2.05}, kEast);
    put("armchair-lounge", {1.75, 3.55}, kSouth + 0.35);
    put("tv-bench", {kPartition - 0.28, 2.05}, kWest);
    put("tv-feet", {kPartition - 0.26, 2.05}, kWest, 0.48);
    put("light-tripod", {0.5, 3.5});
    put("plant-monstera", {0.72, 0.72}, kSouth, -1, {0.9, 0.9, 1.15});
    put("bookcase", {0.33, 4.25}, kEast);
    put("wall-clock", {1.0, kDepth - kOuter / 2 - 0.03}, kSouth, 2.0);
    put("picture-landscape", {kPartition - kInner / 2 - 0.025, 4.75}, kWest, 1.35);
    put("curtain-sheer", {0.95, 0.26}, kNorth, -1, {0.7, 0, 0});
    put("curtain-sheer", {4.05, 0.26}, kNorth, -1, {0.7, 0, 0});
    // Dining
    put("table-pedestal", {3.55, 4.05});
    for (int k = 0; k < 4; ++k) {
      const double a = kPi / 4 + k * kPi / 2;
      put("chair-windsor", {3.55 + 0.72 * std::cos(a), 4.05 + 0.72 * std::sin(a)}, a - kPi / 2);
    }
    put("light-dome", {3.55, 4.05});
    put("plant-tulips", {3.45, 4.15}, kSouth, 0.75);
    put("fruit-bowl", {3.75, 3.85}, kSouth, 0.75);
    put("books-stack", {1.95, 2.25}, 0.4, 0.42);
    put("candles", {2.05, 1.75}, kEast, 0.42);
  }

  void furnishKitchen() {
    const double y = kDepth - kOuter / 2 - 0.32;
    put("fridge", {0.47, y - 0.03});
    put("kitchen-base-drawers", {1.16, y});
    put("kitchen-sink", {1.96, y});
    put("kitchen-hob", {2.66, y});
    put("kitchen-base", {3.26, y});
    put("kitchen-hood", {2.66, kDepth - kOuter / 2 - 0.25}, kSouth, 1.65);
    put("kitchen-wall", {0.47, kDepth - kOuter / 2 - 0.18}, kSouth, 1.95, {0, 0, 0.55});
    put("kitchen-wall", {3.26, kDepth - kOuter / 2 - 0.18}, kSouth, 1.45);
  }

  void furnishBedroom() {
    put("bed-upholstered", {6.9, 4.53});
    put("night-table", {5.66, 5.42});
    put("night-table", {8.14, 5.42});
    put("light-bedside", {5.66, 5.42}, kSouth, 0.55);
    put("light-bedside", {8.14, 5.42}, kSouth, 0.55);
    put("wardrobe-sliding", {7.35, kBathroom + 0.05 + 0.33}, kNorth);
    put("vanity-oval", {8.2, 3.4}, kWest);
    put("vanity-stool", {7.8, 3.4}, kEast);
    put("light-drum", {6.9, 3.75}, kSouth, -1, {0.5, 0.5, 0.45});
    put("picture-dusk", {6.9, kDepth - kOuter / 2 - 0.025}, kSouth, 1.5);
  }

  void furnishBathroom() {
    put("bathtub", {kWidth - kOuter / 2 - 0.38, 1.15}, kWest);
    put("toilet", {5.75, kBathroom - 0.05 - 0.34});
    put("basin-cabinet", {6.75, kBathroom - 0.05 - 0.25});
    put("light-flush", {6.9, 1.1});
    put("towel-rail", {7.55, kBathroom - 0.05 - 0.05}, kSouth, 0.9);
  }

  void addCameras() {
    camera("Living room", {4.85, 3.0, 1.5}, {1.2, 1.75, 0.9}, 80);
    camera("Kitchen", {4.6, 1.1, 1.5}, {1.9, 5.4, 1.0}, 62);
    camera("Bedroom", {5.45, 2.95, 1.5}, {8.0, 5.2, 0.75}, 74);
  }

  Catalog catalog_;
  Home home_;
};

}  // namespace

int main(int argc, char** argv) {
  try {
    idap::writeHome(Apartment().build(), argc > 1 ? argv[1] : "share/samples/apartment.idap");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_apartment: %s\n", error.what());
    return 1;
  }
}
