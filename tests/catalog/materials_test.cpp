#include <gtest/gtest.h>

#include <set>
#include <thread>

#include "catalog/material.h"
#include "light/rgb.h"

namespace idap {
namespace {

Rgb linear(Color c) { return {srgbToLinear(c.r), srgbToLinear(c.g), srgbToLinear(c.b)}; }

TEST(Materials, OffersWhatAHomeIsMadeOf) {
  EXPECT_GE(materialIds().size(), 60u);
  for (const char* id : {"oak",
                         "walnut",
                         "birch",
                         "beech",
                         "pine",
                         "cherry",
                         "wenge",
                         "teak",
                         "bamboo",
                         "white-lacquer",
                         "black-lacquer",
                         "white-paint",
                         "chrome",
                         "brushed-steel",
                         "brass",
                         "black-steel",
                         "copper",
                         "aluminium",
                         "glass",
                         "frosted-glass",
                         "smoked-glass",
                         "mirror",
                         "linen",
                         "grey-wool",
                         "velvet",
                         "cognac-leather",
                         "cotton",
                         "white-ceramic",
                         "marble",
                         "black-marble",
                         "granite",
                         "terrazzo",
                         "concrete",
                         "white-tiles",
                         "terracotta-tiles",
                         "oak-herringbone",
                         "oak-planks",
                         "carpet",
                         "leaf",
                         "soil",
                         "terracotta",
                         "paper-shade",
                         "rattan",
                         "cork",
                         "brick"})
    EXPECT_NE(findMaterial(id), nullptr) << id;
  EXPECT_EQ(findMaterial("unobtainium"), nullptr);
}

TEST(Materials, EachHasAnEnglishAndAThaiName) {
  std::set<std::string> seen;
  for (const std::string& id : materialIds()) {
    const std::string english = materialName(id, "en"), thai = materialName(id, "th");
    EXPECT_FALSE(english.empty()) << id;
    EXPECT_NE(english, thai) << id;
    EXPECT_TRUE(seen.insert(english).second) << english << " is there twice";
    EXPECT_EQ(materialName(id, "fr"), english);
    EXPECT_FALSE(materialGroup(id).empty()) << id;
  }
}

TEST(Materials, ReflectNoMoreThanMatterDoes) {
  for (const std::string& id : materialIds()) {
    const Material& m = *findMaterial(id);
    EXPECT_GE(m.roughness, 0) << id;
    EXPECT_LE(m.roughness, 1) << id;
    EXPECT_TRUE(m.metalness == 0 || m.metalness == 1) << id;
    EXPECT_GE(m.ior, 1) << id;
    if (m.metalness == 0 && m.transmission == 0 && materialGroup(id) != "light" && !m.texture) {
      EXPECT_LT(luminance(linear(m.color)), 0.88f) << id;  // fresh white paint stays below
    }
  }
  EXPECT_NEAR(luminance(linear(findMaterial("white-paint")->color)), 0.8, 0.05);
}

TEST(Materials, AMirrorIsPerfectAndWindowGlassIsAClearSheet) {
  const Material& mirror = *findMaterial("mirror");
  EXPECT_EQ(mirror.metalness, 1);
  EXPECT_EQ(mirror.roughness, 0);
  EXPECT_GT(luminance(linear(mirror.color)), 0.85f);
  const Material& glass = *findMaterial("glass");
  EXPECT_EQ(glass.transmission, 1);
  EXPECT_TRUE(glass.thin);
  EXPECT_EQ(glass.roughness, 0);
}

TEST(Materials, PicturesAreMadeOnceAndHaveARealSize) {
  const Material* const oak = findMaterial("oak");
  ASSERT_TRUE(oak->texture);
  EXPECT_EQ(asText(*oak->texture->bytes).substr(0, 2), "P6");
  EXPECT_GT(oak->texture->size.x, 0.1);
  const Bytes* const bytes = oak->texture->bytes.get();
  EXPECT_EQ(findMaterial("oak")->texture->bytes.get(), bytes);
}

TEST(Materials, ManyThreadsMayAskAtOnce) {
  std::vector<const Bytes*> seen(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < seen.size(); ++i)
    threads.emplace_back([&seen, i] { seen[i] = findMaterial("granite")->texture->bytes.get(); });
  for (std::thread& t : threads) t.join();
  for (const Bytes* bytes : seen) EXPECT_EQ(bytes, seen[0]);
}

}  // namespace
}  // namespace idap
