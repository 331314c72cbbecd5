#include "model/edits/arrange_edits.h"

#include <gtest/gtest.h>

#include "model/room_geometry.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

FurnitureId add(Home& home, Vec3 position, Vec3 size, double angle = 0) {
  Furniture piece;
  piece.position = position;
  piece.size = size;
  piece.angle = angle;
  const auto id = home.newId<FurnitureId>();
  home.furniture.set(id, piece);
  return id;
}
Vec3 at(const Home& home, FurnitureId id) { return home.furniture.find(id)->position; }
void expectNear(Vec3 a, Vec3 b) { EXPECT_LT(length(a - b), 1e-9) << a.x << ' ' << a.y << ' ' << a.z; }

struct Three {
  Home home;
  FurnitureId a, b, c;
  Elements all;
};
// The first is 2 x 1, the others 1 x 2 and 0.5 x 0.5.
Three three(double angle = 0) {
  Three t;
  t.a = add(t.home, {0, 0, 0}, {2, 1, 1}, angle);
  t.b = add(t.home, {5, 3, 0}, {1, 2, 1}, angle);
  t.c = add(t.home, {-4, 1, 0.5}, {0.5, 0.5, 1}, angle);
  t.all.furniture = {t.a, t.b, t.c};
  return t;
}

TEST(Align, EdgesAndMiddlesFollowTheFirst) {
  const Three t = three();
  const auto b = [&](Alignment way) { return at(alignElements(t.home, t.all, way), t.b); };
  expectNear(b(Alignment::Left), {-0.5, 3, 0});
  expectNear(b(Alignment::Right), {0.5, 3, 0});
  expectNear(b(Alignment::CentreHorizontal), {0, 3, 0});
  expectNear(b(Alignment::Top), {5, -0.5, 0});
  expectNear(b(Alignment::Bottom), {5, 0.5, 0});
  expectNear(b(Alignment::CentreVertical), {5, 0, 0});
  const Home left = alignElements(t.home, t.all, Alignment::Left);
  expectNear(at(left, t.a), {0, 0, 0});
  expectNear(at(left, t.c), {-0.75, 1, 0.5});
  EXPECT_EQ(alignElements(left, t.all, Alignment::Left), left) << "nothing more to do";
}

TEST(Align, SidesAreThoseOfATurnedLead) {
  const Three t = three(kPi / 2);  // its back faces -x, its right hand +y
  const auto b = [&](Alignment way) { return at(alignElements(t.home, t.all, way), t.b); };
  expectNear(b(Alignment::BackSide), {0.5, 3, 0});
  expectNear(b(Alignment::FrontSide), {-0.5, 3, 0});
  expectNear(b(Alignment::RightSide), {5, 0.5, 0});
  expectNear(b(Alignment::LeftSide), {5, -0.5, 0});
}

TEST(Align, SideBySideMakesARowWithoutGaps) {
  const Three t = three();
  const Home row = alignElements(t.home, t.all, Alignment::SideBySide);
  expectNear(at(row, t.a), {0, 0, 0});
  expectNear(at(row, t.b), {1.5, -0.5, 0});      // to the right, backs in line
  expectNear(at(row, t.c), {-1.25, 0.25, 0.5});  // to the left
}

TEST(Align, WhatIsLockedLeadsAndStays) {
  Three t = three();
  Furniture locked = *t.home.furniture.find(t.c);
  locked.locked = true;
  t.home.furniture.set(t.c, locked);
  const Home left = alignElements(t.home, t.all, Alignment::Left);
  expectNear(at(left, t.c), {-4, 1, 0.5});
  expectNear(at(left, t.a), {-4.25 + 1, 0, 0});
}

TEST(Align, PiecesLineUpWithAWindowThatItsWallHolds) {
  const Home home = test::smallFlat();
  Elements both;
  both.openings = {OpeningId{7}};
  both.furniture = {FurnitureId{9}};
  const Home aligned = alignElements(home, both, Alignment::CentreHorizontal);
  EXPECT_EQ(aligned.openings, home.openings);
  EXPECT_NEAR(at(aligned, FurnitureId{9}).x, 4.5, 1e-12);
}

TEST(Align, GroupsMoveAsOne) {
  Three t = three();
  Elements pair;
  pair.furniture = {t.b, t.c};
  const GroupEdit grouped = groupElements(t.home, pair, "Pair");
  Elements chosen;
  chosen.furniture = {t.a};
  chosen.groups = {grouped.group};
  const Home left = alignElements(grouped.home, chosen, Alignment::Left);
  expectNear(at(left, t.c) - at(left, t.b), at(t.home, t.c) - at(t.home, t.b));
  EXPECT_NEAR(at(left, t.c).x, -0.75, 1e-12);
}

TEST(Distribute, TheGapsBecomeEqual) {
  Three t = three();
  const FurnitureId d = add(t.home, {2, 7, 0}, {1, 1, 1});
  t.all.furniture.push_back(d);
  const Home home = distributeElements(t.home, t.all, true);
  // Widths 0.5, 2, 1, 1 from -4.25 to 5.5: gaps of 1.75.
  expectNear(at(home, t.c), at(t.home, t.c));
  expectNear(at(home, t.b), at(t.home, t.b));
  EXPECT_NEAR(at(home, t.a).x, -3.75 + 1.75 + 1, 1e-9);
  EXPECT_NEAR(at(home, d).x, -3.75 + 1.75 + 2 + 1.75 + 0.5, 1e-9);
  EXPECT_EQ(at(home, d).y, 7);
  Elements two;
  two.furniture = {t.a, t.b};
  EXPECT_EQ(distributeElements(t.home, two, false), t.home);
}

