#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "base/error.h"
#include "base/zip.h"
#include "catalog/model_file.h"
#include "catalog/polygon_triangles.h"

namespace idap {
namespace {

using Files = std::map<std::string, std::string>;

Bytes bytesOf(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

SurfaceModel readObj(const std::string& text, const Files& files = {}, const ModelFileOptions& options = {}) {
  const auto siblings = [&](const std::string& path) -> SharedBytes {
    const auto found = files.find(path);
    return found == files.end() ? nullptr : std::make_shared<const Bytes>(bytesOf(found->second));
  };
  return readModelFile(bytesOf(text), "model.obj", siblings, options);
}

// The area of a mesh at a size.
double areaOf(const Mesh& mesh, Vec3f size = {1, 1, 1}) {
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3f a = mesh.positions[t[0]] * size, b = mesh.positions[t[1]] * size,
                c = mesh.positions[t[2]] * size;
    area += double(length(cross(b - a, c - a))) / 2;
  }
  return area;
}

const std::string kBox =
    "v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 0\nv 0 0 4\nv 2 0 4\nv 2 3 4\nv 0 3 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\nf 4 1 5 8\n";

TEST(ModelFileObj, BoxStandsUprightInTheUnitBoxWithItsFacesOutward) {
  const SurfaceModel model = readObj(kBox);
  EXPECT_TRUE(model.unitBox);
  EXPECT_EQ(model.mesh.triangles.size(), 12u);
  const Box3f box = model.mesh.bounds();
  EXPECT_EQ(box.min, (Vec3f{-0.5f, -0.5f, 0}));
  EXPECT_EQ(box.max, (Vec3f{0.5f, 0.5f, 1}));
  EXPECT_NEAR(areaOf(model.mesh, {2, 4, 3}), 2 * (2 * 4 + 2 * 3 + 4 * 3), 1e-4);
  for (const auto& t : model.mesh.triangles) {
    const Vec3f a = model.mesh.positions[t[0]], b = model.mesh.positions[t[1]],
                c = model.mesh.positions[t[2]];
    const Vec3f out = (a + b + c) / 3.f - Vec3f{0, 0, 0.5f};
    EXPECT_GT(dot(cross(b - a, c - a), out), 0);
  }
}

TEST(ModelFileObj, FrontOfTheFileIsTheFrontOfThePiece) {
  // A small triangle in front (+z of the file) and high up (+y).
  const SurfaceModel model = readObj("v -1 0 -1\nv 1 0 -1\nv 0 0 1\nv 0 5 1\nf 1 2 3\nf 1 3 4\n");
  const Vec3f& top = model.mesh.positions.back();
  EXPECT_FLOAT_EQ(top.z, 1);
  EXPECT_FLOAT_EQ(top.y, -0.5f);
}

TEST(ModelFileObj, RotationIsAppliedBeforeTheFit) {
  // Turned a quarter about z, the box's width and depth change places.
  const ModelFileOptions options{.rotation = {Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}};
  const SurfaceModel model = readObj("v 0 0 0\nv 2 0 0\nv 2 3 0\nv 0 3 1\nf 1 2 3 4\n", {}, options);
  EXPECT_FLOAT_EQ(model.mesh.positions[1].y, 0.5f) << "what was right is at the back";
}

TEST(ModelFileObj, NegativeIndicesContinuedLinesCarriageReturnsAndAMissingLastNewline) {
  const SurfaceModel model = readObj("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 1\r\nf -4 -3 \\\r\n -2 -1");
  EXPECT_EQ(model.mesh.triangles.size(), 2u);
}

TEST(ModelFileObj, FacesWithWrongIndicesOrHugeNumbersAreDroppedAndTheRestStays) {
  const SurfaceModel model = readObj(
      "v 0 0 0\nv 1 0 0\nv 0 1 1\nv 1e999 0 0\nv nan 0 0\nf 1 2 3\nf 1 2 9\nf 1 2 4\nf 1 2 5\nf 0 1 2\nf -9 "
      "1 2\n"
      "f 1 2\nf 1 1 1\n");
  EXPECT_EQ(model.mesh.triangles.size(), 1u);
}

TEST(ModelFileObj, GarbageIsAParseErrorWithItsLine) {
  EXPECT_THROW(readObj("v 0 0 0\nv 1 x 0\nf 1 2 3\n"), ParseError);
  EXPECT_THROW(readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\n"), ParseError) << "no faces";
  try {
    readObj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 three\n");
    FAIL();
  } catch (const ParseError& error) {
    EXPECT_EQ(error.place(), "line 4");
  }
}

TEST(ModelFileObj, ConcavePolygonsKeepTheirArea) {
  // An L of area 3 and an arrow head, which a fan from the first corner would spill over.
  const std::string el = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n";
  EXPECT_NEAR(areaOf(readObj(el).mesh, {2, 1, 2}), 3, 1e-5);
  const std::string arrow = "v 0 0 0\nv 2 -1 0\nv 0.5 0 0\nv 2 1 0\nf 1 2 3 4\n";
  EXPECT_NEAR(areaOf(readObj(arrow).mesh, {2, 1, 2}), 0.5, 1e-5);
}

TEST(ModelFileObj, EveryPolygonGivesTwoTrianglesLessThanItHasCorners) {
  std::vector<Vec3f> star;
  for (int i = 0; i < 40; ++i) {
    const float radius = i % 2 ? 1 : 3, angle = float(i) * 2 * float(kPi) / 40;
    star.push_back({radius * std::cos(angle), 0, -radius * std::sin(angle)});
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangulatePolygon(star, {0, 1, 0}, triangles);
  EXPECT_EQ(triangles.size(), 38u);
  double area = 0;
  for (const auto& t : triangles)
    area += double(cross(star[t[1]] - star[t[0]], star[t[2]] - star[t[0]]).y) / 2;
  EXPECT_NEAR(area, 40 * 0.5 * 3 * 1 * std::sin(2 * kPi / 40), 1e-4);
}

// A ridge of two quads that meet at an angle, sharing an edge on the y axis.
std::string ridge(const std::string& smoothing, double height) {
  return smoothing + "v 0 " + std::to_string(height) + " 0\nv 0 " + std::to_string(height) +
         " 1\nv -1 0 0\nv -1 0 1\nv 1 0 0\nv 1 0 1\nf 3 4 2 1\nf 1 2 6 5\n";
}

TEST(ModelFileObj, SmoothingGroupsShareNormalsOverGentleEdgesOnly) {
  EXPECT_TRUE(readObj(ridge("", 0.3)).mesh.normals.empty()) << "no group: flat";
  EXPECT_TRUE(readObj(ridge("s off\n", 0.3)).mesh.normals.empty());
  const SurfaceModel smooth = readObj(ridge("s 1\n", 0.3));
  ASSERT_EQ(smooth.mesh.positions.size(), 6u) << "the edge is shared";
  for (std::size_t i = 0; i < 6; ++i)
    if (smooth.mesh.positions[i].x == 0) {
      EXPECT_NEAR(smooth.mesh.normals[i].z, 1, 1e-5);
    }
  EXPECT_EQ(readObj(ridge("s 1\n", 3)).mesh.positions.size(), 8u) << "a sharp edge splits";
  EXPECT_TRUE(readObj(ridge("s 1\n", 0.3), {}, {.smoothed = false}).mesh.normals.empty());
}

TEST(ModelFileObj, NormalsOfTheFileAreTurnedAndScaledWithIt) {
  const SurfaceModel model =
      readObj("v 0 0 0\nv 4 0 0\nv 0 1 0\nv 0 1 9\nvn 0 1 1\nf 1//1 2//1 3//1\nf 1//1 2//1 4//1\n");
  // The plane x/4 + y = 1 style of fit: normals grow with the size of their axis.
  const Vec3f n = model.mesh.normals.front();
  EXPECT_NEAR(n.y, -9 / std::sqrt(82.0), 1e-5);
  EXPECT_NEAR(n.z, 1 / std::sqrt(82.0), 1e-5);
}

TEST(ModelFileObj, SlotsAreTheMaterialsByName) {
  const Files files{{"m.mtl", "newmtl green paint\nKd 0.1 0.6 0.2\nnewmtl glassy\nKd 0 0 1\nd 0.25\n"}};
  const SurfaceModel model = readObj(
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nusemtl green paint\nf 1 2 3\nusemtl glassy\nf 3 2 1\nusemtl "
      "white\nf 1 2 3\n",
      files);
  ASSERT_EQ(model.slots.size(), 3u);
  EXPECT_EQ(model.slots[0].name, "green paint");
  EXPECT_FLOAT_EQ(model.slots[0].material.color.g, 0.6f);
  EXPECT_EQ(model.mesh.slotOf(1), 1u);
  EXPECT_DOUBLE_EQ(model.slots[1].material.transmission, 0.75);
  EXPECT_TRUE(model.slots[1].material.thin);
  EXPECT_GT(model.slots[1].material.color.r, 0.7f) << "a quarter there, a quarter tinted";
  EXPECT_FLOAT_EQ(model.slots[2].material.color.r, 1) << "a default material";
}

TEST(ModelFileObj, PanesAndMirrorsAreMarkedByTheirGroup) {
  const std::string shape = "v 0 0 0\nv 1 0 0\nv 0 1 1\nusemtl flltgrey\n";
  const SurfaceModel model = readObj(shape +
                                     "f 1 2 3\ng sweethome3d_window_pane_on_hinge_1\nf 1 3 2\n"
                                     "g sweethome3d_window_mirror\nf 1 2 3\ng frame\nf 3 2 1\n");
  ASSERT_EQ(model.slots.size(), 3u);
  for (const auto& slot : model.slots) EXPECT_EQ(slot.name, "flltgrey");
  EXPECT_DOUBLE_EQ(model.slots[0].material.transmission, 0);
  EXPECT_DOUBLE_EQ(model.slots[1].material.transmission, 1);
  EXPECT_DOUBLE_EQ(model.slots[2].material.metalness, 1);
  EXPECT_EQ(model.mesh.slotOf(3), 0u);
}

TEST(ModelFileObj, TexturesAreFoundBesideTheModelEvenByAWrongPath) {
  const Files files{{"m.mtl", "newmtl a\nKd 0.2 0.2 0.2\nmap_Kd -s 2 2 2 C:\\art\\wood.png\n"},
                    {"wood.png", "PNG"}};
  const SurfaceModel model = readObj(
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\n", files);
  ASSERT_TRUE(model.slots[0].material.texture);
  EXPECT_EQ(model.slots[0].material.texture->name, "wood.png");
  EXPECT_EQ(model.slots[0].material.color, (Color{1, 1, 1})) << "the picture alone";
  ASSERT_EQ(model.mesh.uvs.size(), 3u);
  EXPECT_EQ(model.mesh.uvs[2], (Vec2f{0, 1}));
}

TEST(ModelFileObj, AFlatModelStaysFlat) {
  const Box3f box = readObj("v 0 0 0\nv 2 0 0\nv 2 0 2\nv 0 0 2\nf 1 2 3 4\n").mesh.bounds();
  EXPECT_FLOAT_EQ(box.size().z, 0);
  EXPECT_FLOAT_EQ(box.size().x, 1);
}

}  // namespace
}  // namespace idap
