// Whatever a home holds, once validated it can be built: no crash, no endless work, nothing but finite
// vertices and triangles that name them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

#include "model/validate.h"
#include "scene/scene_test_support.h"

namespace idap {
namespace {

class RandomHome {
 public:
  explicit RandomHome(unsigned seed) : random_(seed) {}

  Home make() {
    const int levels = below(4);
    for (int i = 0; i < levels; ++i) {
      Level level;
      level.elevation = size();
      level.floorThickness = size();
      level.height = size();
      level.viewable = below(5) != 0;
      home_.levels.set(home_.newId<LevelId>(), level);
      levels_.push_back(LevelId{home_.nextId - 1});
    }
    levels_.push_back({});
    for (int i = below(14); i > 0; --i) addWall();
    for (int i = below(5); i > 0; --i) addRoom();
    for (int i = below(8); i > 0; --i) addOpening();
    for (int i = below(4); i > 0; --i) addFurniture();
    return std::move(home_);
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  // Mostly as in a home, now and then absurd.
  double size() {
    constexpr double kOdd[] = {0,
                               -1,
                               1e-9,
                               1e-5,
                               1e-3,
                               500,
                               9999,
                               1e9,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity()};
    return below(8) ? between(0.02, 4) : kOdd[below(10)];
  }
  double place() { return below(25) ? below(2) ? between(-6, 6) : below(7) - 3 : between(-3, 3) * 4e3; }
  Vec2 point() {
    return below(3) || points_.empty() ? points_.emplace_back(place(), place()) : points_[pick(points_)];
  }
  double angle() { return below(2) ? below(9) * kPi / 4 : between(-7, 7); }
  LevelId level() { return levels_[pick(levels_)]; }
  template <class T>
  std::size_t pick(const std::vector<T>& from) {
    return static_cast<std::size_t>(below(static_cast<int>(from.size())));
  }

  void addWall() {
    Wall wall;
    wall.level = level();
    wall.start = point();
    wall.end = point();
    wall.thickness = below(3) ? between(0.05, 0.4) : size();
    wall.heightAtStart = size();
    wall.heightAtEnd = below(2) ? wall.heightAtStart : size();
    if (below(4) == 0) wall.arcExtent = angle();
    if (below(3) == 0) wall.left.baseboard = Baseboard{size() / 50, size() / 20, {}};
    if (!walls_.empty()) wall.neighbourAtStart = walls_[pick(walls_)];
    if (below(2)) wall.neighbourAtEnd = WallId{static_cast<std::uint64_t>(below(30))};
    walls_.push_back(home_.newId<WallId>());
    home_.walls.set(walls_.back(), wall);
  }
  void addRoom() {
    Room room;
    room.level = level();
    for (int i = 2 + below(9); i > 0; --i) room.points.push_back(point());
    if (below(4) == 0) room.points.insert(room.points.end(), room.points.begin(), room.points.end());
    room.ceilingFlat = below(2);
    home_.rooms.set(home_.newId<RoomId>(), room);
  }
  void fill(Piece& piece) {
    piece.level = level();
    piece.position = {place(), place(), below(2) ? 0 : size()};
    piece.size = {size(), size(), size()};
    piece.angle = angle();
    if (below(4) == 0) piece.pitch = angle();
    if (below(4) == 0) piece.roll = angle();
    piece.mirrored = below(2);
  }
  void addOpening() {
    constexpr const char* kShapes[] = {"M0,0 v1 h1 v-1 z",
                                       "M0,0 h1 v1 z",
                                       "M0,1 A0.5,0.5 0 0 1 1,1 z",
                                       "M0,0 L1,1 L1,0 L0,1 z",
                                       "M5,5 h-90 v80 z",
                                       "",
                                       "nonsense"};
    Opening opening;
    fill(opening);
    const OpeningKind kinds[] = {OpeningKind::Bare, OpeningKind::Door, OpeningKind::Window};
    opening.kind = kinds[below(3)];
    opening.cutOut = kShapes[below(7)];
    opening.cutsBothSides = below(2);
    opening.wallThickness = below(3) ? 1 : size();
    opening.wallDistance = below(3) ? 0 : size();
    if (!walls_.empty() && below(4)) {
      opening.wall = walls_[pick(walls_)];
      const Wall& wall = *home_.walls.find(opening.wall);
      const Vec2 at = wall.start + (wall.end - wall.start) * between(-0.2, 1.2), d = wall.end - wall.start;
      opening.position = {at.x, at.y, below(2) ? 0 : between(-1, 3)};
      opening.level = wall.level;
      if (below(4)) opening.angle = std::atan2(d.y, d.x);
    }
    opening.model.catalogId = "idap/window-single";
    home_.openings.set(home_.newId<OpeningId>(), opening);
  }
  void addFurniture() {
    constexpr const char* kPieces[] = {"idap/lamp-floor", "idap/stairs-straight", "idap/plant-ficus",
                                       "no such piece"};
    Furniture piece;
    fill(piece);
    piece.model.catalogId = kPieces[below(4)];
    if (below(2)) piece.lamp = Lamp{.lumens = size() * 300};
    if (below(4) == 0) piece.staircaseCutOut = "M0,0 v1 h1 v-1 z";
    home_.furniture.set(home_.newId<FurnitureId>(), piece);
  }

  std::mt19937 random_;
  Home home_;
  std::vector<LevelId> levels_;
  std::vector<WallId> walls_;
  std::vector<Vec2> points_;
};

void expectSound(const BuiltScene& built) {
  const render::Scene& scene = *built.scene;
  for (const render::Instance& instance : scene.instances) {
    ASSERT_LT(instance.mesh, scene.meshes.size());
    ASSERT_LT(instance.objectId, built.objects.size());
    const Mesh& mesh = *scene.meshes[instance.mesh];
    for (const Vec3f& p : mesh.positions) {
      const Vec3f at = instance.transform.point(p);
      ASSERT_TRUE(std::isfinite(at.x + at.y + at.z));
    }
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) ASSERT_LT(v, mesh.positions.size());
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      ASSERT_LT(mesh.slotOf(t), instance.surfaces.size());
    for (const std::uint32_t s : instance.surfaces) ASSERT_LT(s, scene.surfaces.size());
  }
  for (const render::Portal& portal : scene.portals) {
    const Vec3f sum = portal.corner + portal.edgeU + portal.edgeV;
    ASSERT_TRUE(std::isfinite(sum.x + sum.y + sum.z));
  }
}

TEST(RandomHomes, ValidatedHomesAreBuiltWhateverTheyHold) {
  // IDAP_RANDOM_HOMES=5000 searches longer.
  const char* wish = std::getenv("IDAP_RANDOM_HOMES");
  const unsigned homes = wish ? static_cast<unsigned>(std::strtoul(wish, nullptr, 10)) : 60;
  for (unsigned seed = 1; seed <= homes; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    ImportReport report;
    const Home home = validated(RandomHome(seed).make(), report);
    ASSERT_NO_THROW(requireValid(home));
    BuildOptions options;
    options.ceilings = seed % 3 != 0;
    BuiltScene built;
    ASSERT_NO_THROW(built = buildScene(home, test::noLibraries(), options));
    ASSERT_NO_FATAL_FAILURE(expectSound(built));
  }
}

}  // namespace
}  // namespace idap
