#include "scene/bake_furniture.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "catalog/model_file.h"

namespace idap {
namespace {

class BakeFurnitureTest : public testing::Test {
 protected:
  FurnitureId put(const char* id, Vec3 at, double angle = 0) {
    const FurnitureId made = home_.newId<FurnitureId>();
    home_.furniture.set(made, makeFurniture(*catalog_.find(id), at, angle));
    chosen_.furniture.push_back(made);
    return made;
  }
  SurfaceModel read(const BakedFurniture& baked) {
    return readModelFile(*baked.files.at(baked.main), baked.main,
                         [&](const std::string& path) -> SharedBytes {
                           const auto file = baked.files.find(path);
                           return file == baked.files.end() ? nullptr : file->second;
                         });
  }
  Catalog catalog_{std::vector<std::filesystem::path>{}};
  Home home_;
  Elements chosen_;
};

TEST_F(BakeFurnitureTest, OnePieceKeepsItsSizeAndItsParts) {
  const FurnitureId chair = put("idap/chair-windsor", {3, 4, 0});
  const BakedFurniture baked = bakeFurniture(home_, catalog_, chosen_);
  const Vec3 size = home_.furniture.find(chair)->size;
  EXPECT_NEAR(baked.size.x, size.x, 0.02);
  EXPECT_NEAR(baked.size.y, size.y, 0.02);
  EXPECT_NEAR(baked.size.z, size.z, 0.02);
  const SurfaceModel model = read(baked);
  EXPECT_EQ(model.slots.size(), baked.slots.size());
  EXPECT_GT(model.mesh.triangles.size(), 100u);
  EXPECT_NEAR(model.fileSize.z, size.z, 0.02);
}

TEST_F(BakeFurnitureTest, TwoPiecesBecomeOneAsWideAsBoth) {
  put("idap/chair-windsor", {0, 0, 0});
  put("idap/chair-windsor", {2, 0, 0}, kPi / 2);
  const BakedFurniture baked = bakeFurniture(home_, catalog_, chosen_);
  EXPECT_GT(baked.size.x, 2.3);
  EXPECT_LT(baked.size.x, 2.8);
}

TEST_F(BakeFurnitureTest, ATurnedPieceIsSavedAsItWasBeforeItWasTurned) {
  const FurnitureId wardrobe = put("idap/wardrobe-hinged", {3, 4, 0}, kPi / 2);
  put("idap/night-table", {3, 5, 0}, kPi / 2);
  const BakedFurniture baked = bakeFurniture(home_, catalog_, chosen_);
  const Vec3 size = home_.furniture.find(wardrobe)->size;
  ASSERT_GT(size.x, size.y + 0.3);
  EXPECT_GT(baked.size.x, size.x);
  EXPECT_LT(baked.size.y, size.x);
}

TEST_F(BakeFurnitureTest, AFinishGoesAlong) {
  const FurnitureId chair = put("idap/chair-windsor", {0, 0, 0});
  Furniture red = *home_.furniture.find(chair);
  red.finish = plain(Color{0.8f, 0.1f, 0.1f});
  home_.furniture.set(chair, red);
  const SurfaceModel model = read(bakeFurniture(home_, catalog_, chosen_));
  ASSERT_FALSE(model.slots.empty());
  EXPECT_NEAR(model.slots.front().material.color.r, 0.8, 0.02);
  EXPECT_NEAR(model.slots.front().material.color.g, 0.1, 0.02);
}

TEST_F(BakeFurnitureTest, WhatHangsKeepsItsHeight) {
  put("idap/chair-windsor", {0, 0, 1.2});
  EXPECT_NEAR(bakeFurniture(home_, catalog_, chosen_).elevation, 1.2, 0.01);
}

TEST_F(BakeFurnitureTest, NothingSelectedIsSaid) { EXPECT_THROW(bakeFurniture(home_, catalog_, {}), Error); }

}  // namespace
}  // namespace idap
