#include "editor/snap.h"

#include <gtest/gtest.h>

#include "editor/tools/tool_driver.h"
#include "model/wall_path.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

struct Snap : ToolDriver {
  // Clear inside: 0.1 .. 4.9 by 0.1 .. 3.9.
  Snap() { walls = test::addWalls(home_, {{0, 0}, {5, 0}, {5, 4}, {0, 4}}); }
  FurnitureId put(Vec3 position, Vec3 size) {
    const auto id = home_.newId<FurnitureId>();
    Furniture piece;
    piece.position = position;
    piece.size = size;
    home_.furniture.set(id, piece);
    return id;
  }
  void open() { editor.open(std::make_unique<Document>(home_)); }
  SnappedPoint point(SnapRequest request) {
    open();
    return snapPoint(editor, request, false);
  }
  SnappedPiece piece(Vec3 position, Vec3 size, bool mayTurn = false, Plane plane_ = Plane::XY) {
    open();
    PieceSnapRequest request;
    request.plane = plane_;
    request.piece.position = position;
    request.piece.size = size;
    request.mayTurn = mayTurn;
    return snapPiece(editor, request, false);
  }
  Home home_;
  std::vector<WallId> walls;
};

TEST_F(Snap, EndGoesBeforeLine) {
  const SnappedPoint p = point({.at = {5.05, 4.04}});
  EXPECT_EQ(p.to, SnappedPoint::To::End);
  EXPECT_EQ(p.at, (Vec2{5, 4}));
}

TEST_F(Snap, LineWhereNoEndIsNear) {
  const SnappedPoint p = point({.at = {2, 0.06}});
  EXPECT_EQ(p.to, SnappedPoint::To::Line);
  expectNear(p.at, {2, 0});
}

TEST_F(Snap, FacesOnlyWhereWanted) {
  EXPECT_EQ(point({.at = {2, 0.15}}).to, SnappedPoint::To::Nothing);
  const SnappedPoint p = point({.at = {2, 0.15}, .wallFaces = true});
  expectNear(p.at, {2, 0.1});
}

TEST_F(Snap, RugsLieAsTheyAreTurned) {
  const SnappedPiece wardrobe = piece({4.5, 2, 0}, {1, 0.6, 2}, true);
  EXPECT_TRUE(wardrobe.onWall);
  EXPECT_NE(wardrobe.angle, 0);
  const SnappedPiece rug = piece({4.5, 2, 0}, {1, 0.6, 0.01}, true);
  EXPECT_FALSE(rug.onWall);
  EXPECT_EQ(rug.angle, 0);
}

TEST_F(Snap, AnglesInStepsOfFifteenDegrees) {
  const SnappedPoint p = point({.at = {3, 2.06}, .from = Vec2{1, 2}});
  EXPECT_EQ(p.to, SnappedPoint::To::Angle);
  EXPECT_NEAR(p.at.y, 2, 1e-9);
  const SnappedPoint against = point({.at = {2.0, 2.64}, .from = Vec2{1, 2}, .along = 0.3});
  const double angle = std::atan2(against.at.y - 2, against.at.x - 1);
  EXPECT_NEAR(std::remainder(angle - 0.3, kPi / 12), 0, 1e-9);
}

TEST_F(Snap, AngleMeetsTheWall) {
  const SnappedPoint p = point({.at = {4.97, 2.05}, .from = Vec2{1, 2}});
  EXPECT_EQ(p.to, SnappedPoint::To::Crossing);
  expectNear(p.at, {5, 2});
  EXPECT_FALSE(p.guides.empty());
}

TEST_F(Snap, OwnPointsCloseTheLine) {
  const SnappedPoint p = point({.at = {2.05, 2.05}, .from = Vec2{3, 3}, .own = {{2, 2}}});
  EXPECT_EQ(p.to, SnappedPoint::To::Own);
  EXPECT_EQ(p.at, (Vec2{2, 2}));
}

TEST_F(Snap, LinesUpWithEndsFarAway) {
  home_.walls.set(home_.newId<WallId>(), test::wall({2, 1}, {3, 1.7}));
  const SnappedPoint p = point({.at = {2.03, 3}});
  EXPECT_EQ(p.to, SnappedPoint::To::Alignment);
  EXPECT_NEAR(p.at.x, 2, 1e-9);
  EXPECT_EQ(p.guides.size(), 1u);
}

