#include "formats/gltf/gltf_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

namespace idap {
namespace {

using nlohmann::json;

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t v = 0;
  std::memcpy(&v, bytes.data() + at, 4);
  return v;
}

struct Glb {
  json doc;
  Bytes binary;
};

// Takes the container apart as a reader would.
Glb parse(const Bytes& bytes) {
  EXPECT_EQ(word(bytes, 0), 0x46546c67u);
  EXPECT_EQ(word(bytes, 4), 2u);
  EXPECT_EQ(word(bytes, 8), bytes.size());
  const std::size_t text = word(bytes, 12);
  EXPECT_EQ(word(bytes, 16), 0x4e4f534au);
  EXPECT_EQ(text % 4, 0u);
  Glb glb;
  glb.doc = json::parse(asText(bytes).substr(20, text));
  if (bytes.size() > 20 + text) {
    const std::size_t size = word(bytes, 20 + text);
    EXPECT_EQ(word(bytes, 24 + text), 0x004e4942u);
    EXPECT_EQ(28 + text + size, bytes.size());
    glb.binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(28 + text), bytes.end());
  }
  return glb;
}

std::vector<float> floats(const Glb& glb, std::size_t accessor) {
  const json& a = glb.doc["accessors"][accessor];
  const json& view = glb.doc["bufferViews"][a["bufferView"].get<std::size_t>()];
  const std::size_t parts = a["type"] == "VEC3" ? 3 : a["type"] == "VEC2" ? 2 : 1;
  std::vector<float> values(a["count"].get<std::size_t>() * parts);
  std::memcpy(values.data(), glb.binary.data() + view["byteOffset"].get<std::size_t>(), values.size() * 4);
  return values;
}

std::shared_ptr<Mesh> triangle() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 1}};
  mesh->uvs = {{0, 0}, {1, 0}, {0, 1}};
  mesh->normals = {{0, 0, 2}, {0, 0, 1}, {0, 0, 0}};
  mesh->triangles = {{0, 1, 2}};
  return mesh;
}

render::Scene oneTriangle() {
  render::Scene scene;
  scene.meshes = {triangle()};
  render::Surface red;
  red.name = "red";
  red.baseColor = {0.8f, 0.1f, 0.1f};
  red.roughness = 0.25f;
  scene.surfaces = {red};
  scene.instances = {{.mesh = 0, .surfaces = {0}}};
  return scene;
}

TEST(GltfWriter, AnEmptySceneIsAWholeFile) {
  const Glb glb = parse(writeGlb({}, {}));
  EXPECT_EQ(glb.doc["asset"]["version"], "2.0");
  EXPECT_FALSE(glb.doc.contains("meshes"));
}

TEST(GltfWriter, UpIsYOnceTheRootHasTurned) {
  const Glb glb = parse(writeGlb(oneTriangle(), {}, {10, 20, 30}));
  const std::size_t root = glb.doc["scenes"][0]["nodes"][0].get<std::size_t>();
  const json& node = glb.doc["nodes"][root];
  const auto q = node["rotation"].get<std::vector<double>>();
  // Turning (0, 0, 1) by the quaternion gives (0, 1, 0).
  EXPECT_NEAR(2 * (q[0] * q[2] + q[3] * q[1]), 0, 1e-12);
  EXPECT_NEAR(2 * (q[1] * q[2] - q[3] * q[0]), 1, 1e-12);
  EXPECT_EQ(node["translation"], json({10.0, 30.0, -20.0}));
}

TEST(GltfWriter, VerticesHaveBoundsUnitNormalsAndVDown) {
  render::Scene scene = oneTriangle();
  auto picture = std::make_shared<render::Texture>();
  picture->width = picture->height = 1;
  picture->rgba = {255, 128, 0, 255};
  scene.surfaces[0].baseColorMap = picture;
  scene.surfaces[0].uvScale = {2, 4};
  scene.surfaces[0].uvOffset = {0.5f, 0};
  const Glb glb = parse(writeGlb(scene, {}));
  const json& attributes = glb.doc["meshes"][0]["primitives"][0]["attributes"];
  const json& positions = glb.doc["accessors"][attributes["POSITION"].get<std::size_t>()];
  EXPECT_EQ(positions["min"], json({0.0, 0.0, 0.0}));
  EXPECT_EQ(positions["max"], json({2.0, 3.0, 1.0}));
  const auto normals = floats(glb, attributes["NORMAL"].get<std::size_t>());
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(std::hypot(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]), 1, 1e-6);
  const auto uvs = floats(glb, attributes["TEXCOORD_0"].get<std::size_t>());
  EXPECT_EQ(uvs, (std::vector<float>{0.5f, 1, 2.5f, 1, 0.5f, -3}));
  EXPECT_EQ(glb.doc["images"][0]["mimeType"], "image/png");
}

