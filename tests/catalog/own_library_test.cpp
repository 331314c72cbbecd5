#include "catalog/library/own_library.h"

#include <gtest/gtest.h>

#include "base/file.h"
#include "catalog/catalog.h"
#include "catalog/library/own_models.h"

namespace idap {
namespace {

namespace fs = std::filesystem;

SharedBytes bytesOf(const std::string& text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return std::make_shared<const Bytes>(first, first + text.size());
}

const std::map<std::string, SharedBytes> kModel{
    {"model.obj",
     bytesOf("mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl Oak\nf 1 2 3\nf 1 3 4\n"
             "f 1 4 2\nf 2 4 3\n")},
    {"model.mtl", bytesOf("newmtl Oak\nKd 0.5 0.3 0.1\n")}};

class OwnLibraryTest : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  OwnPiece stool() {
    OwnPiece piece;
    piece.id = "own/stool";
    piece.name = "Stool: high = good";
    piece.nameThai = "ม้านั่งสูง";
    piece.category = "Seats";
    piece.categoryThai = "ที่นั่ง";
    piece.creator = "Ann";
    piece.tags = {"bar", "oak"};
    piece.price = 49.5;
    piece.size = {0.4, 0.4, 0.75};
    piece.minSize = {0.3, 0, 0.5};
    piece.maxSize = {0.6, 0, 1};
    piece.keepProportions = true;
    return piece;
  }
  fs::path folder_ = fs::path(testing::TempDir()) / "own_library_test";
  fs::path file_ = folder_ / "own-furniture.sh3f";
};

TEST_F(OwnLibraryTest, WhatIsSaidOfAPieceComesBack) {
  OwnLibrary library(file_);
  library.add(stool(), kModel, "model.obj", bytesOf("icon"));
  library.save();
  const OwnLibrary again(file_);
  ASSERT_EQ(again.pieces().size(), 1u);
  EXPECT_EQ(again.pieces().front(), stool());
}

TEST_F(OwnLibraryTest, ALampKeepsItsLightThereAndInTheCatalog) {
  OwnLibrary library(file_);
  OwnPiece warm = stool(), red = stool();
  warm.lamp = Lamp{.lumens = 450, .colorTemperature = 2200, .beamAngle = kPi / 3};
  warm.lamp->sources = {{.position = {0.5, 0.5, 0.9}}};
  red.id = "own/red";
  red.lamp = Lamp{.lumens = 90, .color = Color{1, 0, 0}};
  red.lamp->sources = {{.position = {0.5, 0.5, 0.1}}};
  for (const OwnPiece& piece : {warm, red}) library.add(piece, kModel, "model.obj", nullptr);
  library.save();
  const OwnLibrary again(file_);
  const Catalog catalog({folder_});
  for (const OwnPiece& piece : {warm, red}) {
    for (const auto& lamp : {again.find(piece.id)->lamp, catalog.find(piece.id)->lamp}) {
      ASSERT_TRUE(lamp) << piece.id;
      EXPECT_NEAR(lamp->lumens, piece.lamp->lumens, 1e-6);
      EXPECT_NEAR(lamp->beamAngle, piece.lamp->beamAngle, 1e-6);
      const std::optional<Color> color =
          lamp->color || lamp->sources.empty() ? lamp->color : lamp->sources.front().color;
      EXPECT_EQ(color, piece.lamp->color);
      if (!color) {
        EXPECT_EQ(lamp->colorTemperature, piece.lamp->colorTemperature);
      }
    }
  }
}

TEST_F(OwnLibraryTest, AHomeTakesTheModelsAlong) {
  OwnLibrary library(file_);
  library.add(stool(), kModel, "model.obj", bytesOf("icon"));
  Home home;
  Furniture piece;
  piece.model.catalogId = "own/stool";
  piece.size = stool().size;
  const auto id = home.newId<FurnitureId>();
  home.furniture.set(id, piece);
  EXPECT_TRUE(usesOwnFurniture(home));
  const Home whole = withOwnModels(home, library);
  EXPECT_FALSE(usesOwnFurniture(whole));
  const std::string& asset = whole.furniture.find(id)->model.asset;
  EXPECT_EQ(*whole.assets->at(asset), *kModel.at("model.obj"));
  EXPECT_EQ(whole.assets->size(), kModel.size());  // its icon is the catalog's
  EXPECT_TRUE(home.assets->empty());
  // A piece placed after the one in the library became another is not taken for the older one.
  OwnLibrary later(file_);
  auto other = kModel;
  other["model.mtl"] = bytesOf("newmtl Oak\nKd 1 1 1\n");
  later.add(stool(), other, "model.obj", nullptr);
  Home two = whole;
  const auto second = two.newId<FurnitureId>();
  two.furniture.set(second, piece);
  two = withOwnModels(two, later);
  EXPECT_EQ(two.furniture.find(id)->model.asset, asset);
  EXPECT_NE(two.furniture.find(second)->model.asset, asset);
}

TEST_F(OwnLibraryTest, TheCatalogHasItWithItsModelInBothLanguages) {
  OwnLibrary library(file_);
  library.add(stool(), kModel, "model.obj", bytesOf("icon"));
  library.save();
  const Catalog catalog({folder_});
  const CatalogPiecePtr piece = catalog.find("own/stool");
  ASSERT_TRUE(piece);
  EXPECT_EQ(piece->nameIn("en"), "Stool: high = good");
  EXPECT_EQ(piece->nameIn("th"), "ม้านั่งสูง");
  EXPECT_EQ(piece->price, 49.5);
  EXPECT_NEAR(piece->minSize.x, 0.3, 1e-9);
  const SurfaceModelPtr model = catalog.model("own/stool", piece->size);
  ASSERT_TRUE(model);
  ASSERT_EQ(model->slots.size(), 1u);
  EXPECT_EQ(model->slots.front().name, "Oak");
}

TEST_F(OwnLibraryTest, ChangedAndRemovedItIsSoInTheFile) {
  OwnLibrary library(file_);
  library.add(stool(), kModel, "model.obj", nullptr);
  OwnPiece other = stool();
  other.id = library.freeId("Stool");
  EXPECT_EQ(other.id, "own/stool-2");
  library.add(other, kModel, "model.obj", nullptr);
  other.name = "Low stool";
  library.change(other);
  library.remove("own/stool");
  library.save();
  const OwnLibrary again(file_);
  ASSERT_EQ(again.pieces().size(), 1u);
  EXPECT_EQ(again.pieces().front().name, "Low stool");
  EXPECT_TRUE(Catalog({folder_}).model("own/stool-2", {1, 1, 1}));
}

TEST_F(OwnLibraryTest, AThaiNameAloneGivesAnIdToo) {
  EXPECT_EQ(OwnLibrary(file_).freeId("ม้านั่ง"), "own/piece");
}

}  // namespace
}  // namespace idap
