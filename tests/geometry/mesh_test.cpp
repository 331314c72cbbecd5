#include "geometry/mesh.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

// Two triangles folded along the y axis by an angle.
Mesh folded(float angle) {
  Mesh m;
  m.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(angle), 0, std::sin(angle)}};
  m.triangles = {{0, 1, 2}, {0, 3, 1}};
  return m;
}

double volume(const Mesh& m) {
  double sum = 0;
  for (const auto& t : m.triangles) {
    sum += double(dot(m.positions[t[0]], cross(m.positions[t[1]], m.positions[t[2]]))) / 6;
  }
  return sum;
}

Mesh tetrahedron() {
  Mesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  m.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return m;
}

TEST(Mesh, AppendKeepsWindingOutwardUnderAMirror) {
  Mesh m;
  append(m, tetrahedron(), Transformf::scaling({-2, 1, 1}), 3);
  EXPECT_NEAR(volume(m), 2.0 / 6, 1e-6);
  EXPECT_EQ(m.slotOf(0), 3u);
}

TEST(Mesh, AppendCarriesNormalsAndFillsMissingOnes) {
  Mesh smooth = tetrahedron();
  computeSmoothNormals(smooth, 0.1f);
  Mesh m = tetrahedron();
  append(m, smooth, Transformf::scaling({-1, 1, 3}));
  ASSERT_EQ(m.normals.size(), m.positions.size());
  for (const auto& t : m.triangles) {
    const Vec3f face =
        normalized(cross(m.positions[t[1]] - m.positions[t[0]], m.positions[t[2]] - m.positions[t[0]]));
    for (const auto v : t) EXPECT_NEAR(dot(face, m.normals[v]), 1, 1e-4);
  }
}

TEST(Mesh, AppendFillsMissingTextureCoordinates) {
  Mesh a = tetrahedron(), b = tetrahedron();
  b.uvs.assign(4, Vec2f{1, 1});
  append(a, b);
  EXPECT_EQ(a.uvs.size(), 8u);
  append(b, tetrahedron());
  EXPECT_EQ(b.uvs.size(), 8u);
  EXPECT_EQ(b.uvs[7], Vec2f{});
}

TEST(Mesh, GentleFoldsAreSmoothedAndSharpOnesSplit) {
  Mesh gentle = folded(0.2f);
  computeSmoothNormals(gentle, 0.5f);
  EXPECT_EQ(gentle.positions.size(), 4u);
  EXPECT_NEAR(length(gentle.normals[0]), 1, 1e-5);
  EXPECT_LT(gentle.normals[0].x, 0);

  Mesh sharp = folded(1.5f);
  computeSmoothNormals(sharp, 0.5f);
  EXPECT_EQ(sharp.positions.size(), 6u);
  for (const auto& t : sharp.triangles) {
    const Vec3f face = normalized(
        cross(sharp.positions[t[1]] - sharp.positions[t[0]], sharp.positions[t[2]] - sharp.positions[t[0]]));
    for (const auto v : t) EXPECT_NEAR(dot(face, sharp.normals[v]), 1, 1e-5);
  }
}

TEST(Mesh, VerticesAtTheSamePlaceAreSmoothedTogether) {
  Mesh m = folded(0.2f);
  m.positions.push_back(m.positions[0]);
  m.positions.push_back(m.positions[1]);
  m.triangles[1] = {4, 3, 5};
  computeSmoothNormals(m, 0.5f);
  EXPECT_NEAR(dot(m.normals[0], m.normals[4]), 1, 1e-6);
}

TEST(Mesh, ALargeFanIsSmoothedInReasonableTime) {
  Mesh cone;
  constexpr int kSides = 60'000;
  cone.positions.push_back({0, 0, 0.05f});
  for (int i = 0; i < kSides; ++i) {
    const float a = float(2 * kPi) * float(i) / kSides;
    cone.positions.push_back({std::cos(a), std::sin(a), 0});
    cone.triangles.push_back({0u, std::uint32_t(i + 1), std::uint32_t((i + 1) % kSides + 1)});
  }
  computeSmoothNormals(cone, 0.5f);
  EXPECT_NEAR(cone.normals[0].z, 1, 1e-3);
}

TEST(Mesh, DegenerateTrianglesGiveFiniteNormals) {
  Mesh m;
  m.positions = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
  m.triangles = {{0, 1, 2}};
  computeSmoothNormals(m, 0.5f);
  for (const Vec3f& n : m.normals) EXPECT_NEAR(length(n), 1, 1e-6);
  Mesh none;
  computeSmoothNormals(none, 0.5f);
  EXPECT_TRUE(none.normals.empty());
}

}  // namespace
}  // namespace idap
