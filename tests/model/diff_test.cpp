#include "model/diff.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/sample_home.h"

namespace idap {
namespace {

TEST(Diff, OfAHomeAndItsCopyIsEmpty) {
  const Home home = test::fullHome();
  EXPECT_TRUE(diff(home, Home(home)).empty());
  EXPECT_TRUE(diff(Home{}, Home{}).furniture.empty());
}

TEST(Diff, NamesWhatWasAddedRemovedAndChanged) {
  const Home before = test::smallFlat();
  Home after = before;
  const auto wall = before.walls.begin()->first;
  const auto door = before.openings.begin()->first;
  Wall thick = *before.walls.find(wall);
  thick.thickness = 0.4;
  after.walls.set(wall, thick);
  after.openings.erase(door);
  const auto camera = after.newId<CameraId>();
  after.cameras.set(camera, Camera{});
  after.title = "Other";
  const HomeDiff d = diff(before, after);
  EXPECT_EQ(d.walls.changed, std::vector{wall});
  EXPECT_EQ(d.openings.removed, std::vector{door});
  EXPECT_EQ(d.cameras.added, std::vector{camera});
  EXPECT_TRUE(d.texts);
  EXPECT_FALSE(d.site || d.assets || d.backgrounds || d.environment);
  EXPECT_TRUE(d.walls.added.empty() && d.furniture.empty());
  EXPECT_FALSE(d.empty());
}

TEST(Diff, DoesNotTakeAnEqualElementForAChange) {
  const Home before = test::smallFlat();
  Home after = before;
  for (const auto& [id, wall] : before.walls) after.walls.set(id, Wall(*wall));
  EXPECT_TRUE(diff(before, after).empty());
}

TEST(Diff, AgreesWithSetsAfterRandomEdits) {
  std::mt19937 random(3);
  const Home before = test::manyPieces(2000);
  for (int round = 0; round < 20; ++round) {
    Home after = before;
    std::set<FurnitureId> added, removed, changed;
    const int edits = 1 << (round / 2);
    for (int i = 0; i < edits; ++i) {
      const FurnitureId id{1 + random() % 2000};
      switch (random() % 3) {
        case 0:
          after.furniture.erase(id);
          removed.insert(id);
          changed.erase(id);
          break;
        case 1:
          if (const auto* piece = after.furniture.find(id)) {
            Furniture moved = *piece;
            moved.position.x += 1;
            after.furniture.set(id, moved);
            changed.insert(id);
          }
          break;
        default: {
          const auto fresh = after.newId<FurnitureId>();
          after.furniture.set(fresh, Furniture{});
          added.insert(fresh);
        }
      }
    }
    const auto d = diff(before, after).furniture;
    EXPECT_EQ(std::set(d.added.begin(), d.added.end()), added);
    EXPECT_EQ(std::set(d.removed.begin(), d.removed.end()), removed);
    EXPECT_EQ(std::set(d.changed.begin(), d.changed.end()), changed);
  }
}

TEST(Diff, SharesAllThatDidNotChange) {
  const Home before = test::manyPieces(10'000);
  Home after = before;
  Furniture moved = *before.furniture.find(FurnitureId{5'000});
  moved.angle = 1;
  after.furniture.set(FurnitureId{5'000}, moved);
  std::size_t shared = 0;
  const auto& a = before.furniture.chunks();
  const auto& b = after.furniture.chunks();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) shared += a[i] == b[i] ? 1 : 0;
  EXPECT_EQ(shared, a.size() - 1) << "a change copies one chunk and no more";
  EXPECT_EQ(diff(before, after).furniture.changed, std::vector{FurnitureId{5'000}});
}

}  // namespace
}  // namespace idap
