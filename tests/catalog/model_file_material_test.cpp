#include <gtest/gtest.h>

#include "catalog/default_materials.h"
#include "catalog/light_power.h"
#include "catalog/model_file_material.h"
#include "catalog/model_rotation.h"
#include "catalog/opening_kind.h"

namespace idap {
namespace {

TEST(ModelFileMaterial, DefaultMaterialsOfJava3dAreKnownByName) {
  ASSERT_TRUE(findDefaultMaterial("flblonde"));
  EXPECT_FLOAT_EQ(findDefaultMaterial("flblonde")->color.r, 0.5714f);
  for (const char* name : {"white", "silver", "amber", "iris", "dkgrey", "flwhite1", "yellow_green",
                           "flltgrey", "red", "bone2", "sand_stone", "flltbrown", "yellowbrt", "default"})
    EXPECT_TRUE(findDefaultMaterial(name)) << name;
  EXPECT_FALSE(findDefaultMaterial("None"));
  EXPECT_EQ(defaultPhongMaterial("None").diffuse, findDefaultMaterial("default")->color);
}

TEST(ModelFileMaterial, TransparentDefaultsAreGlass) {
  for (const char* name : {"glasstransparent", "amber_trans", "smoked_glass", "ruby", "glassblutint"}) {
    const Material m = materialOf(defaultPhongMaterial(name), SlotRole::Plain, nullptr);
    EXPECT_GT(m.transmission, 0.3) << name;
    EXPECT_TRUE(m.thin);
  }
}

TEST(ModelFileMaterial, MtlStatementsAndTheirOddities) {
  const auto all = parseMtl(
      "# c\nKd 1 0 0\nnewmtl one\n  Kd 0.5\n\tKs .25 .5 .75\nNs 40\nTr 0.4\nNi 1.33\nillum 9\nKe 1 2 3\n"
      "map_Kd -blendu on -o 1 2 3 my picture.png\r\nnewmtl two\nKd spectral f.rfl\nd -halo 0.5\nillum x\nNs "
      "nan");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].diffuse, (Color{0.5f, 0.5f, 0.5f}));
  EXPECT_FLOAT_EQ(all[0].specular.b, 0.75f);
  EXPECT_DOUBLE_EQ(all[0].opacity, 0.6);
  EXPECT_DOUBLE_EQ(all[0].ior, 1.33);
  EXPECT_EQ(all[0].illumination, 9);
  EXPECT_EQ(all[0].emission, (Vec3{1, 2, 3}));
  EXPECT_EQ(all[0].diffuseMap, "my picture.png");
  EXPECT_DOUBLE_EQ(all[1].opacity, 0.5);
  EXPECT_DOUBLE_EQ(all[1].exponent, 0);
}

TEST(ModelFileMaterial, OpacityMapsComeAlongUnlessThePictureIsItsOwn) {
  const auto all =
      parseMtl("newmtl leaf\nmap_Kd leaf.png\nmap_d mask.png\nnewmtl own\nmap_Kd a.png\nmap_d a.png");
  ASSERT_EQ(all.size(), 2u);
  const SiblingFiles any = [](const std::string&) { return std::make_shared<const Bytes>(Bytes(1)); };
  const Material leaf = materialOf(all[0], SlotRole::Plain, any);
  ASSERT_TRUE(leaf.opacityMap);
  EXPECT_EQ(leaf.opacityMap->name, "mask.png");
  EXPECT_FALSE(materialOf(all[1], SlotRole::Plain, any).opacityMap);
}

TEST(ModelFileMaterial, SharperHighlightsAreSmootherSurfaces) {
  EXPECT_GT(roughnessOfPhong(0.3, 5), roughnessOfPhong(0.3, 60));
  EXPECT_GT(roughnessOfPhong(0.3, 60), roughnessOfPhong(0.3, 1000));
  EXPECT_DOUBLE_EQ(roughnessOfPhong(0, 1000), roughnessOfPhong(0, 1)) << "no highlight: matt";
  EXPECT_NEAR(roughnessOfPhong(1, 0), 0.9, 1e-12);
}

TEST(ModelFileMaterial, ModelRotationGoesFromYUpRowsToZUpColumns) {
  const auto identity = modelRotationOf("1 0 0 0 1 0 0 0 1");
  ASSERT_TRUE(identity);
  EXPECT_EQ((*identity)[0], (Vec3{1, 0, 0}));
  EXPECT_EQ((*identity)[1], (Vec3{0, 1, 0}));
  EXPECT_EQ((*identity)[2], (Vec3{0, 0, 1}));
  // The file's x goes to its z, to the front: our right side comes to the front, which is -y.
  const auto turned = modelRotationOf("0 0 -1 0 1 0 1 0 0");
  ASSERT_TRUE(turned);
  EXPECT_EQ((*turned)[0], (Vec3{0, -1, 0}));
  EXPECT_EQ((*turned)[2], (Vec3{0, 0, 1}));
  EXPECT_FALSE(modelRotationOf("1 0 0"));
  EXPECT_FALSE(modelRotationOf("1 0 0 0 1 0 0 0 nan"));
}

TEST(ModelFileMaterial, PowerOfALampBecomesTheLumensOfABulb) {
  const Color warm{0x99 / 255.f, 0x87 / 255.f, 0x64 / 255.f};
  const Lamp lamp = lampOf(0.5, {{{0.5, 0.5, 1}, warm, 0.06}});
  EXPECT_NEAR(lamp.lumens, 800, 20);
  ASSERT_TRUE(lamp.color);
  EXPECT_FLOAT_EQ(lamp.color->r, 1);
  EXPECT_NEAR(lamp.color->b, 100.f / 153, 1e-5);
  EXPECT_NEAR(lampOf(1, {{{0.5, 0.5, 1}, warm, {}}}).lumens, 4 * lamp.lumens, 1e-9)
      << "flux goes with power squared";
  const Lamp two = lampOf(0.5, {{{0, 0, 0}, warm, {}}, {{1, 0, 0}, Color{0, 0, 1}, {}}});
  EXPECT_GT(two.lumens, lamp.lumens);
  EXPECT_TRUE(two.sources[1].color);
  EXPECT_LT(two.sources[1].share, two.sources[0].share);
  EXPECT_FALSE(lampOf(0, {{{0, 0, 0}, warm, {}}}).on);
  EXPECT_GT(lampOf(0.5, {}).lumens, 0);
}

TEST(ModelFileMaterial, WindowsThatOneWalksThroughAreDoors) {
  EXPECT_EQ(openingKindOf("eTeks#frenchWindow85x200", "French window", 0.1, 2.1, true), OpeningKind::Door);
  EXPECT_EQ(openingKindOf("eTeks#fixedWindow85x123", "Fixed window", 0.1, 2.1, false), OpeningKind::Window);
  EXPECT_EQ(openingKindOf("eTeks#doubleWindow126x123", "Double window", 1, 1.2, true), OpeningKind::Window);
  EXPECT_EQ(openingKindOf("eTeks#doorFrame", "Door frame", 0, 2.1, false), OpeningKind::Bare);
  EXPECT_EQ(openingKindOf("", "Fenêtre", 1, 1.2, true), OpeningKind::Window);
  EXPECT_EQ(openingKindOf("", "Porte", 0, 2.04, true), OpeningKind::Door);
}

}  // namespace
}  // namespace idap
