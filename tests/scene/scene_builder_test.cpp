#include "scene/scene_builder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "formats/registry.h"
#include "light/color_temperature.h"
#include "scene/room_builder.h"
#include "scene/sloped_ceiling.h"
#include "scene_test_support.h"

namespace idap {
namespace {

using test::addRoom;
using test::addWalls;
using test::bareOpening;
using test::closedRoom;
using test::escaping;
using test::noLibraries;
using test::shoot;

SharedBytes text(const std::string& s) {
  const auto* first = reinterpret_cast<const std::byte*>(s.data());
  return std::make_shared<const Bytes>(first, first + s.size());
}

const char* const kTriangleObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3\nf 1 3 4\n";

Furniture piece(const std::string& asset, Vec3 position) {
  Furniture f;
  f.name = "chair";
  f.model.asset = asset;
  f.position = position;
  f.size = {0.5, 0.5, 1};
  return f;
}

TEST(SceneBuilder, NoLightLeaksOutOfAClosedRoom) {
  const BuiltScene built = buildScene(closedRoom(), noLibraries());
  EXPECT_EQ(escaping(built, {2, 1.5, 1.2}, 4000), 0);
  EXPECT_EQ(escaping(built, {0.15, 0.15, 2.45}, 2000), 0);
  EXPECT_EQ(escaping(built, {3.8, 2.8, 0.03}, 2000), 0);
}

TEST(SceneBuilder, ARoomDrawnALittleOffItsWallsDoesNotLeakEither) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0.3}, {4.5, 3}, {0.2, 3.1}});
  addRoom(home, {{0.14, 0.15}, {3.86, 0.42}, {4.33, 2.85}, {0.33, 2.93}});
  EXPECT_EQ(escaping(buildScene(home, noLibraries()), {2, 1.5, 1.2}, 4000), 0);
}

TEST(SceneBuilder, RoundWallsDoNotLeak) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  Wall round = *home.walls.find(ids[1]);
  round.arcExtent = 1.8;
  home.walls.set(ids[1], round);
  Polygon room{{0.1, 0.1}, {4, 0.1}};
  const auto line = wallCentreLine(round);
  room.insert(room.end(), line.begin() + 1, line.end() - 1);
  room.push_back({4, 2.9});
  room.push_back({0.1, 2.9});
  addRoom(home, room);
  EXPECT_EQ(escaping(buildScene(home, noLibraries()), {2, 1.5, 1.2}, 4000), 0);
}

TEST(SceneBuilder, LightLeavesThroughAnOpeningAndItGetsAPortal) {
  Home home = closedRoom();
  home.openings.set(home.newId<OpeningId>(), bareOpening({2, 0, 0.9}, 1.2, 1.2));
  const BuiltScene built = buildScene(home, noLibraries());
  EXPECT_FALSE(std::isfinite(shoot(built, {2, 1.5, 1.5}, {0, -1, 0}).distance));
  ASSERT_EQ(built.scene->portals.size(), 1u);
  const render::Portal& p = built.scene->portals[0];
  EXPECT_NEAR(length(p.edgeU), 1.2, 1e-4);
  EXPECT_NEAR(length(p.edgeV), 1.2, 1e-4);
  EXPECT_NEAR(p.corner.y + built.centre.y, 0, 1e-4);
  // Only the rays of that solid angle get out, near and far.
  const int out = escaping(built, {2, 1.5, 1.5}, 4000);
  EXPECT_GT(out, 100);
  EXPECT_LT(out, 250);
}

