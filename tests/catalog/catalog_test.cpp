#include "catalog/catalog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "base/error.h"
#include "catalog/parametric/builtin.h"
#include "catalog/search_text.h"

namespace idap {
namespace {

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

std::vector<std::string> idsOf(const std::vector<CatalogPiecePtr>& pieces) {
  std::vector<std::string> ids;
  for (const auto& piece : pieces) ids.push_back(piece->id);
  return ids;
}

const Catalog& builtinOnly() {
  static const Catalog catalog{std::vector<std::filesystem::path>{}};
  return catalog;
}

TEST(Catalog, HoldsTheCategoriesOf1993AndThoseOfAWholeHome) {
  std::map<std::string, std::size_t> counts;
  for (const auto& category : builtinOnly().categories()) counts[category.id] = category.pieces;
  for (const char* id : {"chair", "table", "sofa", "light", "appliance", "plant", "bed", "vanity", "cabinet",
                         "bookshelf", "kitchen", "bathroom", "door", "window"})
    EXPECT_GE(counts[id], 3u) << id;
}

TEST(Catalog, FindsByWordTagAndTranslation) {
  const Catalog& catalog = builtinOnly();
  EXPECT_THAT(idsOf(catalog.search("windsor")), Contains("idap/chair-windsor"));
  EXPECT_THAT(idsOf(catalog.search("CHAIR spindle")), Contains("idap/chair-windsor"));
  EXPECT_THAT(idsOf(catalog.search("เก้าอี้")), Contains("idap/chair-windsor"));
  EXPECT_THAT(idsOf(catalog.search("windsor glass")), IsEmpty());
  EXPECT_EQ(catalog.search("").size(), catalog.pieces().size());
}

TEST(Catalog, PutsPiecesNamedSoBeforePiecesTaggedSo) {
  const auto found = idsOf(builtinOnly().search("ottoman"));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found.front(), "idap/ottoman");
}

TEST(Catalog, PutsPiecesOfTheKindBeforeThoseThatOnlyNameIt) {
  for (const auto& [word, category] : {std::pair{"door", "door"},
                                       {"vanity", "vanity"},
                                       {"bed", "bed"},
                                       {"mirror", "vanity"},
                                       {"lamp", "light"}}) {
    const auto found = builtinOnly().search(word);
    ASSERT_FALSE(found.empty()) << word;
    EXPECT_EQ(found.front()->category, category) << word << ": " << found.front()->name;
  }
}

TEST(Catalog, FoldsCaseAndAccentsInSearch) {
  EXPECT_EQ(foldedText("FAUTEUIL Crème"), "fauteuil creme");
  EXPECT_EQ(foldedText("โต๊ะ"), "โต๊ะ");
}

TEST(Catalog, OpensNoLibraryForABuiltInPiece) {
  // A folder with a broken library: touching it would leave a problem behind.
  const auto folder = std::filesystem::path(testing::TempDir()) / "idap-broken-library";
  std::filesystem::create_directories(folder);
  if (std::FILE* file = std::fopen((folder / "broken.sh3f").string().c_str(), "wb")) std::fclose(file);
  const Catalog catalog({folder});
  ASSERT_NE(catalog.find("idap/chair-windsor"), nullptr);
  EXPECT_NE(catalog.model("idap/chair-windsor", {0.5, 0.56, 0.94}), nullptr);
  EXPECT_EQ(catalog.find("idap/no-such-thing"), nullptr);
  EXPECT_THAT(catalog.problems(), Not(IsEmpty()));
  std::filesystem::remove_all(folder);
}

TEST(Catalog, KnowsNothingOfAnUnknownPiece) {
  EXPECT_EQ(builtinOnly().find("nobody#nothing"), nullptr);
  EXPECT_EQ(builtinOnly().model("nobody#nothing", {1, 1, 1}), nullptr);
}

TEST(Catalog, SharesOneModelBetweenEqualRequestsFromManyThreads) {
  const Catalog catalog{std::vector<std::filesystem::path>{}};
  std::vector<SurfaceModelPtr> models(4);
  std::vector<std::thread> threads;
  for (auto& model : models)
    threads.emplace_back([&] { model = catalog.model("idap/table-dining", {1.6, 0.9, 0.75}); });
  for (auto& thread : threads) thread.join();
  for (const auto& model : models) EXPECT_EQ(model, models.front());
  EXPECT_NE(catalog.model("idap/table-dining", {1.8, 0.9, 0.75}), models.front());
}

TEST(Catalog, MakesFurnitureAsItSays) {
  const CatalogPiecePtr lamp = builtinOnly().find("idap/light-uplight");
  ASSERT_NE(lamp, nullptr);
  const Furniture furniture = makeFurniture(*lamp, {1, 2, 0}, 0.5);
  EXPECT_EQ(furniture.model.catalogId, lamp->id);
  EXPECT_EQ(furniture.position, (Vec3{1, 2, lamp->elevation}));
  EXPECT_EQ(furniture.size, lamp->size);
  EXPECT_EQ(furniture.angle, 0.5);
  ASSERT_TRUE(furniture.lamp.has_value());
  EXPECT_GT(furniture.lamp->lumens, 0);
}

TEST(Catalog, NamesPiecesInTheLanguageAskedForOrInEnglish) {
  const CatalogPiecePtr chair = builtinOnly().find("idap/chair-windsor");
  EXPECT_EQ(chair->nameIn("en"), "Windsor chair");
  EXPECT_EQ(chair->nameIn("th_TH"), chair->nameIn("th"));
  EXPECT_EQ(chair->nameIn("xx"), "Windsor chair");
}

// How high the largest level face of a slot is above the one below it: a table top's thickness.
double topThickness(const Vec3& size) {
  const auto* table = parametric::builtinCatalog().find("idap/table-coffee");
  const SurfaceModel model = parametric::buildModel(*table, size);
  std::size_t top = 0;
  while (model.slots[top].name != "top") ++top;
  double lo = 1e9, hi = -1e9;
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t) {
    if (model.mesh.slots[t] != top) continue;
    for (const auto v : model.mesh.triangles[t]) {
      lo = std::min(lo, static_cast<double>(model.mesh.positions[v].z));
      hi = std::max(hi, static_cast<double>(model.mesh.positions[v].z));
    }
  }
  return hi - lo;
}

