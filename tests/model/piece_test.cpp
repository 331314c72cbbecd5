#include "model/piece.h"

#include <gtest/gtest.h>

#include "model/home.h"

namespace idap {
namespace {

void expectNear(Vec3 a, Vec3 b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

TEST(Piece, StandsOnItsPositionAndTurnsCounterClockwise) {
  Piece chair;
  chair.position = {2, 3, 0.5};
  chair.size = {0.4, 0.6, 1};
  chair.angle = kPi / 2;
  const Transform t = placement(chair);
  expectNear(t.point({0, 0, 0}), {2, 3, 0.5});
  expectNear(t.point({0.2, 0, 0}), {2, 3.2, 0.5});   // its right points to +y
  expectNear(t.point({0, -0.3, 1}), {2.3, 3, 1.5});  // its front to +x
}

TEST(Piece, TiltingKeepsTheCentreAndLiftsTheBack) {
  Piece picture;
  picture.size = {1, 0.2, 2};
  picture.position = {5, 5, 1};
  picture.pitch = 0.3;
  picture.roll = -0.2;
  picture.angle = 1;
  expectNear(placement(picture).point({0, 0, 1}), {5, 5, 2});
  picture.roll = 0;
  EXPECT_GT(placement(picture).point({0, 0.1, 1}).z, 2);
}

TEST(Piece, MirroringExchangesLeftAndRight) {
  Piece desk;
  desk.mirrored = true;
  expectNear(placement(desk).point({0.5, 0.25, 0}), {-0.5, 0.25, 0});
  EXPECT_DOUBLE_EQ(placement(desk).determinant(), -1);
}

TEST(Piece, FootprintRunsCounterClockwiseFromFrontLeft) {
  Piece bed;
  bed.size = {1.6, 2, 0.5};
  bed.position = {1, 1, 0};
  const auto corners = footprint(bed);
  EXPECT_NEAR(corners[0].x, 0.2, 1e-12);
  EXPECT_NEAR(corners[0].y, 0, 1e-12);
  EXPECT_NEAR(corners[1].x, 1.8, 1e-12);
  EXPECT_NEAR(corners[2].y, 2, 1e-12);
  bed.angle = 0.7;
  const auto turned = footprint(bed);
  EXPECT_NEAR(signedArea({turned.begin(), turned.end()}), 3.2, 1e-12);
}

TEST(Home, HiddenLevelsAndGroupsHideWhatIsInThem) {
  Home home;
  const auto level = home.newId<LevelId>();
  const auto outer = home.newId<GroupId>(), inner = home.newId<GroupId>();
  Level upstairs;
  upstairs.elevation = 2.7;
  home.levels.set(level, upstairs);
  Group outerGroup, innerGroup;
  innerGroup.parent = outer;
  home.groups.set(outer, outerGroup);
  home.groups.set(inner, innerGroup);
  Piece piece;
  piece.level = level;
  piece.group = inner;
  EXPECT_TRUE(isShown(home, piece));
  EXPECT_DOUBLE_EQ(elevationOf(home, level), 2.7);
  EXPECT_DOUBLE_EQ(elevationOf(home, LevelId{99}), 0);
  outerGroup.visible = false;
  home.groups.set(outer, outerGroup);
  EXPECT_FALSE(isShown(home, piece));
  home.groups.set(outer, innerGroup);  // a circle: inner in outer in outer
  EXPECT_TRUE(isShown(home, piece));
  upstairs.visible = false;
  home.levels.set(level, upstairs);
  EXPECT_FALSE(isShown(home, piece));
}

TEST(Home, EqualityLooksIntoFiles) {
  const auto bytes = [](char c) { return std::make_shared<const Bytes>(Bytes{std::byte(c)}); };
  Home a, b;
  EXPECT_EQ(a, b);
  a.assets = std::make_shared<const Assets>(Assets{{"models/a.obj", bytes('a')}});
  EXPECT_FALSE(a == b);
  b.assets = std::make_shared<const Assets>(Assets{{"models/a.obj", bytes('a')}});
  EXPECT_EQ(a, b);
  b.assets = std::make_shared<const Assets>(Assets{{"models/a.obj", bytes('b')}});
  EXPECT_FALSE(a == b);
}

}  // namespace
}  // namespace idap