TEST(GltfWriter, InstancesShareTheirMesh) {
  render::Scene scene = oneTriangle();
  scene.instances.push_back({.mesh = 0, .transform = Transformf::translation({5, 0, 0}), .surfaces = {0}});
  const Glb glb = parse(writeGlb(scene, {}));
  EXPECT_EQ(glb.doc["meshes"].size(), 1u);
  EXPECT_EQ(glb.doc["nodes"].size(), 3u);
  EXPECT_EQ(glb.doc["nodes"][1]["matrix"][12], 5.0);
}

TEST(GltfWriter, ShearIsWrittenIntoTheMesh) {
  render::Scene scene = oneTriangle();
  scene.instances[0].transform.y = {1, 1, 0};
  const Glb glb = parse(writeGlb(scene, {}));
  EXPECT_FALSE(glb.doc["nodes"][0].contains("matrix"));
  const auto attribute = glb.doc["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
  EXPECT_EQ(glb.doc["accessors"][attribute]["max"], json({3.0, 3.0, 1.0}));
}

TEST(GltfWriter, GlassAndGlowAreExtensions) {
  render::Scene scene = oneTriangle();
  scene.surfaces[0].transmission = 0.9f;
  scene.surfaces[0].ior = 1.52f;
  scene.surfaces[0].emission = {500, 250, 0};
  const Glb glb = parse(writeGlb(scene, {}));
  const json& m = glb.doc["materials"][0];
  EXPECT_NEAR(m["extensions"]["KHR_materials_transmission"]["transmissionFactor"].get<double>(), 0.9, 1e-6);
  EXPECT_NEAR(m["extensions"]["KHR_materials_ior"]["ior"].get<double>(), 1.52, 1e-6);
  EXPECT_EQ(m["emissiveFactor"], json({1.0, 0.5, 0.0}));
  EXPECT_EQ(m["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"], 500.0);
  for (const auto& [name, value] : m["extensions"].items())
    EXPECT_EQ(std::ranges::count(glb.doc["extensionsUsed"].get<std::vector<std::string>>(), name), 1) << name;
}

TEST(GltfWriter, LampsAreInCandelaAndTheSunInLux) {
  render::Scene scene;
  scene.lamps.push_back({.position = {1, 2, 3}, .radius = 0.05f, .intensity = {100, 50, 25}});
  scene.sun = {{0, 0, 1}, {90000, 90000, 90000}};
  const Glb glb = parse(writeGlb(scene, {}));
  const json& lights = glb.doc["extensions"]["KHR_lights_punctual"]["lights"];
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_EQ(lights[0]["type"], "point");
  EXPECT_EQ(lights[0]["intensity"], 100.0);
  EXPECT_EQ(lights[0]["color"], json({1.0, 0.5, 0.25}));
  EXPECT_EQ(lights[1]["type"], "directional");
  EXPECT_EQ(lights[1]["intensity"], 90000.0);
  // Light leaves along -z of its node: down, for a sun at the zenith.
  EXPECT_NEAR(glb.doc["nodes"][1]["matrix"][10].get<double>(), 1, 1e-6);
}

TEST(GltfWriter, CamerasKeepTheirFieldOfView) {
  GltfCamera camera{"sofa", {}, 2.0};
  camera.camera.horizontalFov = 1.2f;
  GltfCamera fisheye{"round", {}, 1.0};
  fisheye.camera.projection = render::Projection::Fisheye;
  const std::vector<GltfCamera> both{camera, fisheye};
  const Glb glb = parse(writeGlb({}, both));
  ASSERT_EQ(glb.doc["cameras"].size(), 1u);
  EXPECT_NEAR(glb.doc["cameras"][0]["perspective"]["yfov"].get<double>(), 2 * std::atan(std::tan(0.6) / 2),
              1e-6);
}

}  // namespace
}  // namespace idap