TEST(SceneBuilder, OpeningsBetweenRoomsAreNoPortals) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  addWalls(home, {{2, 0}, {2, 3}}, false);
  addRoom(home, {{0.1, 0.1}, {1.9, 0.1}, {1.9, 2.9}, {0.1, 2.9}});
  addRoom(home, {{2.1, 0.1}, {3.9, 0.1}, {3.9, 2.9}, {2.1, 2.9}});
  home.openings.set(home.newId<OpeningId>(), bareOpening({2, 1.5, 0}, 0.9, 2, kPi / 2));
  const BuiltScene built = buildScene(home, noLibraries());
  EXPECT_TRUE(built.scene->portals.empty());
  EXPECT_EQ(escaping(built, {1, 1.5, 1}, 4000), 0);
  // A ray through the door, and the floor goes on under it.
  EXPECT_NEAR(shoot(built, {1, 1.5, 1}, {1, 0, 0}).distance, 2.9, 1e-4);
  const auto below = shoot(built, {2, 1.5, 1}, {0, 0, -1});
  EXPECT_NEAR(below.distance, 1, 1e-5);
  EXPECT_TRUE(std::holds_alternative<RoomId>(built.objects[built.scene->instances[below.instance].objectId]));
}

TEST(SceneBuilder, TheGroundLiesJustBelowTheFloor) {
  const BuiltScene built = buildScene(closedRoom(), noLibraries());
  EXPECT_NEAR(shoot(built, {-3, -3, 1}, {0, 0, -1}).distance, 1.015, 1e-4);
  EXPECT_NEAR(shoot(built, {2, 1.5, 1}, {0, 0, -1}).distance, 1, 1e-5);
}

TEST(SceneBuilder, FromAboveCeilingsAreOff) {
  BuildOptions options;
  options.ceilings = false;
  const Home home = closedRoom();
  EXPECT_NEAR(shoot(buildScene(home, noLibraries(), options), {2, 1.5, 9}, {0, 0, -1}).distance, 9, 1e-4);
  EXPECT_NEAR(shoot(buildScene(home, noLibraries()), {2, 1.5, 9}, {0, 0, -1}).distance, 6.502, 1e-3);
}

Home twoStoreys(LevelId& ground, LevelId& upper) {
  Home home;
  Level low, high;
  high.elevation = 2.62;
  ground = home.newId<LevelId>();
  upper = home.newId<LevelId>();
  home.levels.set(ground, low);
  home.levels.set(upper, high);
  for (const LevelId level : {ground, upper}) {
    for (const WallId id : addWalls(home, {{0, 0}, {6, 0}, {6, 4}, {0, 4}})) {
      Wall w = *home.walls.find(id);
      w.level = level;
      home.walls.set(id, w);
    }
    addRoom(home, {{0.1, 0.1}, {5.9, 0.1}, {5.9, 3.9}, {0.1, 3.9}}, level);
  }
  return home;
}

TEST(SceneBuilder, AStaircaseOpensTheCeilingAndTheFloorAbove) {
  LevelId ground, upper;
  Home home = twoStoreys(ground, upper);
  EXPECT_NEAR(shoot(buildScene(home, noLibraries()), {2, 2, 1}, {0, 0, 1}).distance, 1.498, 1e-3);
  Furniture stair;
  stair.level = ground;
  stair.position = {2, 2, 0};
  stair.size = {1, 2, 2.62};
  stair.staircaseCutOut = "M0,0 v1 h1 v-1 z";
  stair.visible = false;
  const FurnitureId id = home.newId<FurnitureId>();
  home.furniture.set(id, stair);
  EXPECT_NEAR(shoot(buildScene(home, noLibraries()), {2, 2, 1}, {0, 0, 1}).distance, 1.498, 1e-3);
  stair.visible = true;
  stair.size.z = 2.62;
  home.furniture.set(id, stair);
  const BuiltScene built = buildScene(home, noLibraries());
  // From above the stair's (missing) model up to the upper ceiling.
  EXPECT_NEAR(shoot(built, {2, 2, 2.7}, {0, 0, 1}).distance, 2.42 - 0.002, 1e-3);
  EXPECT_NEAR(shoot(built, {2.4, 2.9, 2.65}, {0, 0, -1}).distance, 0.03 + 0.01, 0.03);
  EXPECT_NEAR(shoot(built, {3.5, 2, 3}, {0, 0, -1}).distance, 0.38, 1e-4) << "the floor beside it stays";
  EXPECT_EQ(escaping(built, {4, 2, 1.2}, 4000), 0);
  EXPECT_EQ(escaping(built, {4, 2, 4}, 4000), 0);
}

