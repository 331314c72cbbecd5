// A small model of every kind through the import dialog: upright, in its true size, with its colours; looked
// at from all sides before it is taken.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <cstring>

#include "base/file.h"
#include "gui/support/gui_support.h"
#include "studio/catalog/import_dialog.h"
#include "studio/catalog/model_preview.h"
#include "studio/catalog/part_finishes.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_picker.h"

namespace idap {
namespace {

// A post 0.4 m wide, 0.2 m deep and 1 m high, as triangles with z up; the corner is cut so that it has a
// front.
constexpr float kPost[8][3] = {{0, 0, 0},   {0.4f, 0, 0},   {0.4f, 0.2f, 0},   {0, 0.2f, 0},
                               {0, 0, 1.f}, {0.4f, 0, 1.f}, {0.4f, 0.2f, 1.f}, {0, 0.2f, 1.f}};
constexpr int kFaces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                               {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

void put(std::string& to, const void* bytes, std::size_t count) {
  to.append(static_cast<const char*>(bytes), count);
}

// The corners of the file, scaled, y up or z up.
Vec3f corner(int i, float scale, bool yUp) {
  const float* p = kPost[i];
  return yUp ? Vec3f{p[0] * scale, p[2] * scale, -p[1] * scale}
             : Vec3f{p[0] * scale, p[1] * scale, p[2] * scale};
}

std::string number(float value) { return std::to_string(value); }

std::string obj() {
  std::string text = "mtllib post.mtl\nusemtl red\n";
  for (int i = 0; i < 8; ++i) {
    const Vec3f p = corner(i, 100, true);  // centimetres
    text += "v " + number(p.x) + " " + number(p.y) + " " + number(p.z) + "\n";
  }
  for (const auto& f : kFaces)
    text += "f " + std::to_string(f[0] + 1) + " " + std::to_string(f[1] + 1) + " " +
            std::to_string(f[2] + 1) + "\n";
  return text;
}

std::string binaryStl() {
  std::string file(80, ' ');
  const std::uint32_t count = 12;
  put(file, &count, 4);
  for (const auto& f : kFaces) {
    file.append(12, '\0');
    for (const int i : f) {
      const Vec3f p = corner(i, 1000, false);  // millimetres
      put(file, &p.x, 4), put(file, &p.y, 4), put(file, &p.z, 4);
    }
    file.append(2, '\0');
  }
  return file;
}

std::string collada() {
  std::string positions, indices;
  for (int i = 0; i < 8; ++i) {
    const Vec3f p = corner(i, 1, false);
    positions += number(p.x) + " " + number(p.y) + " " + number(p.z) + " ";
  }
  for (const auto& f : kFaces)
    for (const int i : f) indices += std::to_string(i) + " ";
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse><color>0.8 0.1 0.1 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m" name="red"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="24">)" +
         positions +
         R"(</float_array><technique_common><accessor source="#pa" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="12" material="mm"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         indices +
         R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="mm" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

// Vertices and indices of the post, in metres, y up: a glTF buffer.
std::string gltfBuffer() {
  std::string bytes;
  for (int i = 0; i < 8; ++i) {
    const Vec3f p = corner(i, 1, true);
    put(bytes, &p.x, 4), put(bytes, &p.y, 4), put(bytes, &p.z, 4);
  }
  for (const auto& f : kFaces)
    for (const int i : f) {
      const auto index = static_cast<std::uint16_t>(i);
      put(bytes, &index, 2);
    }
  return bytes;
}

std::string gltfText(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"name":"red","pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.6,"baseColorFactor":[0.6,0.02,0.02,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[0,0,-0.2],"max":[0.4,1,0]},
{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72}],
"buffers":[{"byteLength":168)" +
         uri + "}]}";
}

std::string glb() {
  std::string json = gltfText("");
  while (json.size() % 4) json += ' ';
  std::string buffer = gltfBuffer();
  while (buffer.size() % 4) buffer += '\0';
  std::string file = "glTF";
  const auto word = [&](std::size_t value) {
    const auto v = static_cast<std::uint32_t>(value);
    put(file, &v, 4);
  };
  word(2), word(12 + 8 + json.size() + 8 + buffer.size());
  word(json.size()), file += "JSON", file += json;
  word(buffer.size()), file += std::string("BIN\0", 4), file += buffer;
  return file;
}

std::string chunk(std::uint16_t id, const std::string& content) {
  std::string result;
  put(result, &id, 2);
  const auto size = static_cast<std::uint32_t>(content.size() + 6);
  put(result, &size, 4);
  return result + content;
}

std::string threeDs() {
  std::string vertices, faces;
  const std::uint16_t eight = 8, twelve = 12, flags = 0;
  put(vertices, &eight, 2);
  for (int i = 0; i < 8; ++i) {
    const Vec3f p = corner(i, 100, false);
    put(vertices, &p.x, 4), put(vertices, &p.y, 4), put(vertices, &p.z, 4);
  }
  put(faces, &twelve, 2);
  for (const auto& f : kFaces) {
    for (const int i : f) {
      const auto index = static_cast<std::uint16_t>(i);
      put(faces, &index, 2);
    }
    put(faces, &flags, 2);
  }
  const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, faces));
  return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, std::string("post") + '\0' + mesh)));
}

