// What was chosen of a parametric piece, and the outline of a drawn solid, come back from a file.
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "catalog/parametric/outline_parameter.h"
#include "formats/idap/idap_format.h"

namespace idap {
namespace {

TEST(PieceParameters, SurviveAFile) {
  const std::vector<Vec2> drawn{{0, 0}, {1, 0}, {1.0 / 3, 0.7}, {0, 1}};
  Furniture solid, chest;
  solid.model.catalogId = "idap/solid-extrusion";
  solid.model.parameters = parametric::outlineParameters(drawn);
  solid.model.parameters["axis"] = 2;
  chest.model.catalogId = "idap/chest-of-drawers";
  chest.model.parameters = {{"drawers", 5}, {"front", 1}, {"legHeight", 0.12}};
  Home home;
  const FurnitureId first = home.newId<FurnitureId>(), second = home.newId<FurnitureId>();
  home.furniture.set(first, solid);
  home.furniture.set(second, chest);
  const auto file = std::make_shared<const Bytes>(writeIdap(home, {}));
  const Home read = readIdap(file, "test.idap", {}).home;
  EXPECT_EQ(read, home);
  EXPECT_EQ(parametric::outlineFrom(read.furniture.find(first)->model.parameters), drawn);
  const Catalog catalog(std::vector<std::filesystem::path>{});
  for (const FurnitureId id : {first, second}) {
    const Furniture& piece = *read.furniture.find(id);
    const auto model = catalog.model(piece.model.catalogId, piece.size, piece.model.parameters);
    ASSERT_TRUE(model);
    EXPECT_FALSE(model->mesh.empty());
  }
}

}  // namespace
}  // namespace idap
