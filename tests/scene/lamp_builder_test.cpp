#include "scene/lamp_builder.h"

#include <gtest/gtest.h>

namespace idap {
namespace {

// A cube of 0.4 m around the origin's column, without the side of that index.
Mesh cube(int withoutSide) {
  Mesh m;
  for (int corner = 0; corner < 8; ++corner) {
    m.positions.push_back({corner & 1 ? 0.2f : -0.2f, corner & 2 ? 0.2f : -0.2f, corner & 4 ? 0.4f : 0.0f});
  }
  const std::array<std::array<std::uint32_t, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (int i = 0; i < 6; ++i) {
    if (i == withoutSide) continue;
    const auto& s = sides[static_cast<std::size_t>(i)];
    m.triangles.push_back({s[0], s[1], s[2]});
    m.triangles.push_back({s[0], s[2], s[3]});
  }
  return m;
}

double emitted(const LampLight& light) {
  double lumens = 0;
  for (const render::Lamp& bulb : light.bulbs) lumens += 4 * kPi * double(luminance(bulb.intensity));
  for (const LampLight::Glow& g : light.glows) lumens += kPi * g.area * double(luminance(g.emission));
  return lumens;
}

double area(const LampLight& light) {
  double sum = 0;
  for (const LampLight::Glow& g : light.glows) sum += g.area;
  return sum;
}

struct Setting {
  Mesh mesh;
  Fixture fixture;
  render::Surface surface;
  LampOptions options;

  explicit Setting(Mesh m) : mesh(std::move(m)) {
    fixture.mesh = mesh.empty() ? nullptr : &mesh;
    fixture.size = {0.4, 0.4, 0.4};
    options.lumens = 800;
    options.lightGroup = 3;
  }
  LampLight light(const Lamp& lamp = {}) const { return lampLight(lamp, fixture, {&surface}, options); }
};

TEST(LampBuilder, ALampWithoutFixtureIsAnOrdinaryBulb) {
  const LampLight light = Setting(Mesh{}).light();
  ASSERT_EQ(light.bulbs.size(), 1u);
  EXPECT_FLOAT_EQ(light.bulbs[0].radius, 0.03f);
  EXPECT_NEAR(light.bulbs[0].position.z, 0.2, 1e-6);
  EXPECT_EQ(light.bulbs[0].lightGroup, 3);
  EXPECT_NEAR(emitted(light), 800, 0.1);
}

TEST(LampBuilder, ABulbInAnOpenShadeStays) {
  Setting s(cube(1));
  s.fixture.size.z = 0.6;  // near the opening
  const LampLight light = s.light();
  EXPECT_EQ(light.bulbs.size(), 1u);
  EXPECT_TRUE(light.glows.empty());
  EXPECT_NEAR(emitted(light), 800, 0.1);
}

TEST(LampBuilder, AClosedShadeShinesWithAllTheLumens) {
  const LampLight light = Setting(cube(-1)).light();
  EXPECT_TRUE(light.bulbs.empty());
  EXPECT_NEAR(area(light), 6 * 0.4 * 0.4, 1e-4);  // a closed box shines outwards only
  EXPECT_NEAR(emitted(light), 800, 0.5);
}

TEST(LampBuilder, AShadeWithAnOpeningSharesTheLightWithItsBulb) {
  Setting s(cube(0));
  Lamp lamp;
  lamp.sources.push_back({.position = {0.5, 0.5, 0.9}});
  const LampLight light = s.light(lamp);
  EXPECT_EQ(light.bulbs.size(), 1u);
  EXPECT_NEAR(area(light), 2 * 5 * 0.4 * 0.4, 1e-4);  // an open sheet shines to both sides
  EXPECT_NEAR(emitted(light), 800, 0.5);
}

TEST(LampBuilder, AShadeIsBrightestNearItsBulb) {
  Setting s(cube(-1));
  Lamp lamp;
  lamp.sources.push_back({.position = {0.5, 0.5, 0.8}});
  const LampLight light = s.light(lamp);
  double top = 0, bottom = 0;
  for (const LampLight::Glow& g : light.glows) {
    for (const std::uint32_t t : g.triangles) {
      if (t < 2) bottom = double(luminance(g.emission));
      if (t == 2 || t == 3) top = double(luminance(g.emission));
    }
  }
  EXPECT_GT(bottom, 0);
  EXPECT_GT(top, 1.5 * bottom);
  EXPECT_NEAR(emitted(light), 800, 0.5);
}

TEST(LampBuilder, TheCordOfAShadeStaysDark) {
  Mesh mesh = cube(-1);
  const auto shade = mesh.triangles.size();
  // A square rod of the shade's own slot, from its top upwards.
  Transformf t;
  t.x = {0.02f, 0, 0}, t.y = {0, 0.02f, 0}, t.z = {0, 0, 2}, t.origin = {0, 0, 0.4f};
  append(mesh, cube(-1), t);
  const Setting s(mesh);
  const LampLight light = s.light();
  ASSERT_FALSE(light.glows.empty());
  for (const LampLight::Glow& g : light.glows) {
    for (const std::uint32_t triangle : g.triangles) EXPECT_LT(triangle, shade);
  }
  EXPECT_NEAR(area(light), 6 * 0.4 * 0.4, 1e-4);
  EXPECT_NEAR(emitted(light), 800, 0.5);
}

TEST(LampBuilder, GlassLetsTheBulbBeSeen) {
  Setting s(cube(-1));
  s.surface.transmission = 0.9f;
  EXPECT_EQ(s.light().bulbs.size(), 1u);
}

TEST(LampBuilder, SourcesShareTheLumens) {
  Lamp lamp;
  lamp.sources.push_back({.position = {0.2, 0.5, 0.5}, .share = 3});
  lamp.sources.push_back({.position = {0.8, 0.5, 0.5}, .share = 1});
  const LampLight light = Setting(Mesh{}).light(lamp);
  ASSERT_EQ(light.bulbs.size(), 2u);
  EXPECT_NEAR(luminance(light.bulbs[0].intensity), 3 * luminance(light.bulbs[1].intensity), 1e-2);
  EXPECT_LT(light.bulbs[0].position.x, light.bulbs[1].position.x);
  EXPECT_NEAR(emitted(light), 800, 0.1);
}

TEST(LampBuilder, ABulbStaysClearOfItsFixture) {
  Setting s(cube(1));
  s.fixture.size.z = 0.76;
  Lamp lamp;
  lamp.sources.push_back({.position = {0.5, 0.5, 0.5}, .diameter = 0.6});
  const LampLight light = s.light(lamp);
  ASSERT_EQ(light.bulbs.size(), 1u);
  EXPECT_LT(light.bulbs[0].radius, 0.2f);
}

TEST(LampBuilder, DarkColoursOnlySetTheTint) {
  Lamp lamp;
  lamp.color = Color{0.2f, 0.1f, 0.1f};
  EXPECT_NEAR(luminance(lampColor(lamp, {})), 1, 1e-4);
  EXPECT_NEAR(emitted(Setting(Mesh{}).light(lamp)), 800, 0.1);
}

TEST(LampBuilder, NothingComesFromALampThatIsOffOrWithoutShares) {
  Setting s(Mesh{});
  s.options.lumens = 0;
  EXPECT_TRUE(s.light().bulbs.empty());
  s.options.lumens = 100;
  Lamp lamp;
  lamp.sources.push_back({.share = 0});
  EXPECT_NEAR(emitted(s.light(lamp)), 100, 0.1);
}

}  // namespace
}  // namespace idap
