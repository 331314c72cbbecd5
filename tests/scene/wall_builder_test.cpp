#include "scene/wall_builder.h"

#include <gtest/gtest.h>

#include "scene_test_support.h"

namespace idap {
namespace {

using test::addWalls;
using test::bareOpening;

struct Walls {
  explicit Walls(const Home& home)
      : storeys(shownStoreys(home, true)),
        solids(wallSolids(home, storeys)),
        openings(openingCuts(home, storeys)),
        cuts(cutsOf(solids, openings)),
        builder(home, solids, cuts) {}
  std::shared_ptr<const Mesh> mesh(std::size_t i) const { return builder.build(i, {}); }

  std::vector<Storey> storeys;
  std::vector<WallSolid> solids;
  std::vector<OpeningCut> openings;
  std::vector<std::vector<WallCut>> cuts;
  WallBuilder builder;
};

// m2 of the faces above the floor that look along n.
double areaFacing(const Mesh& mesh, Vec3f n, float above = 0.0f) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    const Vec3f normal = cross(b - a, c - a);
    if (std::max({a.z, b.z, c.z}) <= above) continue;
    if (dot(normal, n) > 0.999f * length(normal)) sum += double(length(normal)) / 2;
  }
  return sum;
}

constexpr double kBelow = 0.1202;  // m that walls of a home without levels reach below the floor

TEST(WallBuilder, AWallIsAClosedSolid) {
  Home home;
  addWalls(home, {{0, 0}, {3, 0}}, false);
  const auto mesh = Walls(home).mesh(0);
  ASSERT_TRUE(mesh);
  EXPECT_NEAR(test::volume(*mesh), 3 * 0.2 * (2.5 + kBelow), 1e-5);
}

TEST(WallBuilder, ASlopedTopRunsStraightBetweenItsHeights) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {4, 0}}, false);
  Wall w = *home.walls.find(ids[0]);
  w.heightAtStart = 1;
  w.heightAtEnd = 3;
  home.walls.set(ids[0], w);
  const auto mesh = Walls(home).mesh(0);
  EXPECT_NEAR(test::volume(*mesh), 4 * 0.2 * (2 + kBelow), 1e-5);
  for (const Vec3f& p : mesh->positions) {
    if (p.z > 0) {
      EXPECT_NEAR(p.z, 1 + p.x / 2, 1e-5);
    }
  }
}

TEST(WallBuilder, AnOpeningTakesItsAreaOutOfBothSidesAndGetsReveals) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false);
  home.openings.set(home.newId<OpeningId>(), bareOpening({2, 0, 0.9}, 1.2, 1.0));
  const auto mesh = Walls(home).mesh(0);
  const double side = 4 * (2.5 + kBelow) - 1.2;
  EXPECT_NEAR(areaFacing(*mesh, {0, 1, 0}, -1), side, 1e-4);
  EXPECT_NEAR(areaFacing(*mesh, {0, -1, 0}, -1), side, 1e-4);
  // Sill and the wall's top look up; the jambs face each other, besides the wall's ends.
  EXPECT_NEAR(areaFacing(*mesh, {0, 0, 1}), 4 * 0.2 + 1.2 * 0.2, 1e-4);
  EXPECT_NEAR(areaFacing(*mesh, {1, 0, 0}, -1), 0.2 * (2.5 + kBelow) + 0.2, 1e-4);
  EXPECT_NEAR(areaFacing(*mesh, {-1, 0, 0}, -1), 0.2 * (2.5 + kBelow) + 0.2, 1e-4);
  // What is left is closed.
  EXPECT_NEAR(test::volume(*mesh), (4 * (2.5 + kBelow) - 1.2) * 0.2, 1e-4);
}