TEST(SceneBuilder, AStaircaseOpensASlopedCeilingToo) {
  LevelId ground, upper;
  Home home = twoStoreys(ground, upper);
  // The ground floor's ceiling rises with the walls along x.
  for (const auto& [id, wall] : std::vector(home.walls.begin(), home.walls.end())) {
    if (wall->level != ground) continue;
    Wall w = *wall;
    w.heightAtStart = 2.0 + 0.05 * w.start.x;
    w.heightAtEnd = 2.0 + 0.05 * w.end.x;
    home.walls.set(id, w);
  }
  EXPECT_NEAR(shoot(buildScene(home, noLibraries()), {2, 2, 1}, {0, 0, 1}).distance, 1.1, 0.01);
  Furniture stair;
  stair.level = ground;
  stair.position = {2, 2, 0};
  stair.size = {1, 2, 2.62};
  stair.staircaseCutOut = "M0,0 v1 h1 v-1 z";
  home.furniture.set(home.newId<FurnitureId>(), stair);
  const BuiltScene built = buildScene(home, noLibraries());
  EXPECT_NEAR(shoot(built, {2, 2, 2.7}, {0, 0, 1}).distance, 2.42 - 0.002, 1e-3);
  EXPECT_NEAR(shoot(built, {3.5, 2, 1}, {0, 0, 1}).distance, 1.175, 0.01) << "beside it the slope stays";
}

TEST(SceneBuilder, HiddenLevelsBelongToViewsFromInsideOnly) {
  LevelId ground, upper;
  Home home = twoStoreys(ground, upper);
  Level high = *home.levels.find(upper);
  high.visible = false;
  home.levels.set(upper, high);
  const auto walls = [&](const BuildOptions& options) {
    const BuiltScene built = buildScene(home, noLibraries(), options);
    return std::count_if(built.objects.begin(), built.objects.end(),
                         [](const ElementId& id) { return std::holds_alternative<WallId>(id); });
  };
  EXPECT_EQ(walls({}), 8);
  EXPECT_EQ(walls({.ceilings = false}), 4);
  EXPECT_EQ(walls({.hiddenLevels = false}), 4);
  high.viewable = false;
  home.levels.set(upper, high);
  EXPECT_EQ(walls({}), 4);
}

TEST(SceneBuilder, CeilingsFollowSlopedWallsUpToTheRidge) {
  Home home;
  // Gables at both ends, each of two walls that rise to the ridge at y = 2.
  const auto ids = addWalls(home, {{0, 0}, {6, 0}, {6, 2}, {6, 4}, {0, 4}, {0, 2}});
  const auto slope = [&](std::size_t i, double from, double to) {
    Wall w = *home.walls.find(ids[i]);
    w.heightAtStart = from;
    w.heightAtEnd = to;
    home.walls.set(ids[i], w);
  };
  slope(0, 2, 2);
  slope(1, 2, 3);
  slope(2, 3, 2);
  slope(3, 2, 2);
  slope(4, 2, 3);
  slope(5, 3, 2);
  addRoom(home, {{0.1, 0.1}, {5.9, 0.1}, {5.9, 3.9}, {0.1, 3.9}});
  const BuiltScene built = buildScene(home, noLibraries());
  EXPECT_NEAR(shoot(built, {3, 2, 1}, {0, 0, 1}).distance, 2, 0.01);
  EXPECT_NEAR(shoot(built, {3, 1, 1}, {0, 0, 1}).distance, 1.5, 0.05);
  EXPECT_NEAR(shoot(built, {3, 3, 1}, {0, 0, 1}).distance, 1.5, 0.05);
  EXPECT_EQ(escaping(built, {3, 2, 1}, 4000), 0);
}

