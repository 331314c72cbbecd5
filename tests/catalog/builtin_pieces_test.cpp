// Every built-in piece at its default, smallest and largest size: a sound mesh that fills the box asked for.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "catalog/material.h"
#include "catalog/parametric/builtin.h"

namespace idap::parametric {
namespace {

std::vector<Vec3> sizesOf(const CatalogPiece& piece) {
  std::vector<Vec3> sizes{piece.size};
  if (piece.minSize.x > 0) sizes.push_back(piece.minSize);
  if (piece.maxSize.x > 0) sizes.push_back(piece.maxSize);
  return sizes;
}

// Volumes of the connected parts of a mesh that are closed: positive when wound outward.
std::vector<double> closedVolumes(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> places;
  std::vector<std::uint32_t> place;
  for (const Vec3f& p : mesh.positions)
    place.push_back(
        places.emplace(std::tuple{p.x, p.y, p.z}, static_cast<std::uint32_t>(places.size())).first->second);
  std::vector<std::uint32_t> parent(places.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = place[t[i]], b = place[t[(i + 1) % 3]];
      parent[root(a)] = root(b);
      if (a != b) edges[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
    }
  }
  std::set<std::uint32_t> open;
  for (const auto& [edge, balance] : edges)
    if (balance != 0) open.insert(root(edge.first));
  std::map<std::uint32_t, double> volume;
  for (const auto& t : mesh.triangles) {
    const std::uint32_t part = root(place[t[0]]);
    if (open.contains(part)) continue;
    volume[part] += dot(toDouble(mesh.positions[t[0]]),
                        cross(toDouble(mesh.positions[t[1]]), toDouble(mesh.positions[t[2]]))) /
                    6;
  }
  std::vector<double> result;
  for (const auto& entry : volume) result.push_back(entry.second);
  return result;
}

// By category, so that a test's name says where to look.
class BuiltinPiecesTest : public testing::TestWithParam<std::string> {
 protected:
  template <class F>
  void forEach(F&& f) const {
    for (const BuiltinPiece& built : builtinCatalog().pieces) {
      if (built.piece->category != GetParam()) continue;
      SCOPED_TRACE(built.piece->id);
      f(built);
    }
  }
};

TEST_P(BuiltinPiecesTest, FillsTheBoxAskedForWithAMeshWithoutFault) {
  forEach([](const BuiltinPiece& built) {
    for (const Vec3 size : sizesOf(*built.piece)) {
      SCOPED_TRACE(testing::Message() << size.x << " x " << size.y << " x " << size.z);
      const SurfaceModel model = buildModel(built, size);
      const Mesh& mesh = model.mesh;
      ASSERT_FALSE(mesh.empty());
      ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
      ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
      ASSERT_EQ(mesh.slots.size(), mesh.triangles.size());
      EXPECT_LT(mesh.triangles.size(), 120'000u);
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        ASSERT_TRUE(isFinite(toDouble(mesh.positions[i])));
        ASSERT_NEAR(length(mesh.normals[i]), 1.0, 1e-3) << "vertex " << i;
        ASSERT_TRUE(std::isfinite(mesh.uvs[i].x) && std::isfinite(mesh.uvs[i].y));
      }
      const Box3f box = mesh.bounds();
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.size()[i], size[i], 0.001) << "axis " << i;
      EXPECT_NEAR(box.min.z, 0, 0.001);
      EXPECT_NEAR(box.centre().x, 0, 0.001);
      EXPECT_NEAR(box.centre().y, 0, 0.001);
    }
  });
}

TEST_P(BuiltinPiecesTest, IsWoundOutwardAndShadedAsWound) {
  forEach([](const BuiltinPiece& built) {
    const Mesh mesh = buildModel(built, built.piece->size).mesh;
    std::size_t against = 0;
    for (const auto& t : mesh.triangles) {
      const Vec3f face =
          cross(mesh.positions[t[1]] - mesh.positions[t[0]], mesh.positions[t[2]] - mesh.positions[t[0]]);
      if (dot(face, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]) < 0) ++against;
    }
    EXPECT_LE(against, mesh.triangles.size() / 100) << "of " << mesh.triangles.size();
    const std::vector<double> volumes = closedVolumes(mesh);
    EXPECT_FALSE(volumes.empty());
    int insideOut = 0;
    for (const double v : volumes) insideOut += v < -1e-10 ? 1 : 0;
    EXPECT_EQ(insideOut, 0) << "of " << volumes.size() << " closed parts";
  });
}

TEST_P(BuiltinPiecesTest, HasAKnownMaterialInEverySlotAndASlotForEveryMaterial) {
  forEach([](const BuiltinPiece& built) {
    const SurfaceModel model = buildModel(built, built.piece->size);
    std::set<std::string> made;
    for (const auto& slot : model.slots) {
      made.insert(slot.name);
      EXPECT_TRUE(built.slots.contains(slot.name)) << "slot without material: " << slot.name;
    }
    for (const auto& [slot, material] : built.slots) {
      EXPECT_NE(findMaterial(material.material), nullptr) << material.material;
      EXPECT_TRUE(made.contains(slot)) << "material without slot: " << slot;
    }
  });
}

TEST_P(BuiltinPiecesTest, IsDescribed) {
  forEach([](const BuiltinPiece& built) {
    const CatalogPiece& piece = *built.piece;
    EXPECT_TRUE(piece.id.starts_with("idap/"));
    EXPECT_FALSE(piece.name.empty());
    EXPECT_NE(piece.nameIn("th"), piece.name);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(piece.minSize[i], piece.size[i]);
      if (piece.maxSize[i] > 0) {
        EXPECT_GE(piece.maxSize[i], piece.size[i]);
      }
    }
    for (const PieceParameter& p : piece.parameters) {
      EXPECT_LE(p.min, p.value) << p.name;
      EXPECT_GE(p.max, p.value) << p.name;
    }
  });
}

TEST_P(BuiltinPiecesTest, SaysWhereItsLightComesFromWhenItIsALamp) {
  forEach([](const BuiltinPiece& built) {
    const CatalogPiece& piece = *built.piece;
    if (!piece.lamp) return;
    const SurfaceModel model = buildModel(built, piece.size);
    ASSERT_FALSE(model.lightPositions.empty());
    for (const Vec3 light : model.lightPositions) {
      EXPECT_LE(std::abs(light.x), piece.size.x / 2 + 1e-6);
      EXPECT_LE(std::abs(light.y), piece.size.y / 2 + 1e-6);
      EXPECT_GE(light.z, -1e-6);
      EXPECT_LE(light.z, piece.size.z + 1e-6);
    }
  });
}

TEST(BuiltinPieces, CanBeRead) { EXPECT_NO_THROW(builtinCatalog()); }

INSTANTIATE_TEST_SUITE_P(Of, BuiltinPiecesTest,
                         testing::Values("chair", "table", "sofa", "light", "appliance", "plant", "bed",
                                         "vanity", "cabinet", "bookshelf", "kitchen", "bathroom", "door",
                                         "window", "stairs", "decor", "solid"),
                         [](const auto& category) { return category.param; });

}  // namespace
}  // namespace idap::parametric
