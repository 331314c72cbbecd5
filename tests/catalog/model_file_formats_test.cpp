// The formats that assimp reads, and archives.
#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "base/error.h"
#include "base/zip.h"
#include "catalog/model_file.h"

namespace idap {
namespace {

Bytes bytesOf(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

SurfaceModel read(const std::string& content, const std::string& name) {
  return readModelFile(bytesOf(content), name, nullptr);
}

// The highest vertex and where it is from front (-0.5) to back (0.5).
Vec3f top(const SurfaceModel& model) {
  Vec3f best{0, 0, -1};
  for (const Vec3f& p : model.mesh.positions)
    if (p.z > best.z) best = p;
  return best;
}

TEST(ModelFileFormats, AsciiStlStandsOnItsZ) {
  const SurfaceModel model = read(
      "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 5\nendloop\nendfacet\n"
      "endsolid s\n",
      "part.stl");
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  EXPECT_FLOAT_EQ(top(model).z, 1);
  EXPECT_FLOAT_EQ(top(model).y, 0.5f);
}

TEST(ModelFileFormats, ColladaWithItsColourAndAxis) {
  const std::string dae = R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>0.8 0.1 0.2 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="paint"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 5</float_array><technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1" material="mm"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="mm" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
  const SurfaceModel model = read(dae, "12");
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  EXPECT_FLOAT_EQ(top(model).z, 1);
  EXPECT_FLOAT_EQ(top(model).y, 0.5f) << "the file's y runs to the back where z is up";
  ASSERT_FALSE(model.slots.empty());
  const Color color = model.slots[model.mesh.slotOf(0)].material.color;
  EXPECT_FLOAT_EQ(color.r, 0.8f);
  EXPECT_FLOAT_EQ(color.g, 0.1f);
}

TEST(ModelFileFormats, GltfIsYUp) {
  std::string positions(36, '\0');
  const float values[9] = {0, 0, 0, 1, 0, 0, 0, 5, -1};
  std::memcpy(positions.data(), values, 36);
  std::string encoded;
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return std::uint32_t(static_cast<unsigned char>(positions[i + k]));
    };
    const std::uint32_t bits = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int shift = 18; shift >= 0; shift -= 6) encoded += kDigits[bits >> shift & 63];
  }
  const SurfaceModel model = read(
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"name":"steel","pbrMetallicRoughness":{"metallicFactor":1,"roughnessFactor":0.25,"baseColorFactor":[1,1,1,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,-1],"max":[1,5,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
          encoded + "\"}]}",
      "thing.gltf");
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  EXPECT_FLOAT_EQ(top(model).z, 1);
  EXPECT_FLOAT_EQ(top(model).y, 0.5f) << "-z of the file is the back";
  EXPECT_NEAR(model.slots[model.mesh.slotOf(0)].material.roughness, 0.25, 1e-6);
  EXPECT_NEAR(model.slots[model.mesh.slotOf(0)].material.metalness, 1, 1e-6);
}

// A chunk of a 3DS file.
std::string chunk(std::uint16_t id, const std::string& content) {
  std::string result;
  const auto put = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) result += static_cast<char>(static_cast<unsigned char>(value >> (8 * i)));
  };
  put(id, 2);
  put(std::uint32_t(content.size()) + 6, 4);
  return result + content;
}

TEST(ModelFileFormats, ThreeDsIsZUp) {
  std::string vertices(2, '\0');
  vertices[0] = 3;
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 5.f}) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (int i = 0; i < 4; ++i) vertices += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  }
  const std::string faces{1, 0, 0, 0, 1, 0, 2, 0, 0, 0};
  const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  const std::string object = chunk(0x4000, std::string("thing") + '\0' + mesh);
  const SurfaceModel model = read(chunk(0x4D4D, chunk(0x3D3D, object)), "7");
  ASSERT_EQ(model.mesh.triangles.size(), 1u);
  EXPECT_FLOAT_EQ(top(model).z, 1);
  EXPECT_FLOAT_EQ(top(model).y, 0.5f);
}

TEST(ModelFileFormats, AnArchiveOfAModelWithItsMaterials) {
  const auto file = [](const std::string& text) { return std::make_shared<const Bytes>(bytesOf(text)); };
  const Bytes archive = writeZip(
      {{"readme.txt", file("hello")},
       {"chair/chair.mtl", file("newmtl a\nKd 0.5 0 0\n")},
       {"chair/chair.obj", file("mtllib chair.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")}});
  const SurfaceModel model = readModelFile(archive, "chair.zip", nullptr);
  EXPECT_FLOAT_EQ(model.slots.at(0).material.color.r, 0.5f);
  EXPECT_THROW(readModelFile(writeZip({{"readme.txt", file("hello")}}), "chair.zip", nullptr), ParseError);
  EXPECT_THROW(readModelFile(writeZip({{"a.obj", std::make_shared<const Bytes>(archive)}}), "x.zip", nullptr),
               ParseError);
}

TEST(ModelFileFormats, ForeignAndDamagedFilesAreRefused) {
  for (const char* content : {"", "hello", "\x89PNG\r\n", "{", "{\"asset\":1}", "MM______________",
                              "glTF____", "<COLLADA>", "PK\x03\x04 broken", "solid facet"})
    EXPECT_THROW(read(content, "file"), ParseError) << content;
  EXPECT_EQ(modelFileKind(bytesOf("v 1 2 3\n"), "12"), "obj");
  EXPECT_EQ(modelFileKind(bytesOf("hello"), "12"), "");
}

}  // namespace
}  // namespace idap