TEST(SlopedCeiling, TakesTheRidgeRatherThanTheValley) {
  const auto height = [](Vec2 p) { return 3 - std::abs(p.y - 2) / 2; };
  const Mesh3 mesh = slopedCeiling({{0, 0}, {6, 0}, {6, 4}, {0, 4}}, {{0, 2}, {6, 2}}, height);
  EXPECT_EQ(mesh.points.size(), 6u);
  double plan = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.points[t[0]], b = mesh.points[t[1]], c = mesh.points[t[2]];
    plan += cross(Vec2{b.x - a.x, b.y - a.y}, Vec2{c.x - a.x, c.y - a.y}) / 2;
    const Vec3 middle = (a + b + c) / 3;
    EXPECT_NEAR(middle.z, height({middle.x, middle.y}), 0.02);
  }
  EXPECT_NEAR(plan, 6.04 * 4.04, 1e-6);
}

TEST(SceneBuilder, PiecesOfOneModelShareOneMesh) {
  Home home = closedRoom();
  auto assets = std::make_shared<Assets>();
  (*assets)["models/a/chair.obj"] = text(kTriangleObj);
  home.assets = assets;
  for (int i = 0; i < 5; ++i)
    home.furniture.set(home.newId<FurnitureId>(), piece("models/a/chair.obj", {0.5 + i * 0.6, 1, 0}));
  const BuiltScene built = buildScene(home, noLibraries());
  EXPECT_TRUE(built.warnings.empty()) << built.warnings.front();
  std::set<std::uint32_t> meshes, objects;
  for (const render::Instance& instance : built.scene->instances) {
    EXPECT_TRUE(objects.insert(instance.objectId).second) << "object ids are unique";
    if (std::holds_alternative<FurnitureId>(built.objects[instance.objectId])) meshes.insert(instance.mesh);
  }
  EXPECT_EQ(meshes.size(), 1u);
}

TEST(SceneBuilder, FinishesApplyToTheWholePieceThenToSlots) {
  Home home;
  auto assets = std::make_shared<Assets>();
  (*assets)["m.obj"] =
      text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nusemtl wood\nf 1 2 3\nusemtl seat\nf 1 3 4\n");
  home.assets = assets;
  Furniture f = piece("m.obj", {});
  f.finish.color = Color{1, 0, 0};
  f.slotFinishes["seat "].color = Color{0, 0, 1};
  home.furniture.set(home.newId<FurnitureId>(), f);
  const BuiltScene built = buildScene(home, noLibraries());
  const auto& scene = *built.scene;
  bool wood = false, seat = false;
  for (const std::uint32_t s : scene.instances.back().surfaces) {
    const render::Surface& surface = scene.surfaces[s];
    if (surface.name == "wood") wood = surface.baseColor.x > 0.5f && surface.baseColor.z < 0.1f;
    if (surface.name == "seat") seat = surface.baseColor.z > 0.5f && surface.baseColor.x < 0.1f;
  }
  EXPECT_TRUE(wood);
  EXPECT_TRUE(seat);
}

TEST(SceneBuilder, ABoxStandsForAMissingModelAndAWarningSaysSo) {
  Home home = closedRoom();
  home.furniture.set(home.newId<FurnitureId>(), piece("models/lost.obj", {2, 1.5, 0}));
  const BuiltScene built = buildScene(home, noLibraries());
  ASSERT_EQ(built.warnings.size(), 1u);
  EXPECT_NE(built.warnings[0].find("chair"), std::string::npos);
  EXPECT_NE(built.warnings[0].find("box"), std::string::npos);
  EXPECT_NEAR(shoot(built, {2, 1.5, 2}, {0, 0, -1}).distance, 1, 1e-4);
  EXPECT_NEAR(shoot(built, {3, 1.5, 0.5}, {-1, 0, 0}).distance, 0.75, 1e-4);
}

