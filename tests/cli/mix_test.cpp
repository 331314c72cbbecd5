// Lights of a finished picture, dimmed and switched by the program itself.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "render/film/picture_file.h"
#include "support/program.h"

namespace idap {
namespace {

using testing::HasSubstr;

class Mix : public test::ProgramTest {
 protected:
  void render(const std::string& name, const std::string& lamps) {
    const auto outcome = run("render " + sample() + " -o " + name +
                             " --camera Bedroom --size 48x32 --spp 64 --lamps " + lamps);
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }
  double brightness(const std::string& name) {
    const render::Film film = render::loadLayers(path(name)).film;
    double sum = 0;
    for (std::size_t i = 0; i < film.pixels(); ++i) sum += static_cast<double>(luminance(film.meanColor(i)));
    return sum / static_cast<double>(film.pixels());
  }
};

TEST_F(Mix, WithTheLampsOffItIsThePictureWithoutThem) {
  render("on.exr", "on");
  render("off.exr", "off");
  const auto listed = run("mix on.exr --json");
  ASSERT_EQ(listed.status, 0) << listed.err;
  const auto lights = nlohmann::json::parse(listed.out);
  double all = 0;
  for (const auto& light : lights) all += light["share"].get<double>();
  EXPECT_NEAR(all, 1, 1e-6);
  EXPECT_EQ(lights[0]["name"], "sky");
  EXPECT_EQ(lights[1]["name"], "sun");
  EXPECT_GT(lights.size(), 5u);
  EXPECT_TRUE(lights[2]["recolourable"]);

  const auto mixed = run("mix on.exr -o mixed.exr --set '*=off' --set sky=on --set sun=on");
  ASSERT_EQ(mixed.status, 0) << mixed.err;
  EXPECT_NEAR(brightness("mixed.exr") / brightness("off.exr"), 1, 0.03);
  EXPECT_LT(brightness("mixed.exr"), brightness("on.exr"));
}

TEST_F(Mix, WhatCannotBeIsSaidInOneLine) {
  render("on.exr", "on");
  const auto wrong = [&](const std::string& arguments, int status, const char* words) {
    const auto outcome = run("mix " + arguments);
    EXPECT_EQ(outcome.status, status) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(words));
  };
  wrong("on.exr -o a.png --set chandelier=0", 2, "there is no such light");
  wrong("on.exr -o a.png --set sky", 2, "floor lamp=0.3,2700K");
  wrong("on.exr -o a.png --set sky=blue", 2, "neither a strength");
  wrong("on.exr -o a.png --set sky=3000K", 1, "is not known");
  wrong("on.exr --set sky=0", 2, "-o");
  wrong("none.exr", 1, "none.exr");
  run("render " + sample() + " -o a.png --size 32x20 --spp 1");
  wrong("a.png", 1, "no OpenEXR");
}

TEST_F(Mix, LightsAreKeptApartAsAsked) {
  const std::string how = "render " + sample() + " --camera Bedroom --size 32x20 --spp 2 --lamps on -o ";
  ASSERT_EQ(run(how + "apart.exr --light-groups").status, 0);
  EXPECT_GT(render::loadLayers(path("apart.exr")).groups.size(), 5u);
  ASSERT_EQ(run(how + "together.exr --no-light-groups").status, 0);
  EXPECT_TRUE(render::loadLayers(path("together.exr")).film.groups.empty());
  EXPECT_THAT(run("mix together.exr -o a.png --set sun=0").err, HasSubstr("--light-groups"));
  EXPECT_EQ(run(how + "a.png --light-groups").status, 2);
  EXPECT_EQ(run(how + "a.exr --quick --light-groups").status, 2);
  EXPECT_EQ(run("mix apart.exr -o stops.png --tone false").status, 0);
}

TEST_F(Mix, APictureIsGoneOnWith) {
  const std::string how = "render " + sample() + " --camera Bedroom --size 48x32 --lamps on ";
  ASSERT_EQ(run(how + "-o a.exr --spp 4").status, 0);
  const auto more = run(how + "-o a.exr --spp 16 --resume --json");
  ASSERT_EQ(more.status, 0) << more.err;
  const auto json = nlohmann::json::parse(more.out);
  EXPECT_EQ(json["spp"], 16);
  EXPECT_EQ(json["paths"], 48 * 32 * 12);
  ASSERT_EQ(run(how + "-o b.exr --spp 16").status, 0);
  EXPECT_NEAR(brightness("a.exr") / brightness("b.exr"), 1, 0.1);
  EXPECT_EQ(run(how + "-o a.exr --spp 16 --resume").status, 0) << "done already";
  const auto other = run(how + "-o a.exr --spp 32 --resume --at 2026-06-21T10:00");
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("another home, view or size"));
  EXPECT_EQ(run(how + "-o a.png --resume").status, 2);
}

}  // namespace
}  // namespace idap
