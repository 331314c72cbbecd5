#include "editor/tools/arrange/manner.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

Manner mannerOf(const char* id) {
  static const Catalog catalog{{}};
  const CatalogPiecePtr piece = catalog.find(id);
  EXPECT_TRUE(piece) << id;
  return piece ? idap::mannerOf(*piece) : Manner::Storage;
}

TEST(MannerOf, TellsHowPiecesArePut) {
  EXPECT_EQ(mannerOf("idap/bed-double"), Manner::Bed);
  EXPECT_EQ(mannerOf("idap/bed-cot"), Manner::Bed);
  EXPECT_EQ(mannerOf("idap/night-table"), Manner::BesideBed);
  EXPECT_EQ(mannerOf("idap/wardrobe-hinged"), Manner::Storage);
  EXPECT_EQ(mannerOf("idap/vanity-oval"), Manner::Desk);
  EXPECT_EQ(mannerOf("idap/vanity-stool"), Manner::Seat);
  EXPECT_EQ(mannerOf("idap/chair-dining"), Manner::Seat);
  EXPECT_EQ(mannerOf("idap/table-dining"), Manner::Table);
  EXPECT_EQ(mannerOf("idap/table-coffee"), Manner::LowTable);
  EXPECT_EQ(mannerOf("idap/sofa-three"), Manner::Sofa);
  EXPECT_EQ(mannerOf("idap/tv-bench"), Manner::Screen);
  EXPECT_EQ(mannerOf("idap/tv-feet"), Manner::OnTop);
  EXPECT_EQ(mannerOf("idap/tv-wall"), Manner::OnWall);
  EXPECT_EQ(mannerOf("idap/light-drum"), Manner::Ceiling);
  EXPECT_EQ(mannerOf("idap/light-bedside"), Manner::OnTop);
  EXPECT_EQ(mannerOf("idap/light-floor"), Manner::Corner);
  EXPECT_EQ(mannerOf("idap/plant-palm"), Manner::Corner);
  EXPECT_EQ(mannerOf("idap/vase"), Manner::OnTop);
  EXPECT_EQ(mannerOf("idap/rug"), Manner::Floor);
  EXPECT_EQ(mannerOf("idap/curtain"), Manner::AtWindow);
  EXPECT_EQ(mannerOf("idap/picture-blue"), Manner::OnWall);
  EXPECT_EQ(mannerOf("idap/fridge"), Manner::Storage);
  EXPECT_EQ(mannerOf("idap/toilet"), Manner::Storage);
  EXPECT_EQ(mannerOf("idap/bookcase"), Manner::Storage);
}

TEST(MannerOf, PiecesOfLibrariesByTheirNames) {
  CatalogPiece piece;
  piece.id = "Scopia#bedside_table_5";
  piece.name = "Bedside table";
  piece.size = {0.5, 0.45, 0.6};
  EXPECT_EQ(idap::mannerOf(piece), Manner::BesideBed);
  piece.id = "eTeks#doubleBed140x190";
  piece.name = "Double bed";
  piece.size = {1.53, 2.07, 0.6};
  EXPECT_EQ(idap::mannerOf(piece), Manner::Bed);
}

TEST(Says, FindsWholeWords) {
  EXPECT_TRUE(says(" bed double ", "bed"));
  EXPECT_TRUE(says(" two beds ", "bed"));
  Furniture bed;
  bed.model.catalogId = "eTeks#doubleBed140x190";
  bed.name = "\u0E40\u0E15\u0E35\u0E22\u0E07";
  EXPECT_TRUE(says(wordsOf(bed), "bed"));
  EXPECT_FALSE(says(" bedroom chair ", "bed table"));
}

TEST(TopOf, ThingsStandOnTablesNotOnBeds) {
  Furniture table;
  table.name = "Table";
  table.size = {1, 1, 0.75};
  EXPECT_EQ(topOf(table, Manner::Table, wordsOf(table)), 0.75);
  table.dropOnTopHeight = 0.7;
  EXPECT_EQ(topOf(table, Manner::Table, wordsOf(table)), 0.7);
  EXPECT_EQ(topOf(table, Manner::Bed, wordsOf(table)), 0);
}

}  // namespace
}  // namespace idap