TEST_F(Snap, AltAndTheSettingTurnItOff) {
  open();
  EXPECT_EQ(snapPoint(editor, {.at = {5.05, 4.04}}, true).at, (Vec2{5.05, 4.04}));
  EditorSettings settings = editor.settings();
  settings.snapping = false;
  settings.gridSnapping = true;
  editor.setSettings(settings);
  const SnappedPoint p = snapPoint(editor, {.at = {1.23, 0.87}, .tolerance = 0.1}, false);
  EXPECT_EQ(p.to, SnappedPoint::To::Grid);
  expectNear(p.at, {1.2, 0.9});
}

TEST_F(Snap, SideViewSnapsToFloorAndCeiling) {
  EXPECT_NEAR(point({.plane = Plane::XZ, .at = {2, 0.05}}).at.y, 0, 1e-9);
  EXPECT_NEAR(point({.plane = Plane::XZ, .at = {2, 2.45}}).at.y, 2.5, 1e-9);
}

TEST_F(Snap, PieceGoesFlushAgainstTheWall) {
  const SnappedPiece p = piece({2, 3.55, 0}, {1, 0.6, 1});
  EXPECT_NEAR(p.position.y, 3.9 - 0.3, 1e-9);
  EXPECT_TRUE(p.onWall);
  EXPECT_FALSE(p.guides.empty());
}

TEST_F(Snap, PieceTurnsItsBackToTheWall) {
  const SnappedPiece p = piece({0.45, 1.3, 0}, {1, 0.6, 1}, true);
  EXPECT_NEAR(p.position.x, 0.1 + 0.3, 1e-9);
  EXPECT_NEAR(std::remainder(p.angle - kPi / 2, 2 * kPi), 0, 1e-9);
  EXPECT_TRUE(p.onWall);
  EXPECT_EQ(piece({2.3, 1.3, 0}, {1, 0.6, 1}, true).angle, 0);  // too far
}

TEST_F(Snap, PieceFindsTheCorner) {
  const SnappedPiece p = piece({0.66, 3.55, 0}, {1, 0.6, 1}, true);
  EXPECT_NEAR(p.position.x, 0.6, 1e-9);
  EXPECT_NEAR(p.position.y, 3.6, 1e-9);
}

TEST_F(Snap, PieceGoesFlushWithItsNeighbour) {
  put({2, 2, 0}, {1, 1, 1});
  const SnappedPiece p = piece({3.06, 2.02, 0}, {1, 1, 0.7});
  EXPECT_NEAR(p.position.x, 3, 1e-9);
  EXPECT_NEAR(p.position.y, 2, 1e-9);
}

TEST_F(Snap, LampStandsOnTheTable) {
  put({2, 2, 0}, {1.6, 0.9, 0.75});
  const SnappedPiece p = piece({2.3, 2.2, 0}, {0.3, 0.3, 0.5});
  EXPECT_TRUE(p.stacked);
  EXPECT_NEAR(p.position.z, 0.75, 1e-9);
  EXPECT_NEAR(piece({2, 2, 0}, {2.5, 2, 0.5}).position.z, 0, 1e-9);       // too large for it
  EXPECT_NEAR(piece({2, 1.6, 0}, {0.5, 0.5, 0.9}).position.z, 0, 1e-9);   // a chair stays on the floor
  EXPECT_NEAR(piece({4, 1, 0.75}, {0.3, 0.3, 0.5}).position.z, 0, 1e-9);  // taken off the table
}

TEST_F(Snap, RoundWallHoldsAPieceByItsTangent) {
  home_ = {};
  Wall wall = test::wall({0, 0}, {4, 0});
  wall.arcExtent = kPi / 2;
  home_.walls.set(home_.newId<WallId>(), wall);
  const WallPath path(wall);
  const Vec2 line = path.point(path.length() / 2);
  const SnappedPiece p = piece({line.x, line.y + 0.5, 0}, {0.8, 0.6, 1}, true);
  EXPECT_NEAR(p.position.y, line.y + 0.1 + 0.3, 1e-3);
  EXPECT_NEAR(std::abs(std::remainder(p.angle, 2 * kPi)), kPi, 1e-6);
}

