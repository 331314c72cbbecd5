#include "editor/finish_drag.h"

#include <gtest/gtest.h>

#include "model/edits/finish_edits.h"
#include "support/wall_chain.h"

namespace idap::test {
namespace {

class FinishDragTest : public testing::Test {
 protected:
  void SetUp() override {
    Home home;
    addWalls(home, {{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    Room room;
    room.points = {{0.05, 0.05}, {3.95, 0.05}, {3.95, 3.95}, {0.05, 3.95}};
    home.rooms.set(home.newId<RoomId>(), room);
    editor_.open(std::make_unique<Document>(home));
  }
  Editor editor_{std::make_shared<const Catalog>(std::vector<std::filesystem::path>())};
};

TEST_F(FinishDragTest, OnThePlanItIsTheFloorOrTheNearerSideOfAWall) {
  const auto floor = partAt(editor_, Plane::XY, {2, 2}, 0.01);
  ASSERT_TRUE(floor && std::holds_alternative<RoomId>(floor->first));
  EXPECT_EQ(floor->second, kPartFloor);
  const auto inside = partAt(editor_, Plane::XY, {2, 0.03}, 0.01),
             outside = partAt(editor_, Plane::XY, {2, -0.03}, 0.01);
  ASSERT_TRUE(inside && outside && std::holds_alternative<WallId>(inside->first));
  EXPECT_EQ(inside->second, kPartLeft);
  EXPECT_EQ(outside->second, kPartRight);
  EXPECT_FALSE(partAt(editor_, Plane::XY, {20, 20}, 0.01));
}

TEST_F(FinishDragTest, OnlyWhatItIsHeldOverShowsItAndDropMakesOneStep) {
  Finish oak;
  oak.material = "oak";
  const auto floor = partAt(editor_, Plane::XY, {2, 2}, 0.01),
             wall = partAt(editor_, Plane::XY, {2, 0.03}, 0.01);
  {
    FinishDrag drag(editor_, oak);
    drag.over(wall);
    drag.over(floor);
    EXPECT_TRUE(editor_.home().walls.find(std::get<WallId>(wall->first))->left.finish.empty());
    EXPECT_EQ(editor_.home().rooms.begin()->second->floor.material, "oak");
    drag.drop();
  }
  EXPECT_EQ(editor_.home().rooms.begin()->second->floor.material, "oak");
  editor_.undo();
  EXPECT_TRUE(editor_.home().rooms.begin()->second->floor.empty());
  EXPECT_FALSE(editor_.document().canUndo());
}

}  // namespace
}  // namespace idap::test
