#include "model/edits/level_edits.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "model/validate.h"
#include "support/sample_home.h"

namespace idap {
namespace {

double elevation(const Home& home, LevelId id) { return home.levels.find(id)->elevation; }

struct House {
  Home home;
  LevelId ground, first, second;
};
House house() {
  LevelEdit ground = withLevels(test::smallFlat(), "Ground");
  LevelEdit first = addLevel(ground.home, ground.level, "First");
  LevelEdit second = addLevel(first.home, first.level, "Second");
  return {second.home, ground.level, first.level, second.level};
}

TEST(LevelEdits, AHomeWithoutLevelsBecomesTheGround) {
  Home home = test::smallFlat();
  home.wallHeight = 2.8;
  const LevelEdit edit = withLevels(home, "Ground");
  EXPECT_EQ(edit.home.levels.size(), 1u);
  EXPECT_EQ(edit.home.levels.find(edit.level)->name, "Ground");
  EXPECT_EQ(edit.home.levels.find(edit.level)->height, 2.8);
  for (const auto& [id, wall] : edit.home.walls) EXPECT_EQ(wall->level, edit.level);
  for (const auto& [id, opening] : edit.home.openings) EXPECT_EQ(opening->level, edit.level);
  for (const auto& [id, piece] : edit.home.furniture) EXPECT_EQ(piece->level, edit.level);
  EXPECT_NO_THROW(requireValid(edit.home, home));
  EXPECT_EQ(withLevels(edit.home, "Again").home, edit.home);
  EXPECT_EQ(withLevels(edit.home, "Again").level, edit.level);
}

TEST(LevelEdits, TheBackgroundOfAHomeWithoutLevelsGoesToTheGround) {
  Home home = test::fullHome();
  home.levels = {};
  home.backgrounds = {{LevelId{}, Background{"pictures/plan.png", 0.01, {}, true}}};
  const LevelEdit edit = withLevels(home, "Ground");
  EXPECT_TRUE(edit.home.backgrounds.contains(edit.level));
  EXPECT_FALSE(edit.home.backgrounds.contains(LevelId{}));
}

TEST(LevelEdits, AddedLevelsStandOnTheCurrentOne) {
  const House h = house();
  EXPECT_DOUBLE_EQ(elevation(h.home, h.first), 2.5 + 0.12);
  EXPECT_DOUBLE_EQ(elevation(h.home, h.second), 2 * (2.5 + 0.12));
  EXPECT_EQ(levelsInOrder(h.home), (std::vector<LevelId>{h.ground, h.first, h.second}));
  // Between two others it lifts what is above, and who stands there.
  Home home = h.home;
  const CameraId below = home.newId<CameraId>(), above = home.newId<CameraId>();
  home.cameras.set(below, Camera{.eye = {1, 1, 1.6}});
  home.cameras.set(above, Camera{.eye = {1, 1, 2.62 + 1.6}});
  const LevelEdit between = addLevel(home, h.ground, "Between");
  EXPECT_DOUBLE_EQ(elevation(between.home, between.level), 2.62);
  EXPECT_DOUBLE_EQ(elevation(between.home, h.first), 2 * 2.62);
  EXPECT_DOUBLE_EQ(elevation(between.home, h.second), 3 * 2.62);
  EXPECT_EQ(between.home.cameras.find(below)->eye.z, 1.6);
  EXPECT_DOUBLE_EQ(between.home.cameras.find(above)->eye.z, 2 * 2.62 + 1.6);
  EXPECT_NO_THROW(requireValid(between.home, home));
  EXPECT_THROW(addLevel(home, LevelId{99}, "Nowhere"), InvalidHome);
}

TEST(LevelEdits, WhereThereIsRoomNothingIsLifted) {
  House h = house();
  Level attic = *h.home.levels.find(h.second);
  attic.elevation = 50;
  h.home = setLevel(h.home, h.second, attic);
  const LevelEdit between = addLevel(h.home, h.first, "Between");
  EXPECT_EQ(elevation(between.home, h.second), 50);
}

TEST(LevelEdits, ALevelAtTheSameElevationComesAfterIt) {
  const House h = house();
  const LevelEdit beside = addLevel(h.home, h.first, "Variant", true);
  EXPECT_EQ(elevation(beside.home, beside.level), elevation(beside.home, h.first));
  EXPECT_EQ(levelsInOrder(beside.home), (std::vector<LevelId>{h.ground, h.first, beside.level, h.second}));
  const Home swapped = reorderLevel(beside.home, beside.level, false);
  EXPECT_EQ(levelsInOrder(swapped), (std::vector<LevelId>{h.ground, beside.level, h.first, h.second}));
  EXPECT_EQ(elevation(swapped, h.second), elevation(beside.home, h.second));
}

TEST(LevelEdits, LevelsChangePlacesAndStandOnEachOther) {
  House h = house();
  Level high = *h.home.levels.find(h.first);
  high.height = 4;
  high.floorThickness = 0.3;
  h.home.levels.set(h.first, high);
  const Home up = reorderLevel(h.home, h.ground, true);
  EXPECT_EQ(levelsInOrder(up), (std::vector<LevelId>{h.first, h.ground, h.second}));
  EXPECT_EQ(elevation(up, h.first), 0);
  const Home back = reorderLevel(up, h.ground, false);
  for (const LevelId id : {h.ground, h.first, h.second})
    EXPECT_NEAR(elevation(back, id), elevation(h.home, id), 1e-12);
  EXPECT_EQ(reorderLevel(h.home, h.ground, false), h.home);
  EXPECT_EQ(reorderLevel(h.home, h.second, true), h.home);
}

TEST(LevelEdits, DeletingALevelTakesWhatStandsOnIt) {
  const House h = house();
  const Home left = deleteLevel(h.home, h.ground);
  EXPECT_TRUE(left.walls.empty() && left.openings.empty() && left.furniture.empty() && left.groups.empty());
  EXPECT_EQ(left.levels.size(), 2u);
  EXPECT_NO_THROW(requireValid(left, h.home));
  EXPECT_THROW(deleteLevel(deleteLevel(left, h.first), h.second), InvalidHome);
  EXPECT_THROW(deleteLevel(h.home, LevelId{99}), InvalidHome);
}

TEST(LevelEdits, QueriesKnowWhatLiesBelow) {
  House h = house();
  EXPECT_EQ(levelBelow(h.home, h.second), h.first);
  EXPECT_EQ(levelBelow(h.home, h.ground), LevelId{});
  EXPECT_EQ(levelBelow(Home{}, LevelId{}), LevelId{});
  Level closed = *h.home.levels.find(h.first);
  closed.viewable = false;
  h.home.levels.set(h.first, closed);
  EXPECT_EQ(levelBelow(h.home, h.second), h.ground);
  EXPECT_EQ(ceilingHeight(h.home, h.first), 2.5);
  Home flat;
  flat.wallHeight = 2.7;
  EXPECT_EQ(ceilingHeight(flat, LevelId{}), 2.7);
  Wall wall;
  wall.end = {3, 0};
  wall.heightAtStart = wall.heightAtEnd = 2.6;
  flat.walls.set(flat.newId<WallId>(), wall);
  EXPECT_DOUBLE_EQ(ceilingHeight(flat, LevelId{}), 2.6);
  EXPECT_EQ(newWallHeight(flat, LevelId{}), 2.7);
}

}  // namespace
}  // namespace idap
