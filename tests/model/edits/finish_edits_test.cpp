#include "model/edits/finish_edits.h"

#include <gtest/gtest.h>

#include "support/wall_chain.h"

namespace idap::test {
namespace {

Finish of(const char* material) {
  Finish finish;
  finish.material = material;
  return finish;
}

TEST(FinishEdits, OneSideOfAWallOrBoth) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}, {4, 4}});
  const WallId id = home.walls.begin()->first;
  Elements wall;
  wall.walls = {id};
  Home next = withFinish(home, wall, kPartRight, of("brick"));
  EXPECT_EQ(next.walls.find(id)->right.finish.material, "brick");
  EXPECT_TRUE(next.walls.find(id)->left.finish.empty());
  next = withFinish(next, wall, {}, of("oak"));
  EXPECT_EQ(next.walls.find(id)->right.finish.material, "oak");
  EXPECT_EQ(next.walls.find(id)->left.finish.material, "oak");
}

TEST(FinishEdits, ABaseboardOnlyWhereThereIsOne) {
  Home home;
  addWalls(home, {{0, 0}, {4, 0}});
  const WallId id = home.walls.begin()->first;
  Elements wall;
  wall.walls = {id};
  EXPECT_EQ(withFinish(home, wall, kPartBaseboardLeft, of("oak")), home);
}

TEST(FinishEdits, ARoomHasAFloorAndACeiling) {
  Home home;
  const RoomId id = home.newId<RoomId>();
  Room room;
  room.points = {{0, 0}, {4, 0}, {4, 4}};
  home.rooms.set(id, room);
  Elements rooms;
  rooms.rooms = {id};
  EXPECT_EQ(withFinish(home, rooms, kPartCeiling, of("oak")).rooms.find(id)->ceiling.material, "oak");
  EXPECT_EQ(withFinish(home, rooms, {}, of("oak")).rooms.find(id)->floor.material, "oak");
  EXPECT_TRUE(withFinish(home, rooms, {}, of("oak")).rooms.find(id)->ceiling.empty());
}

TEST(FinishEdits, APartOfAPieceAndAnEmptyFinishTakesItAway) {
  Home home;
  const FurnitureId id = home.newId<FurnitureId>();
  home.furniture.set(id, Furniture{});
  Elements pieces;
  pieces.furniture = {id};
  const Home painted = withFinish(home, pieces, "seat", of("oak"));
  EXPECT_EQ(painted.furniture.find(id)->slotFinishes.at("seat").material, "oak");
  EXPECT_TRUE(withFinish(painted, pieces, "seat", {}).furniture.find(id)->slotFinishes.empty());
}

}  // namespace
}  // namespace idap::test
