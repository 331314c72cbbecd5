// Walls that move take along what is joined to them.
#include <gtest/gtest.h>

#include "model/edits/element_edits.h"
#include "model/edits/wall_edits.h"
#include "model/validate.h"
#include "support/sample_home.h"
#include "support/wall_chain.h"

namespace idap {
namespace {

void expectNear(Vec2 a, Vec2 b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
}
WallId add(Home& home, Vec2 start, Vec2 end, LevelId level = {}) {
  Wall wall = test::wall(start, end);
  wall.level = level;
  WallEdit edit = addWall(home, wall);
  home = std::move(edit.home);
  return edit.wall;
}
const Wall& get(const Home& home, WallId id) { return *home.walls.find(id); }

TEST(WallMove, ACornerOfThreeWallsMovesAsOne) {
  Home home;
  const WallId a = add(home, {0, 0}, {4, 0}), b = add(home, {4, 0}, {4, 3}), c = add(home, {8, 0}, {4, 0});
  const Home moved = moveWallEnd(home, a, WallEnd::End, {5, 1});
  expectNear(get(moved, a).end, {5, 1});
  expectNear(get(moved, b).start, {5, 1});
  expectNear(get(moved, c).end, {5, 1});
  expectNear(get(moved, c).start, {8, 0});
  EXPECT_NO_THROW(requireValid(moved, home));
}

TEST(WallMove, WallsOfOtherLevelsStay) {
  Home home;
  const LevelId upstairs = home.newId<LevelId>();
  home.levels.set(upstairs, Level{});
  const WallId a = add(home, {0, 0}, {4, 0}), above = add(home, {4, 0}, {4, 3}, upstairs);
  expectNear(get(moveWallEnd(home, a, WallEnd::End, {5, 1}), above).start, {4, 0});
}

TEST(WallMove, AWallThatEndsOnAnotherStaysOnIt) {
  Home home;
  const WallId bottom = add(home, {0, 0}, {6, 0}), stem = add(home, {2, 3}, {2, 0});
  // Pushed outwards the stem grows; it does not lean over when the wall is shifted along itself.
  Elements chosen;
  chosen.walls = {bottom};
  Home moved = moveElements(home, chosen, {0.5, -1, 0});
  expectNear(get(moved, stem).end, {2, -1});
  expectNear(get(moved, stem).start, {2, 3});
  // Turned about its start, the stem reaches down to where the wall is now.
  moved = moveWallEnd(home, bottom, WallEnd::End, {6, -3});
  expectNear(get(moved, stem).end, {2, -1});
}

TEST(WallMove, AStemThatCannotReachItsWallAlongItsLineKeepsItsPlaceInIt) {
  Home home;
  const WallId bottom = add(home, {0, 0}, {6, 0}), stem = add(home, {2, 3}, {2, 0});
  Elements chosen;
  chosen.walls = {bottom};
  const Home moved = moveElements(home, chosen, {10, 0, 0});
  expectNear(get(moved, stem).end, {12, 0});
}

TEST(WallMove, AStemSlidesAlongTheWallItEndsOn) {
  const Home home = test::smallFlat();
  Elements chosen;
  chosen.walls = {WallId{5}};
  const Home moved = moveElements(home, chosen, {0.5, 0.3, 0});
  expectNear(get(moved, WallId{5}).start, {3.5, 0});
  expectNear(get(moved, WallId{5}).end, {3.5, 4});
  EXPECT_NEAR(moved.openings.find(OpeningId{6})->position.x, 3.5, 1e-9);
  EXPECT_NEAR(moved.openings.find(OpeningId{6})->position.y, 1, 1e-9);
  expectNear(get(moved, WallId{1}).end, {6, 0});
}

TEST(WallMove, WallsThatCrossOrRunAlongsideAreNotJoined) {
  Home home;
  const WallId a = add(home, {0, 0}, {6, 0}), across = add(home, {3, -2}, {3, 2}),
               beside = add(home, {1, 0.05}, {2, 0.05});
  Elements chosen;
  chosen.walls = {a};
  const Home moved = moveElements(home, chosen, {0, 1, 0});
  EXPECT_EQ(get(moved, across), get(home, across));
  EXPECT_EQ(get(moved, beside), get(home, beside));
}

TEST(WallMove, FollowersAreFollowedInTheirTurn) {
  Home home;
  const WallId bottom = add(home, {0, 0}, {6, 0}), right = add(home, {6, 0}, {6, 4}),
               stem = add(home, {3, 2}, {6, 2});
  const Home moved = moveWallEnd(home, bottom, WallEnd::End, {8, 0});
  expectNear(get(moved, right).start, {8, 0});
  expectNear(get(moved, stem).end, {7, 2});
}

TEST(WallMove, RoundWallsCarryTheirStems) {
  Home home;
  WallId arc = add(home, {-2, 0}, {2, 0});
  Wall round = get(home, arc);
  round.arcExtent = -kPi;
  home.walls.set(arc, round);
  const WallId stem = add(home, {0, 5}, {0, 2});
  Elements chosen;
  chosen.walls = {arc};
  const Home moved = moveElements(home, chosen, {0, 1, 0});
  expectNear(get(moved, stem).end, {0, 3});
  expectNear(get(moved, stem).start, {0, 5});
}

TEST(WallMove, ADoorKeepsItsPlaceWhenItsWallIsProlonged) {
  const Home home = test::smallFlat();
  const Vec3 window = home.openings.find(OpeningId{7})->position;
  EXPECT_EQ(moveWallEnd(home, WallId{1}, WallEnd::End, {8, 0}).openings.find(OpeningId{7})->position, window);
  const Home left = moveWallEnd(home, WallId{1}, WallEnd::Start, {-2, 0});
  EXPECT_NEAR(left.openings.find(OpeningId{7})->position.x, window.x, 1e-9);
}

TEST(WallMove, TurningWallsTurnsWhatIsInThem) {
  const Home home = test::smallFlat();
  Elements all = allElements(home);
  const Home turned = turnElements(home, all, {3, 2}, kPi);
  expectNear(get(turned, WallId{1}).start, {6, 4});
  const Opening& window = *turned.openings.find(OpeningId{7});
  EXPECT_NEAR(window.position.x, 1.5, 1e-9);
  EXPECT_NEAR(window.position.y, 4, 1e-9);
  EXPECT_NEAR(std::abs(window.angle), kPi, 1e-9);
}

}  // namespace
}  // namespace idap