TEST(SceneBuilder, LampsShineAsThePolicySays) {
  Home home = closedRoom();
  Furniture lamp = piece("", {2, 1.5, 2});
  lamp.size = {0.3, 0.3, 0.5};
  lamp.lamp = Lamp{};
  lamp.lamp->dimmer = 0.5;
  const FurnitureId id = home.newId<FurnitureId>();
  home.furniture.set(id, lamp);
  const auto lumens = [&](LampPolicy policy) {
    const BuiltScene built = buildScene(home, noLibraries(), {.lamps = policy});
    double sum = 0;
    for (const render::Lamp& l : built.scene->lamps) sum += 4 * kPi * double(luminance(l.intensity));
    return sum;
  };
  EXPECT_NEAR(lumens(LampPolicy::Auto), 403, 0.1);
  EXPECT_NEAR(lumens(LampPolicy::Off), 0, 1e-9);
  lamp.lamp->on = false;
  home.furniture.set(id, lamp);
  EXPECT_NEAR(lumens(LampPolicy::Auto), 0, 1e-9);
  EXPECT_NEAR(lumens(LampPolicy::On), 403, 0.1);
}

TEST(SceneBuilder, ABulbInTheCeilingIsMovedIntoTheRoom) {
  Home home = closedRoom();
  Furniture lamp = piece("", {2, 1.5, 2.4});
  lamp.size = {0.2, 0.2, 0.2};
  lamp.lamp = Lamp{};
  lamp.lamp->sources.push_back({.position = {0.5, 0.5, 0.9}});
  home.furniture.set(home.newId<FurnitureId>(), lamp);
  const BuiltScene built = buildScene(home, noLibraries());
  ASSERT_EQ(built.scene->lamps.size(), 1u);
  EXPECT_LT(built.scene->lamps[0].position.z + built.scene->lamps[0].radius, 2.498f);
  EXPECT_EQ(built.scene->lightGroups,
            (std::vector<render::LightGroup>{{"sky"}, {"sun"}, {"chair", rgbFromTemperature(2700)}}));
}

TEST(SceneBuilder, TheSunStandsInTheSouthAtNoon) {
  Home home = closedRoom();
  const BuiltScene built =
      buildScene(home, noLibraries(), {.time = 1750503600000});  // 11:00 UTC, Paris, in June
  EXPECT_LT(built.scene->sun.direction.y, -0.3f);
  EXPECT_GT(built.scene->sun.direction.z, 0.7f);
  EXPECT_GT(luminance(built.scene->sun.illuminance), 50'000.0f);
  EXPECT_FALSE(built.scene->sky.radiance.empty());
}

TEST(SceneBuilder, WhiteWallsReflectLessThanAllLight) {
  Home home = closedRoom();
  const BuiltScene built = buildScene(home, noLibraries());
  for (const render::Surface& s : built.scene->surfaces) EXPECT_LE(maxComponent(s.baseColor), 0.85f);
}

TEST(SceneBuilder, DegenerateHomesDoNoHarm) {
  EXPECT_NO_THROW(buildScene(Home{}, noLibraries()));
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Home home;
  addWalls(home, {{0, 0}, {0, 0}, {1, 0}, {1, 1e-9}});
  addWalls(home, {{kNan, 0}, {1, 1}}, false);
  addRoom(home, {});
  addRoom(home, {{0, 0}, {1, 1}, {0, 1}, {1, 0}});
  addRoom(home, {{0, 0}, {kNan, 1}, {0, 1}});
  Furniture flat = piece("x", {1, 1, 0});
  flat.size = {0, 0, 0};
  flat.staircaseCutOut = "rubbish";
  flat.lamp = Lamp{};
  home.furniture.set(home.newId<FurnitureId>(), flat);
  flat.position.x = kNan;
  home.furniture.set(home.newId<FurnitureId>(), flat);
  Opening o = bareOpening({0.5, 0, 0}, 0, 0);
  o.cutOut = "rubbish";
  home.openings.set(home.newId<OpeningId>(), o);
  EXPECT_NO_THROW(buildScene(home, noLibraries()));
  EXPECT_NO_THROW(toRenderCamera(topCamera(home), buildScene(home, noLibraries()), 1.5));
}

TEST(SceneBuilder, EqualHomesGiveEqualScenes) {
  const BuiltScene a = buildScene(closedRoom(), noLibraries()), b = buildScene(closedRoom(), noLibraries());
  ASSERT_EQ(a.scene->meshes.size(), b.scene->meshes.size());
  for (std::size_t i = 0; i < a.scene->meshes.size(); ++i) {
    EXPECT_EQ(a.scene->meshes[i]->positions, b.scene->meshes[i]->positions);
    EXPECT_EQ(a.scene->meshes[i]->triangles, b.scene->meshes[i]->triangles);
  }
}

TEST(SceneBuilder, CancellingStopsTheBuild) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(buildScene(closedRoom(), noLibraries(), {}, progress), Cancelled);
}