TEST(Mirror, OnePieceChangesHandsWhereItStands) {
  Three t = three(0.3);
  Elements one;
  one.furniture = {t.b};
  const Home mirrored = mirrorElements(t.home, one);
  const Furniture& piece = *mirrored.furniture.find(t.b);
  EXPECT_TRUE(piece.mirrored);
  EXPECT_EQ(piece.angle, 0.3);
  expectNear(piece.position, {5, 3, 0});
  EXPECT_EQ(mirrorElements(mirrored, one), t.home);
}

TEST(Mirror, SeveralPiecesAreSeenAsInAMirror) {
  Three t = three(0.3);
  const Home mirrored = mirrorElements(t.home, t.all);
  // Every point of every piece lies where the mirror image of one of the same piece's did.
  double axis = 0;
  for (const FurnitureId id : t.all.furniture) {
    const Transform was = placement(*t.home.furniture.find(id)), is = placement(*mirrored.furniture.find(id));
    const Vec3 p{0.2, 0.1, 0.7};
    const Vec3 a = was.point(p), b = is.point(p);
    if (axis == 0) axis = (a.x + b.x) / 2;
    EXPECT_NEAR((a.x + b.x) / 2, axis, 1e-9);
    EXPECT_NEAR(a.y, b.y, 1e-9);
    EXPECT_NEAR(a.z, b.z, 1e-9);
  }
}

TEST(FlipPlan, TwiceIsTheSamePlan) {
  for (const bool horizontally : {true, false}) {
    const Home home = test::smallFlat();
    const Home once = flipPlan(home, horizontally);
    EXPECT_NO_THROW(requireValid(once, home));
    const Opening& window = *once.openings.find(OpeningId{7});
    EXPECT_NEAR(window.position.x, horizontally ? 1.5 : 4.5, 1e-9);
    EXPECT_NEAR(window.position.y, horizontally ? 0 : 4, 1e-9);
    EXPECT_TRUE(window.mirrored);
    EXPECT_EQ(closedAreas(once, {}).size(), 2u);
    const Home twice = flipPlan(once, horizontally);
    for (const auto& [id, wall] : home.walls) {
      EXPECT_LT(length(twice.walls.find(id)->start - wall->start), 1e-9);
      EXPECT_EQ(twice.walls.find(id)->left, wall->left);
    }
    EXPECT_LT(length(at(twice, FurnitureId{9}) - at(home, FurnitureId{9})), 1e-9);
    EXPECT_FALSE(twice.openings.find(OpeningId{7})->mirrored);
  }
}

TEST(FlipPlan, RoundWallsTextAndViewsAreFlippedToo) {
  Home home = test::fullHome();
  const Home flipped = flipPlan(home, true);
  EXPECT_NO_THROW(requireValid(flipped, home));
  const Wall &was = *home.walls.begin()->second, &is = *flipped.walls.begin()->second;
  EXPECT_EQ(is.arcExtent, -was.arcExtent);
  EXPECT_EQ(is.left, was.right);
  const Camera &before = *home.cameras.begin()->second, &after = *flipped.cameras.begin()->second;
  EXPECT_NEAR(viewDirection(after).x, -viewDirection(before).x, 1e-12);
  EXPECT_NEAR(viewDirection(after).y, viewDirection(before).y, 1e-12);
  const Label& label = *flipped.labels.begin()->second;
  EXPECT_GT(std::cos(label.angle), 0) << "text stays upright";
  EXPECT_EQ(label.style.alignment, TextAlignment::Left) << "and goes on to the other side";
}

TEST(ResetElevations, PiecesStandOnWhatIsUnderThem) {
  Home home;
  const FurnitureId table = add(home, {0, 0, 0.4}, {2, 1, 0.75}),
                    vase = add(home, {0.5, 0.2, 0.4}, {0.2, 0.2, 0.3}),
                    chair = add(home, {3, 0, 0.1}, {0.5, 0.5, 0.9}),
                    lamp = add(home, {0, 0, 2}, {2.5, 2, 0.5});
  Elements all;
  all.furniture = {table, vase, chair};
  const Home reset = resetElevations(home, all);
  EXPECT_DOUBLE_EQ(at(reset, table).z, 0);
  EXPECT_DOUBLE_EQ(at(reset, chair).z, 0);
  EXPECT_DOUBLE_EQ(at(reset, vase).z, 0.75) << "where the table's top is now";
  EXPECT_EQ(at(reset, lamp).z, 2);
  Home shelf = home;
  Furniture open = *home.furniture.find(table);
  open.dropOnTopHeight = 0.3;
  shelf.furniture.set(table, open);
  EXPECT_DOUBLE_EQ(at(resetElevations(shelf, all), vase).z, 0.3);
}

}  // namespace
}  // namespace idap
