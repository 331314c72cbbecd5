#include "scene/scene_memory.h"

#include <gtest/gtest.h>

#include "scene/cut_away.h"
#include "scene/scene_test_support.h"

namespace idap {
namespace {

void expectSame(const BuiltScene& a, const BuiltScene& b) {
  ASSERT_EQ(a.scene->instances.size(), b.scene->instances.size());
  ASSERT_EQ(a.scene->lamps.size(), b.scene->lamps.size());
  EXPECT_EQ(a.scene->sun.direction, b.scene->sun.direction);
  const Vec3f off = toFloat(b.centre - a.centre);
  for (std::size_t i = 0; i < a.scene->instances.size(); ++i) {
    const render::Instance &x = a.scene->instances[i], &y = b.scene->instances[i];
    const Mesh &m = *a.scene->meshes[x.mesh], &n = *b.scene->meshes[y.mesh];
    ASSERT_EQ(m.triangles, n.triangles) << "instance " << i;
    ASSERT_EQ(m.positions.size(), n.positions.size());
    for (std::size_t p = 0; p < m.positions.size(); ++p)
      ASSERT_LT(length(x.transform.point(m.positions[p]) - y.transform.point(n.positions[p]) - off), 1e-4f);
    ASSERT_EQ(x.surfaces.size(), y.surfaces.size());
    for (std::size_t s = 0; s < x.surfaces.size(); ++s)
      EXPECT_EQ(a.scene->surfaces[x.surfaces[s]].baseColor, b.scene->surfaces[y.surfaces[s]].baseColor);
  }
}

FurnitureId put(Home& home, const char* piece, Vec3 at) {
  const auto id = home.newId<FurnitureId>();
  home.furniture.set(id, makeFurniture(*test::noLibraries().find(piece), at));
  return id;
}

TEST(SceneMemory, EveryEditGivesTheSceneThatANewBuildGives) {
  Home home = test::closedRoom();
  const FurnitureId chair = put(home, "idap/chair-windsor", {1, 1, 0});
  SceneMemory memory;
  const auto check = [&](const char* what) {
    SCOPED_TRACE(what);
    expectSame(buildScene(home, test::noLibraries(), {}, {}, &memory), buildScene(home, test::noLibraries()));
  };
  check("new");
  Furniture moved = *home.furniture.find(chair);
  moved.position.x = 2;
  home.furniture.set(chair, moved);
  check("moved");
  moved.finish = plain(Color{1, 0, 0});
  home.furniture.set(chair, moved);
  check("painted");
  const auto [wallId, wall] = *home.walls.begin();
  Wall lower = *wall;
  lower.heightAtStart = lower.heightAtEnd = 1.2;
  home.walls.set(wallId, lower);
  check("a lower wall");
  home.site.time += 5 * 3'600'000;
  check("later");
  home.environment.cloudiness = 1;
  check("overcast");
  home.furniture.erase(chair);
  check("gone");
}

TEST(SceneMemory, WhatAnEditDoesNotTouchStaysTheSameMesh) {
  Home home = test::closedRoom();
  const FurnitureId chair = put(home, "idap/chair-windsor", {1, 1, 0});
  SceneMemory memory;
  const BuiltScene before = buildScene(home, test::noLibraries(), {}, {}, &memory);
  Furniture moved = *home.furniture.find(chair);
  moved.position.x = 2;
  home.furniture.set(chair, moved);
  const BuiltScene after = buildScene(home, test::noLibraries(), {}, {}, &memory);
  EXPECT_EQ(before.scene->meshes, after.scene->meshes);
}

TEST(CutAway, AnEyeOutsideLooksThroughTheWallBeforeItOnly) {
  const Home home = test::closedRoom();
  EXPECT_FALSE(isOutside(home, {2, 1.5, 1.6}));
  EXPECT_TRUE(isOutside(home, {2, 1.5, 8})) << "above the roof";
  EXPECT_TRUE(isOutside(home, {2, -4, 1.6})) << "in the garden";
  const BuiltScene built = buildScene(home, test::noLibraries());
  ASSERT_EQ(built.outerWalls.size(), 4u);
  EXPECT_EQ(hiddenFrom(built, {2, -4, 1.6}, CutAway::ByView).size(), 1u);
  EXPECT_EQ(hiddenFrom(built, {9, -4, 1.6}, CutAway::ByView).size(), 2u) << "from a corner";
  EXPECT_TRUE(hiddenFrom(built, {2, -4, 1.6}, CutAway::Never).empty());
}

}  // namespace
}  // namespace idap