TEST_F(Snap, HeightSnapsFromTheSide) {
  put({2, 2, 0}, {1.6, 0.9, 0.75});
  EXPECT_NEAR(piece({2.4, 2, 0.8}, {0.3, 0.3, 0.5}, false, Plane::XZ).position.z, 0.75, 1e-9);
  EXPECT_NEAR(piece({3.9, 2, 0.06}, {0.3, 0.3, 0.5}, false, Plane::XZ).position.z, 0, 1e-9);
  EXPECT_NEAR(piece({3.9, 2, 1.95}, {0.3, 0.3, 0.5}, false, Plane::XZ).position.z, 2, 1e-9);
  EXPECT_NEAR(piece({4.7, 2, 0}, {0.3, 0.3, 0.5}, false, Plane::XZ).position.x, 4.75, 1e-9);
}

TEST_F(Snap, ClearancesReachTheWallsAndPieces) {
  put({4, 2, 0}, {1, 1, 1});
  open();
  Piece chair;
  chair.position = {2, 2, 0};
  chair.size = {0.5, 0.5, 0.9};
  const std::vector<MeasureLine> lines = clearances(editor, Plane::XY, chair, {});
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_NEAR(length(lines[0].to - lines[0].from), 1.75 - 0.1, 1e-6);  // left wall
  EXPECT_NEAR(length(lines[1].to - lines[1].from), 1.25, 1e-6);        // the piece
  EXPECT_NEAR(length(lines[2].to - lines[2].from), 1.65, 1e-6);
  EXPECT_NEAR(length(lines[3].to - lines[3].from), 1.65, 1e-6);
  chair.position.z = 1.2;  // above the piece
  EXPECT_NEAR(length(clearances(editor, Plane::XY, chair, {})[1].to - Vec2{2.25, 2}), 4.9 - 2.25, 1e-6);
  const std::vector<MeasureLine> side = clearances(editor, Plane::XZ, chair, {});
  ASSERT_EQ(side.size(), 4u);
  EXPECT_NEAR(length(side[2].to - side[2].from), 1.2, 1e-6);
  EXPECT_NEAR(length(side[3].to - side[3].from), 0.4, 1e-6);
}

TEST_F(Snap, DoorJumpsIntoTheWall) {
  open();
  Opening door = makeOpening(*editor.catalog().find("idap/door-flush"), {});
  const auto in = snapOpening(editor, door, {2, 0.25}, 0.3);
  ASSERT_TRUE(in);
  EXPECT_EQ(in->wall, walls[0]);
  EXPECT_NEAR(in->position.x, 2, 1e-9);
  EXPECT_NEAR(in->position.y, 0, 1e-9);
  EXPECT_NEAR(in->size.y, 0.2, 1e-9);                   // as thick as the wall
  expectNear(rotated(Vec2{0, -1}, in->angle), {0, 1});  // opens to the pointer's side
  const auto other = snapOpening(editor, door, {2, -0.25}, 0.3);
  ASSERT_TRUE(other);
  expectNear(rotated(Vec2{0, -1}, other->angle), {0, -1});
  EXPECT_FALSE(snapOpening(editor, door, {2, 2}, 0.3));
}

TEST_F(Snap, DoorKeepsToTheWallsLengthAndFreePlaces) {
  open();
  const Opening door = makeOpening(*editor.catalog().find("idap/door-flush"), {});
  const auto atCorner = snapOpening(editor, door, {0.1, 0.2}, 0.3);
  ASSERT_TRUE(atCorner);
  const double edge = atCorner->wall == walls[0] ? atCorner->position.x : atCorner->position.y;
  EXPECT_NEAR(edge, 0.1 + 0.45, 1e-9);
  auto first = snapOpening(editor, door, {2, 0.2}, 0.3);
  home_.openings.set(home_.newId<OpeningId>(), *first);
  open();
  const auto second = snapOpening(editor, door, {2.2, 0.2}, 0.3);
  ASSERT_TRUE(second);
  EXPECT_NEAR(second->position.x, 2.9, 1e-9);
}

TEST_F(Snap, GridStepsAreRoundLengths) {
  EXPECT_DOUBLE_EQ(gridStep(0.03, LengthUnit::Centimetre), 0.05);
  EXPECT_DOUBLE_EQ(gridStep(0.1, LengthUnit::Metre), 0.1);
  EXPECT_DOUBLE_EQ(gridStep(0.2, LengthUnit::FeetInches), 0.3048);
}

}  // namespace
}  // namespace idap