TEST(CameraMapper, LooksAlongYawAndPitch) {
  BuiltScene built;
  built.centre = {1, 2, 0};
  Camera camera;
  camera.eye = {1, 2, 1.6};
  camera.pitch = 0.3;
  for (const double yaw : {0.0, 1.0, -2.5}) {
    camera.yaw = yaw;
    const render::Camera c = toRenderCamera(camera, built, 1.5);
    EXPECT_NEAR(c.forward.x, -std::sin(yaw) * std::cos(0.3), 1e-6);
    EXPECT_NEAR(c.forward.z, -std::sin(0.3), 1e-6);
    EXPECT_NEAR(dot(c.forward, c.up), 0, 1e-6);
    EXPECT_NEAR(length(c.up), 1, 1e-6);
    EXPECT_GT(c.up.z, 0);
    EXPECT_NEAR(c.eye.z, 1.6, 1e-6);
    EXPECT_NEAR(c.eye.x, 0, 1e-6);
  }
}

TEST(CameraMapper, TheViewFromAboveHoldsTheWholeHome) {
  const Home home = closedRoom();
  for (const double aspect : {0.5, 1.5, 3.0}) {
    const Camera camera = topCamera(home, aspect);
    const Vec3 f = viewDirection(camera), right{1, 0, 0}, up = cross(right, f);
    for (const Vec3& p : {Vec3{-0.1, -0.1, 0}, Vec3{4.1, 3.1, 2.5}, Vec3{4.1, -0.1, 2.5}}) {
      const Vec3 d = p - camera.eye;
      EXPECT_GT(dot(d, f), 0);
      EXPECT_LT(std::abs(dot(d, right)) / dot(d, f), std::tan(camera.fieldOfView / 2) * 1.03);
      EXPECT_LT(std::abs(dot(d, up)) / dot(d, f), std::tan(camera.fieldOfView / 2) / aspect * 1.03);
    }
  }
}

// Real homes, where they are at hand.
class RealHome : public testing::TestWithParam<const char*> {};
TEST_P(RealHome, IsBuiltWholeAndWithoutWarnings) {
  const std::filesystem::path file =
      std::filesystem::path(IDAP_SOURCE_DIR) / "../shared/homes" / (std::string(GetParam()) + ".sh3d");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the sample homes are not here";
  const ReadResult read = readHome(file);
  const BuiltScene built = buildScene(read.home, noLibraries());
  EXPECT_TRUE(built.warnings.empty()) << built.warnings.front();
  EXPECT_GT(built.triangles, 1000u);
  for (const auto& mesh : built.scene->meshes) {
    for (const Vec3f& p : mesh->positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
  }
}
INSTANTIATE_TEST_SUITE_P(Homes, RealHome,
                         testing::Values("Studio", "1-BedroomApartment", "3-BedroomHouseWithMezzanine",
                                         "Sample"));

}  // namespace
}  // namespace idap