class ImportFormatsTest : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& content) {
    const auto path = std::filesystem::path(folder.path().toStdString()) / name;
    const auto* begin = reinterpret_cast<const std::byte*>(content.data());
    writeFileAtomically(path, Bytes(begin, begin + content.size()));
    return path;
  }
  template <class T>
  T* find(const char* name) {
    return dialog.findChild<T*>(QString::fromLatin1(name));
  }
  ModelPreview* picture() { return find<ModelPreview>("importPicture"); }
  bool read(const std::filesystem::path& file) {
    dialog.show();
    dialog.chooseFile(file);
    return test::waitFor([&] { return find<QPushButton>("importFinish")->isVisible(); }, 20'000);
  }
  bool pictured() {
    return test::waitFor([&] { return !picture()->pixmap(Qt::ReturnByValue).isNull(); }, 20'000);
  }
  void expectPost() {
    EXPECT_NEAR(find<LengthField>("importWidth")->value(), 0.4, 1e-5);
    EXPECT_NEAR(find<LengthField>("importDepth")->value(), 0.2, 1e-5);
    EXPECT_NEAR(find<LengthField>("importHeight")->value(), 1, 1e-5);
    EXPECT_TRUE(pictured());
    QTest::mouseClick(find<QPushButton>("importFinish"), Qt::LeftButton);
    ASSERT_EQ(editor.home().furniture.size(), 1u);
    const Furniture& piece = *editor.home().furniture.begin()->second;
    EXPECT_NEAR(piece.size.z, 1, 1e-5);
    EXPECT_FALSE(piece.model.asset.empty());
  }

  QTemporaryDir folder;
  std::shared_ptr<const Catalog> catalog =
      std::make_shared<const Catalog>(std::vector<std::filesystem::path>{});
  Editor editor{catalog};
  ImportDialog dialog{editor};
};

TEST_F(ImportFormatsTest, ObjInCentimetres) {
  write("post.mtl", "newmtl red\nKd 0.8 0.1 0.1\n");
  ASSERT_TRUE(read(write("post.obj", obj())));
  EXPECT_EQ(find<QComboBox>("importUnit")->currentIndex(), 1);
  expectPost();
}

TEST_F(ImportFormatsTest, StlInMillimetresStandsOnItsZ) {
  ASSERT_TRUE(read(write("post.stl", binaryStl())));
  EXPECT_EQ(find<QComboBox>("importUnit")->currentIndex(), 2);
  EXPECT_EQ(find<QComboBox>("importUp")->currentIndex(), 1);
  expectPost();
}

TEST_F(ImportFormatsTest, ColladaInMetres) {
  ASSERT_TRUE(read(write("post.dae", collada())));
  EXPECT_EQ(find<QComboBox>("importUp")->currentIndex(), 1);
  expectPost();
}

TEST_F(ImportFormatsTest, GltfWithItsBufferBeside) {
  write("post.bin", gltfBuffer());
  ASSERT_TRUE(read(write("post.gltf", gltfText(R"(,"uri":"post.bin")"))));
  EXPECT_EQ(find<QComboBox>("importUnit")->currentIndex(), 0);
  expectPost();
  EXPECT_EQ(editor.home().assets->size(), 2u);
}

TEST_F(ImportFormatsTest, BinaryGltf) {
  ASSERT_TRUE(read(write("post.glb", glb())));
  expectPost();
}

TEST_F(ImportFormatsTest, ThreeDs) {
  ASSERT_TRUE(read(write("post.3ds", threeDs())));
  EXPECT_EQ(find<QComboBox>("importUp")->currentIndex(), 1);
  expectPost();
}

TEST_F(ImportFormatsTest, AnotherAxisLaysItDownAndQuarterTurnsTurnIt) {
  ASSERT_TRUE(read(write("post.stl", binaryStl())));
  auto* up = find<QComboBox>("importUp");
  up->setFocus();
  QTest::keyClick(up, Qt::Key_Up);  // y
  EXPECT_NEAR(find<LengthField>("importHeight")->value(), 0.2, 1e-5);
  EXPECT_NEAR(find<LengthField>("importDepth")->value(), 1, 1e-5);
  QTest::mouseClick(find<QPushButton>("importTurnBack"), Qt::LeftButton);
  EXPECT_NEAR(find<LengthField>("importWidth")->value(), 1, 1e-5);
}

TEST_F(ImportFormatsTest, DraggingTurnsThePreview) {
  write("post.mtl", "newmtl red\nKd 0.8 0.1 0.1\n");
  ASSERT_TRUE(read(write("post.obj", obj())));
  ASSERT_TRUE(pictured());
  const double before = picture()->turn();
  const QPixmap seen = picture()->pixmap(Qt::ReturnByValue);
  QTest::mousePress(picture(), Qt::LeftButton, {}, QPoint(100, 100));
  QTest::mouseMove(picture(), QPoint(180, 120));
  QTest::mouseRelease(picture(), Qt::LeftButton, {}, QPoint(180, 120));
  EXPECT_NE(picture()->turn(), before);
  EXPECT_TRUE(test::waitFor([&] { return picture()->pixmap(Qt::ReturnByValue).toImage() != seen.toImage(); },
                            20'000));
  QTest::qWait(1500);
  test::shoot(dialog, "import-preview");
}

TEST_F(ImportFormatsTest, PartsGetColoursOfOnesChoice) {
  write("post.mtl", "newmtl red\nKd 0.8 0.1 0.1\n");
  ASSERT_TRUE(read(write("post.obj", obj())));
  auto* part = find<MaterialPicker>("importPart-red");
  ASSERT_TRUE(part);
  Finish oak;
  oak.material = "oak";
  emit part->finishChosen({oak, {}, {}});  // as its popup does
  QTest::mouseClick(find<QPushButton>("importFinish"), Qt::LeftButton);
  ASSERT_EQ(editor.home().furniture.size(), 1u);
  const Furniture& piece = *editor.home().furniture.begin()->second;
  ASSERT_TRUE(piece.slotFinishes.contains("red"));
  EXPECT_EQ(piece.slotFinishes.at("red").material, "oak");
}

TEST_F(ImportFormatsTest, CutOffFilesGiveWords) {
  for (const auto& [name, content] : {std::pair{"post.stl", binaryStl()},
                                      {"post.glb", glb()},
                                      {"post.3ds", threeDs()},
                                      {"post.dae", collada()}}) {
    SCOPED_TRACE(name);
    for (const std::size_t part : {content.size() / 3, content.size() / 2}) {
      dialog.show();
      dialog.chooseFile(write(name, content.substr(0, part)));
      auto* problem = find<QLabel>("importProblem");
      // Either what is left is a model, or there are words.
      ASSERT_TRUE(test::waitFor(
          [&] { return problem->isVisible() || find<QPushButton>("importFinish")->isVisible(); }, 20'000));
      if (problem->isVisible()) {
        EXPECT_FALSE(problem->text().isEmpty());
      }
    }
  }
}

}  // namespace
}  // namespace idap