TEST(WallBuilder, RoundOpeningsAreCutByTheirOutline) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false);
  Opening o = bareOpening({2, 0, 1}, 1, 1);
  o.cutOut = "M0,0.5 A.5,.5 0 0 1 1,.5 A.5,.5 0 0 1 0,.5 Z";
  home.openings.set(home.newId<OpeningId>(), o);
  const auto mesh = Walls(home).mesh(0);
  EXPECT_NEAR(areaFacing(*mesh, {0, 1, 0}, -1), 4 * (2.5 + kBelow) - kPi / 4, 0.01);
  EXPECT_NEAR(test::volume(*mesh), (4 * (2.5 + kBelow) - kPi / 4) * 0.2, 0.002);
}

TEST(WallBuilder, AWindowsHoleReachesAMillimetreUnderItsFrame) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false);
  Opening o = bareOpening({2, 0, 0.9}, 1.2, 1.0);
  o.kind = OpeningKind::Window;
  o.cutsBothSides = true;
  home.openings.set(home.newId<OpeningId>(), o);
  EXPECT_NEAR(areaFacing(*Walls(home).mesh(0), {0, 1, 0}, -1), 4 * (2.5 + kBelow) - 1.198 * 0.998, 1e-4);
}

TEST(WallBuilder, AnOpeningHigherThanTheWallIsOpenAtItsTop) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false);
  home.openings.set(home.newId<OpeningId>(), bareOpening({2, 0, 2}, 1, 2));
  const auto mesh = Walls(home).mesh(0);
  EXPECT_NEAR(areaFacing(*mesh, {0, 1, 0}, -1), 4 * (2.5 + kBelow) - 0.5, 1e-4);
  EXPECT_NEAR(areaFacing(*mesh, {1, 0, 0}, -1), 0.2 * (2.5 + kBelow) + 0.1, 1e-4);
}

TEST(WallBuilder, AnOpeningAcrossTheJointOfTwoWallsCutsBothAndTheirEnds) {
  Home home;
  addWalls(home, {{0, 0}, {2, 0}, {4, 0}}, false);
  home.openings.set(home.newId<OpeningId>(), bareOpening({2, 0, 0.9}, 1.0, 1.0));
  const Walls walls(home);
  double left = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    left += areaFacing(*walls.mesh(i), {0, 1, 0}, -1);
    // Two ends and a jamb, less the hole in the end at the joint.
    const double across =
        areaFacing(*walls.mesh(i), {1, 0, 0}, -1) + areaFacing(*walls.mesh(i), {-1, 0, 0}, -1);
    EXPECT_NEAR(across, 2 * 0.2 * (2.5 + kBelow) + 0.2 - 0.2, 1e-4);
  }
  EXPECT_NEAR(left, 4 * (2.5 + kBelow) - 1, 1e-4);
}

TEST(WallBuilder, AShallowModelMakesANicheWhereItMustNotCutThrough) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false, 0.5);
  Opening o = bareOpening({2, 0.15, 0.9}, 1, 1);
  o.kind = OpeningKind::Window;
  o.size.y = 0.2;  // from 5 cm to 25 cm: up to the left face
  home.openings.set(home.newId<OpeningId>(), o);
  const auto mesh = Walls(home).mesh(0);
  const double hole = 0.998 * 0.998;
  EXPECT_NEAR(areaFacing(*mesh, {0, -1, 0}, -1), 4 * (2.5 + kBelow), 1e-4);
  EXPECT_NEAR(areaFacing(*mesh, {0, 1, 0}, -1), 4 * (2.5 + kBelow), 1e-4);  // the back plate makes up for it
  EXPECT_NEAR(test::volume(*mesh), 4 * (2.5 + kBelow) * 0.5 - hole * 0.2, 1e-3);
}

TEST(WallBuilder, OpeningsCutRoundWalls) {
  Home home;
  const auto ids = addWalls(home, {{-2, 0}, {2, 0}}, false);
  Wall round = *home.walls.find(ids[0]);
  round.arcExtent = -kPi;
  home.walls.set(ids[0], round);
  const double whole = test::volume(*Walls(home).mesh(0));
  home.openings.set(home.newId<OpeningId>(), bareOpening({0, 2, 0.9}, 1, 1));
  const double cut = test::volume(*Walls(home).mesh(0));
  EXPECT_NEAR(whole - cut, 0.2 * 1.0, 0.02);
}

