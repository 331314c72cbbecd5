// What a symbol shows: the silhouette, what nothing hides, and the colours of what is seen.
#include "editor/symbol/symbol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "catalog/catalog.h"
#include "editor/symbol/piece_model.h"

namespace idap {
namespace {

void addBox(Mesh& mesh, Vec3f low, Vec3f high, std::uint32_t slot) {
  const auto base = std::uint32_t(mesh.positions.size());
  for (int i = 0; i < 8; ++i)
    mesh.positions.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  constexpr std::uint32_t kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                          {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({base + f[0], base + f[1], base + f[2]});
    mesh.triangles.push_back({base + f[0], base + f[2], base + f[3]});
    mesh.slots.insert(mesh.slots.end(), 2, slot);
  }
}

SurfaceModel twoSlots() {
  SurfaceModel model;
  model.slots.resize(2);
  model.slots[0].name = "top";
  model.slots[0].material.color = {0.5f, 0.25f, 0.125f};
  model.slots[1].name = "legs";
  return model;
}

// A slab of 1.2 by 0.8 m on four legs.
SurfaceModel table() {
  SurfaceModel model = twoSlots();
  addBox(model.mesh, {-0.6f, -0.4f, 0.7f}, {0.6f, 0.4f, 0.75f}, 0);
  for (const float x : {-0.5f, 0.5f})
    for (const float y : {-0.3f, 0.3f})
      addBox(model.mesh, {x - 0.03f, y - 0.03f, 0}, {x + 0.03f, y + 0.03f, 0.7f}, 1);
  return model;
}

Piece tablePiece() {
  Piece piece;
  piece.size = {1.2, 0.8, 0.75};
  return piece;
}

Box2 boxOf(const std::vector<SymbolRing>& rings) {
  Box2 box;
  for (const SymbolRing& ring : rings)
    for (const Vec2f p : ring) box.add(Vec2{p.x, p.y});
  return box;
}

double lengthOf(const Symbol& symbol) {
  double sum = 0;
  for (const SymbolLine& line : symbol.lines) sum += double(line.length);
  return sum;
}

TEST(Symbol, ATableFromAboveIsItsTop) {
  const Symbol symbol = makeSymbol(table(), tablePiece(), Plane::XY);
  const Box2 box = boxOf(symbol.outline);
  EXPECT_NEAR(box.min.x, -0.6, 0.005);
  EXPECT_NEAR(box.max.y, 0.4, 0.005);
  ASSERT_EQ(symbol.areas.size(), 1u) << "the legs are hidden";
  EXPECT_EQ(symbol.slots[symbol.areas[0].slot].name, "top");
  EXPECT_NEAR(lengthOf(symbol), 4.0, 0.05) << "its four edges, each once";
}

TEST(Symbol, ATableFromTheFrontShowsItsLegs) {
  const Symbol symbol = makeSymbol(table(), tablePiece(), Plane::XZ);
  const Box2 box = boxOf(symbol.outline);
  EXPECT_NEAR(box.min.y, 0, 0.005);
  EXPECT_NEAR(box.max.y, 0.75, 0.005);
  ASSERT_EQ(symbol.areas.size(), 2u);
  EXPECT_EQ(symbol.areas[0].rings.size(), 2u)
      << "two legs before two others, larger than the edge of the top";
}

TEST(Symbol, FromTheSideItIsAsDeepAsThePiece) {
  const Box2 box = boxOf(makeSymbol(table(), tablePiece(), Plane::YZ).outline);
  EXPECT_NEAR(box.max.x - box.min.x, 0.8, 0.01);
}

TEST(Symbol, ThePlanIsTheSameAtEveryAngleAndTheElevationTurns) {
  Piece turned = tablePiece();
  turned.angle = kPi / 2;
  turned.position = {3, 4, 0};
  const Box2 plan = boxOf(makeSymbol(table(), turned, Plane::XY).outline);
  EXPECT_NEAR(plan.max.x - plan.min.x, 1.2, 0.01);
  const Box2 front = boxOf(makeSymbol(table(), turned, Plane::XZ).outline);
  EXPECT_NEAR(front.max.x - front.min.x, 0.8, 0.01);
}

TEST(Symbol, AUnitBoxIsFittedToThePiece) {
  SurfaceModel model = twoSlots();
  addBox(model.mesh, {-0.5f, -0.5f, 0}, {0.5f, 0.5f, 1}, 0);
  model.unitBox = true;
  Piece piece;
  piece.size = {2, 0.5, 1};
  const Box2 box = boxOf(makeSymbol(model, piece, Plane::XY).outline);
  EXPECT_NEAR(box.max.x, 1, 0.01);
  EXPECT_NEAR(box.max.y, 0.25, 0.01);
}

TEST(Symbol, AMirroredPieceIsMirrored) {
  SurfaceModel model = twoSlots();
  addBox(model.mesh, {-0.5f, -0.5f, 0}, {0.5f, 0.5f, 0.1f}, 0);
  addBox(model.mesh, {0.2f, -0.5f, 0.1f}, {0.5f, 0.5f, 0.5f}, 1);
  Piece piece;
  for (const bool mirrored : {false, true}) {
    piece.mirrored = mirrored;
    const Symbol symbol = makeSymbol(model, piece, Plane::XY);
    ASSERT_EQ(symbol.areas.size(), 2u);
    const Box2 raised = boxOf(symbol.areas[1].rings);
    EXPECT_NEAR(mirrored ? -raised.min.x : raised.max.x, 0.5, 0.01);
  }
}

TEST(Symbol, NothingComesOfNothing) {
  EXPECT_TRUE(makeSymbol({}, tablePiece(), Plane::XY).empty());
  SurfaceModel broken = twoSlots();
  addBox(broken.mesh, {0, 0, 0}, {1, 1, 1}, 7);
  broken.mesh.positions[3].x = std::nanf("");
  EXPECT_TRUE(makeSymbol(broken, tablePiece(), Plane::XY).empty());
}

TEST(Symbol, BigModelsAreMadeSimpler) {
  SurfaceModel ball = twoSlots();
  constexpr std::uint32_t kRings = 240, kParts = 240;
  for (std::uint32_t r = 0; r <= kRings; ++r)
    for (std::uint32_t s = 0; s < kParts; ++s) {
      const double polar = kPi * r / kRings, turn = 2 * kPi * s / kParts;
      ball.mesh.positions.push_back(toFloat(
          Vec3{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)} * 0.5));
    }
  for (std::uint32_t r = 0; r < kRings; ++r)
    for (std::uint32_t s = 0; s < kParts; ++s) {
      const std::uint32_t a = r * kParts + s, b = r * kParts + (s + 1) % kParts;
      ball.mesh.triangles.push_back({a, a + kParts, b});
      ball.mesh.triangles.push_back({b, a + kParts, b + kParts});
    }
  ASSERT_GT(ball.mesh.triangles.size(), 100'000u);
  const Symbol symbol = makeSymbol(ball, {}, Plane::XY);
  std::size_t points = 0;
  for (const SymbolLine& line : symbol.lines) points += line.points.size();
  EXPECT_LT(points, 2000u);
  EXPECT_NEAR(boxOf(symbol.outline).max.x, 0.5, 0.01);
  EXPECT_LT(symbol.coarse.size(), 24u);
}

TEST(Symbol, KeysTellPiecesOfDifferentLooksApart) {
  Piece piece = tablePiece();
  piece.model.catalogId = "idap/table";
  const Assets none;
  const auto key = [&](Plane plane) { return symbolKey(piece, plane, none, nullptr); };
  const SymbolKey plan = key(Plane::XY), front = key(Plane::XZ);
  EXPECT_NE(plan, front);
  piece.position = {4, 5, 6};
  EXPECT_EQ(key(Plane::XY), plan);
  piece.angle = 1;
  EXPECT_EQ(key(Plane::XY), plan) << "a plan is turned";
  EXPECT_NE(key(Plane::XZ), front);
  piece.size.x = 1.3;
  EXPECT_NE(key(Plane::XY), plan);
  EXPECT_EQ(key(Plane::XY).substr(0, plan.find('\n')), plan.substr(0, plan.find('\n')))
      << "and can be stretched";
}

TEST(Symbol, BuiltInPiecesHaveOne) {
  const Catalog catalog(std::vector<std::filesystem::path>{});
  const auto pieces = catalog.pieces();
  for (std::size_t i = 0; i < pieces.size(); i += 5) {  // some of each category
    const CatalogPiecePtr& piece = pieces[i];
    const Furniture furniture = makeFurniture(*piece, {});
    const SurfaceModelPtr model = pieceModel(furniture, {}, catalog);
    ASSERT_NE(model, nullptr) << piece->id;
    const Symbol symbol = makeSymbol(*model, furniture, Plane::XY);
    const Box2 box = boxOf(symbol.outline);
    EXPECT_LE(box.max.x - box.min.x, piece->size.x * 1.1 + 0.05) << piece->id;
    EXPECT_GE(box.max.x - box.min.x, piece->size.x * 0.5) << piece->id;
    EXPECT_FALSE(symbol.areas.empty()) << piece->id;
  }
}

}  // namespace
}  // namespace idap