TEST(ParametricPiece, KeepsItsBoardsThicknessWhenItGrows) {
  EXPECT_NEAR(topThickness({1.1, 0.6, 0.42}), 0.028, 0.0005);
  EXPECT_NEAR(topThickness({1.8, 1.1, 0.6}), 0.028, 0.0005);
}

TEST(ParametricPiece, ChangesWithItsParametersWithinTheirBounds) {
  const auto* table = parametric::builtinCatalog().find("idap/table-coffee");
  EXPECT_EQ(parametric::withChanges(*table, {{"topThickness", 0.05}}).number("topThickness", 0), 0.05);
  EXPECT_EQ(parametric::withChanges(*table, {{"topThickness", 5}}).number("topThickness", 0), 0.06);
  EXPECT_EQ(parametric::withChanges(*table, {{"legs", 5}}).number("legs", -1), -1);
}

TEST(ParametricPiece, GetsMoreCushionsAsASofaGrows) {
  const auto* sofa = parametric::builtinCatalog().find("idap/sofa-three");
  const auto small = parametric::buildModel(*sofa, {1.8, 0.95, 0.84}),
             large = parametric::buildModel(*sofa, {3.6, 0.95, 0.84});
  EXPECT_GT(large.mesh.triangles.size(), small.mesh.triangles.size() + 3000);
}

TEST(ParametricPiece, IsKeptWithinItsSmallestAndLargestSize) {
  const auto* table = parametric::builtinCatalog().find("idap/table-coffee");
  const Vec3f huge = parametric::buildModel(*table, {50, 50, 50}).mesh.bounds().size();
  EXPECT_NEAR(huge.x, table->piece->maxSize.x, 0.001);
  const Vec3f odd = parametric::buildModel(*table, {-1, std::nan(""), 0}).mesh.bounds().size();
  EXPECT_NEAR(odd.y, table->piece->size.y, 0.001);
}

TEST(BuiltinCatalog, SaysWhichPieceOfAFileIsWrong) {
  parametric::BuiltinCatalog into;
  try {
    parametric::readPieces(
        R"({"category":"chair","pieces":[{"id":"idap/odd","name":{"en":"Odd"},"generator":"none","size":[1,1,1]}]})",
        "odd.json", into);
    FAIL() << "read a piece with an unknown generator";
  } catch (const ParseError& e) {
    EXPECT_EQ(e.file(), "odd.json");
    EXPECT_EQ(e.place(), "idap/odd");
  }
  EXPECT_THROW(parametric::readPieces("{", "bad.json", into), ParseError);
}

}  // namespace
}  // namespace idap