TEST(WallBuilder, BaseboardsStopAtDoorsAndMeetInCorners) {
  Home home;
  const auto ids = addWalls(home, {{0, 0}, {4, 0}, {4, 3}}, false);
  for (const WallId id : ids) {
    Wall w = *home.walls.find(id);
    w.left.baseboard = Baseboard{0.02, 0.1, {}};
    home.walls.set(id, w);
  }
  const auto top = [](const Mesh& mesh) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (mesh.slots[t] != kBaseboardLeft) continue;
      const auto& v = mesh.triangles[t];
      const Vec3f n =
          cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
      if (n.z > 0) sum += double(n.z) / 2;
    }
    return sum;
  };
  const double whole = top(*Walls(home).mesh(0));
  EXPECT_NEAR(whole, 0.02 * (3.9 + 3.88) / 2, 1e-5);
  home.openings.set(home.newId<OpeningId>(), bareOpening({1.5, 0, 0}, 1, 2));
  EXPECT_NEAR(whole - top(*Walls(home).mesh(0)), 0.02 * 1, 1e-5);
  home.openings.set(home.newId<OpeningId>(), bareOpening({3, 0, 0.8}, 0.5, 1));
  EXPECT_NEAR(whole - top(*Walls(home).mesh(0)), 0.02 * 1, 1e-5) << "a window leaves it";
}

TEST(WallBuilder, WallsThatOverlapShowEachFaceOnce) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}}, false);
  addWalls(home, {{2, 0}, {6, 0}}, false);
  const Walls walls(home);
  double front = 0, tops = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    front += areaFacing(*walls.mesh(i), {0, 1, 0}, -1);
    tops += areaFacing(*walls.mesh(i), {0, 0, 1});
  }
  EXPECT_NEAR(front, 6 * (2.5 + kBelow), 1e-4);
  EXPECT_NEAR(tops, 6 * 0.2, 1e-4);
}

TEST(WallBuilder, AWallShortOfTheSlabAboveIsCarriedUpToIt) {
  Home home;
  Level ground, upper;
  upper.elevation = 2.8;
  upper.floorThickness = 0.2;
  const LevelId g = home.newId<LevelId>(), u = home.newId<LevelId>();
  home.levels.set(g, ground);
  home.levels.set(u, upper);
  const auto ids = addWalls(home, {{0, 0}, {4, 0}}, false);
  Wall w = *home.walls.find(ids[0]);
  w.level = g;
  home.walls.set(ids[0], w);
  EXPECT_NEAR(Walls(home).solids[0].topAt({1, 0}), 2.5, 1e-9) << "nothing above";
  test::addRoom(home, {{-1, -1}, {5, -1}, {5, 3}, {-1, 3}}, u);
  EXPECT_NEAR(Walls(home).solids[0].topAt({1, 0}), 2.6, 1e-9);
  w.heightAtStart = w.heightAtEnd = 1;
  home.walls.set(ids[0], w);
  EXPECT_NEAR(Walls(home).solids[0].topAt({1, 0}), 1, 1e-9) << "a parapet stays one";
}

TEST(WallBuilder, NoNormalIsLeftOutOrOfTheWrongLength) {
  Home home;
  auto ids = addWalls(home, {{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  Wall w = *home.walls.find(ids[1]);
  w.arcExtent = 1.5;
  home.walls.set(ids[1], w);
  const Walls walls(home);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const auto mesh = walls.mesh(i);
    ASSERT_EQ(mesh->normals.size(), mesh->positions.size());
    for (const Vec3f& n : mesh->normals) EXPECT_NEAR(length(n), 1, 1e-5);
    for (const auto& t : mesh->triangles) {
      const Vec3f face =
          cross(mesh->positions[t[1]] - mesh->positions[t[0]], mesh->positions[t[2]] - mesh->positions[t[0]]);
      EXPECT_GT(dot(face, mesh->normals[t[0]]), 0);
    }
  }
}

}  // namespace
}  // namespace idap
