#include "render/accel/compiled_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "render/sampling/frame.h"
#include "render/sampling/warp.h"
#include "render/scene_parts.h"
#include "render/session/illuminance.h"

namespace idap::render {
namespace {

using namespace test;

TEST(CompiledScene, FindsWhatARayHits) {
  SceneMaker make;
  make.add(boxMesh({-1, -1, -1}, {1, 1, 1}), lambert(grey(0.5f)), Transformf::translation({10, 0, 0}));
  const auto scene = make.compile();
  Hit hit;
  const Ray ray{{0, 0.25f, 0.5f}, {1, 0, 0}};
  ASSERT_TRUE(scene->intersect(ray, hit, kBounceRay));
  EXPECT_NEAR(hit.t, 9.0f, 1e-5f);
  const Interaction at = scene->interaction(ray, hit);
  EXPECT_NEAR(at.position.x, 9.0f, 1e-5f);
  EXPECT_NEAR(at.ng.x, -1.0f, 1e-6f);
  EXPECT_TRUE(at.frontFace);
  EXPECT_EQ(at.objectId, 1u);
  EXPECT_TRUE(scene->occluded(ray));
  EXPECT_FALSE(scene->occluded({ray.origin, ray.direction, 0, 8.9f}));
  EXPECT_FALSE(scene->intersect({ray.origin, {-1, 0, 0}}, hit, kBounceRay));
  EXPECT_EQ(scene->stats().uniqueTriangles, 12u);
  EXPECT_GT(scene->stats().embreeBytes, 0u);
}

TEST(CompiledScene, FrontsStayFrontsUnderMirrorsAndUnevenScale) {
  Transformf mirror = Transformf::translation({0, 5, 0}) * Transformf::scaling({-2, 1, 0.5f});
  SceneMaker make;
  make.add(sphereMesh({0, 0, 0}, 1), lambert(grey(0.5f)), mirror);
  const auto scene = make.compile();
  for (int i = 0; i < 200; ++i) {
    const Vec3f d = uniformCone(hammersley(i, 200), 2.0f);
    // From well outside towards the middle.
    const Ray ray{Vec3f{0, 5, 0} - d * 4.0f, d};
    Hit hit;
    ASSERT_TRUE(scene->intersect(ray, hit, kBounceRay));
    const Interaction at = scene->interaction(ray, hit);
    EXPECT_TRUE(at.frontFace);
    const Vec3f p = at.position - Vec3f{0, 5, 0};
    const Vec3f truth = normalized(Vec3f{p.x / 4, p.y, p.z * 4});  // gradient of the ellipsoid
    EXPECT_GT(dot(at.ns, truth), 0.99f);
    EXPECT_GT(dot(at.ns, -d), 0.0f);
  }
}

TEST(CompiledScene, AnEditSharesTheMeshesAndMovesShadowsAndLights) {
  const auto scene = [](float shade, float panel) {
    SceneMaker make;
    make.add(parallelogram({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}), lambert({}),
             Transformf::translation({shade, 0, 0}));
    make.add(parallelogram({-0.5f, -0.5f, 3}, {0, 1, 0}, {1, 0, 0}), lambert({}, grey(100)),
             Transformf::translation({0, 0, panel}));
    return make.shared();
  };
  const CompiledScene before(scene(0, 0));
  EXPECT_TRUE(before.occluded({{0, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(luminance(illuminance(before, {}, {0, 0, 1}, {.samples = 64})), 0.0f);
  for (const BvhLevels levels : {BvhLevels::One, BvhLevels::Two}) {
    const CompiledScene open(scene(20, 0), 0, &before, levels);
    const float lit = luminance(illuminance(open, {}, {0, 0, 1}, {.samples = 1024}));
    EXPECT_GT(lit, 5.0f);
    const CompiledScene far(scene(20, 3), 0, &open, levels);
    EXPECT_LT(luminance(illuminance(far, {}, {0, 0, 1}, {.samples = 1024})), 0.4f * lit);
  }
}

// Rays side by side find what each finds by itself.
void expectLanesAsOneByOne(const CompiledScene& scene, const LaneRays& rays) {
  LaneHits hits;
  scene.intersect(LaneMask(true), rays, hits, Words(kBounceRay));
  const LaneMask solid = hits.found && !hits.lamp;
  LanePoints points;
  if (any(solid)) scene.points(solid, rays, hits, points);
  const LaneVec through = scene.transmittance(LaneMask(true), rays);
  for (int k = 0; k < kLanes; ++k) {
    const Ray ray{lane(rays.origin, k), lane(rays.direction, k)};
    Hit hit;
    ASSERT_EQ(scene.intersect(ray, hit, kBounceRay), lane(hits.found, k));
    EXPECT_NEAR(luminance(scene.transmittance(ray)), luminance(lane(through, k)), 1e-3f);
    if (!lane(hits.found, k)) continue;
    EXPECT_NEAR(hit.t, lane(hits.t, k), 1e-4f);
    ASSERT_EQ(hit.isLamp(), lane(hits.lamp, k));
    if (hit.isLamp()) continue;
    const Interaction at = scene.interaction(ray, hit);
    EXPECT_LT(length(at.position - lane(points.position, k)), 1e-4f);
    EXPECT_EQ(at.frontFace, lane(points.shading.frontFace, k));
    EXPECT_EQ(at.surface, points.surface[k]);
    // Points that lie along their ray are off by its length as well.
    EXPECT_GT(lane(points.offset, k), 0.999f * at.offset);
    EXPECT_LT(lane(points.offset, k), at.offset + 1e-5f * hit.t);
    if (hit.triangle != hits.hit(k).triangle) continue;  // on an edge
    EXPECT_GT(dot(at.ng, lane(points.shading.ng, k)), 0.9999f);
    EXPECT_GT(dot(at.ns, lane(points.shading.ns, k)), 0.999f);
  }
}

TEST(CompiledScene, OneLevelAndTwoFindTheSame) {
  SceneMaker make;
  Surface glass;
  glass.transmission = 1;
  glass.roughness = 0;
  const std::uint32_t clear = make.surface(glass), solid = make.surface(lambert(grey(0.5f)));
  Transformf turned = Transformf::translation({0.3f, 0.2f, 1}) * Transformf::rotationZ(0.7f);
  turned = turned * Transformf::scaling({1.5f, -0.7f, 1});
  make.add(sphereMesh({}, 0.8f, 12), lambert(grey(0.5f)), turned);
  make.add(boxMesh({-0.5f, -0.5f, 2.2f}, {0.5f, 0.5f, 3}),
           std::vector<std::uint32_t>{clear, clear, clear, solid, solid, clear});
  make.scene().lamps.push_back({.position = {0, 0, -2}, .radius = 0.3f, .intensity = grey(10)});
  const auto scene = make.shared();
  CompiledScene one(scene, 0, nullptr, BvhLevels::One), two(scene);
  for (CompiledScene* s : {&one, &two}) {
    s->setVisibleToCamera(1, false);
    s->commit();
  }
  int hits = 0, lamps = 0, lane = 0;
  LaneArray3 origins, directions;
  for (int i = 0; i < 3000; ++i) {
    const Vec2f u = hammersley(i, 3000);
    const Vec3f d = Frame({0, 0, i % 2 ? 1.0f : -1.0f}).toWorld(uniformCone(u, 0.05f));
    const Ray ray{{0.1f * u.x, 0.1f, i % 2 ? -3.5f : 4.5f}, d};
    for (const std::uint32_t mask : {kCameraRay, kBounceRay}) {
      Hit a, b;
      ASSERT_EQ(one.intersect(ray, a, mask), two.intersect(ray, b, mask)) << i;
      if (a.t == 0) continue;
      ASSERT_EQ(a.isLamp(), b.isLamp());
      EXPECT_NEAR(a.t, b.t, 1e-4f);
      if (a.isLamp()) {
        ++lamps;
        continue;
      }
      ++hits;
      EXPECT_EQ(a.instance, b.instance);
      const Interaction p = one.interaction(ray, a), q = two.interaction(ray, b);
      EXPECT_GT(dot(p.ng, q.ng), a.triangle == b.triangle ? 0.9999f : 0.5f);
      EXPECT_EQ(p.frontFace, q.frontFace);
    }
    EXPECT_NEAR(luminance(one.transmittance(ray)), luminance(two.transmittance(ray)), 1e-3f) << i;
    origins.set(lane, ray.origin), directions.set(lane, ray.direction);
    if (++lane < kLanes) continue;
    lane = 0;
    for (const CompiledScene* s : {&one, &two}) expectLanesAsOneByOne(*s, {origins, directions});
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(lamps, 10);
}

TEST(CompiledScene, LightPassesGlassCutOutsAndPartialOpacity) {
  SceneMaker make;
  Surface half = lambert(grey(0.5f));
  half.opacity = 0.25f;
  make.add(parallelogram({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}), half);
  auto picture = std::make_shared<Texture>();
  picture->width = 2;
  picture->height = 1;
  picture->rgba = {255, 255, 255, 255, 255, 255, 255, 0};
  picture->hasAlpha = true;
  Surface leaf = lambert(grey(0.5f));
  leaf.baseColorMap = picture;
  make.add(parallelogram({4, -1, 1}, {2, 0, 0}, {0, 2, 0}), leaf);
  Surface solid;
  solid.transmission = 1;
  solid.thin = false;
  make.add(boxMesh({8, -1, 1}, {10, 1, 2}), solid);
  const auto scene = make.compile();
  const auto through = [&](float x, float y) { return scene->transmittance({{x, y, 0}, {0, 0, 1}}).x; };
  EXPECT_NEAR(through(0.3f, 0.2f), 0.75f, 1e-5f);
  EXPECT_NEAR(through(4.5f, 0.1f), 0.0f, 1e-5f) << "the opaque half of the leaf";
  EXPECT_NEAR(through(5.5f, 0.1f), 1.0f, 1e-5f) << "its cut-out half";
  EXPECT_EQ(through(9, 0.3f), 0.0f) << "solid glass bends light: nothing goes straight through";
  EXPECT_EQ(through(12, 0), 1.0f);
  EXPECT_FALSE(scene->occluded({{0.3f, 0.2f, 0}, {0, 0, 1}}));
}

TEST(CompiledScene, OneMeshMayBeGlassHereAndWoodThere) {
  SceneMaker make;
  Surface glass;
  glass.transmission = 1;
  glass.roughness = 0;
  const std::uint32_t clear = make.surface(glass), wood = make.surface(lambert(grey(0.5f)));
  Mesh m = parallelogram({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
  m.slots = {0, 1};
  make.add(m, std::vector<std::uint32_t>{clear, wood});
  Instance second = make.scene().instances[0];
  second.surfaces = {wood, clear};
  second.transform = Transformf::translation({5, 0, 0});
  make.scene().instances.push_back(second);
  const auto scene = make.compile();
  const auto through = [&](float x, float y) {
    return scene->transmittance({{x, y, 0}, {0, 0, 1}}).x > 0.5f;
  };
  EXPECT_TRUE(through(0.5f, -0.5f));
  EXPECT_FALSE(through(-0.5f, 0.5f));
  EXPECT_FALSE(through(5.5f, -0.5f));
  EXPECT_TRUE(through(4.5f, 0.5f));
}

TEST(CompiledScene, NewRaysNeitherHitTheirOwnSurfaceNorLeakOut) {
  for (const float distance : {0.0f, 20.0f, 100.0f}) {
    SceneMaker make;
    const Transformf t = Transformf::translation({distance, -distance, 0}) * Transformf::rotationZ(0.7f);
    make.add(boxMesh({-2, -2, 0}, {2, 2, 3}, true), lambert(grey(0.5f)), t);
    const auto scene = make.compile();
    for (int i = 0; i < 2000; ++i) {
      const Vec2f u = hammersley(i, 2000);
      const Vec3f middle = t.point({0, 0, 1.5f});
      const Ray ray{middle, uniformCone(u, 2.0f)};
      Hit hit;
      ASSERT_TRUE(scene->intersect(ray, hit, kBounceRay));
      const Interaction at = scene->interaction(ray, hit);
      const Vec3f d = Frame(at.ng).toWorld(cosineHemisphere(Vec2f{u.y, u.x}));
      Hit next;
      ASSERT_TRUE(scene->intersect({at.originTowards(d), d}, next, kBounceRay)) << "leaked at " << distance;
      // Back to the middle, which all of the room sees.
      EXPECT_FALSE(scene->occluded({at.originTowards(-ray.direction), -ray.direction, 0, hit.t * 0.999f}))
          << "shadowed itself at " << distance;
    }
  }
}

// Of lanes, whose points lie along their rays rather than between corners: on slivers and large triangles,
// far away, at grazing angles, in mirrors.
TEST(CompiledScene, NewRaysOfLanesNeitherHitTheirOwnSurfaceNorLeakOut) {
  Mesh fan;
  constexpr int kBlades = 500;
  for (int i = 0; i <= kBlades; ++i) {
    const float a = 2 * kPiF * static_cast<float>(i) / kBlades;
    fan.positions.push_back({20 * std::cos(a), 20 * std::sin(a), 0});
  }
  fan.positions.push_back({3, 4, 0});
  for (std::uint32_t i = 0; i < kBlades; ++i) fan.triangles.push_back({i, i + 1, kBlades + 1});
  for (const float distance : {0.0f, 20.0f, 100.0f})
    for (const float mirror : {1.0f, -1.0f}) {
      SceneMaker make;
      const Transformf t = Transformf::translation({distance, -distance, 3}) * Transformf::rotationZ(0.7f) *
                           Transformf::rotationX(0.4f) * Transformf::scaling({mirror, 1, 1});
      make.add(fan, lambert(grey(0.5f)), t);
      for (const BvhLevels levels : {BvhLevels::One, BvhLevels::Two}) {
        const CompiledScene scene(make.shared(), 0, nullptr, levels);
        const Vec3f up = normalized(t.cofactor().vector({0, 0, 1}));
        const Frame around(up);
        LaneArray3 from, to;
        int hitsFound = 0, own = 0, leaked = 0;
        constexpr int kRays = 20'000;
        for (int i = 0; i < kRays; i += kLanes) {
          for (int k = 0; k < kLanes; ++k) {
            const Vec2f u = hammersley(i + k, kRays);
            const Vec3f target = t.point({20 * u.x - 10, 20 * u.y - 10, 0});
            const float height = std::pow(10.0f, static_cast<float>(k % 4) - 2);  // 1 cm to 10 m
            const Vec3f eye = target + up * height + around.x * (30 * u.y);
            from.set(k, eye);
            to.set(k, normalized(target - eye));
          }
          const LaneRays rays{from, to};
          LaneHits hits;
          scene.intersect(LaneMask(true), rays, hits, Words(kBounceRay));
          LanePoints points;
          scene.points(hits.found, rays, hits, points);
          forLanes(hits.found, [&](int k) {
            ++hitsFound;
            const Vec3f n = lane(points.shading.ng, k), eye = lane(from, k);
            const Vec2f turn = hammersley(i * 7 % kRays + k, kRays);
            const Vec3f flat = around.x * std::cos(6 * turn.x) + around.y * std::sin(6 * turn.x);
            const Vec3f away = normalized(flat + n * (0.001f + turn.y));
            const Vec3f above = lane(points.originTowards(toLanes(away)), k),
                        below = lane(points.originTowards(toLanes(-n)), k);
            Hit hit;
            own += scene.intersect({above, away}, hit, kBounceRay);
            own += scene.occluded({above, normalized(eye - above), 0, length(eye - above) * 0.999f});
            // What has gone through is on the other side.
            leaked += !scene.intersect({below + n * (-0.01f), n}, hit, kBounceRay);
            own += scene.intersect({below, -n}, hit, kBounceRay);
          });
        }
        EXPECT_GT(hitsFound, kRays * 9 / 10);
        EXPECT_EQ(own, 0) << "at " << distance;
        EXPECT_LE(leaked, 1) << "at " << distance;
      }
    }
}

TEST(CompiledScene, HardlyARaySlipsBetweenTriangles) {
  SceneMaker make;
  make.add(sphereMesh({15, 9, 1.3f}, 3, 100), lambert(grey(0.5f)));
  for (const BvhLevels levels : {BvhLevels::One, BvhLevels::Two}) {
    const CompiledScene scene(make.shared(), 0, nullptr, levels);
    int lost = 0;
    constexpr int kRays = 400'000;
    for (int i = 0; i < kRays; ++i) {
      const Vec2f u = hammersley(i, kRays);
      Hit hit;
      lost += !scene.intersect({{14.2f + u.y, 8.6f, 1 + u.x}, uniformCone(u, 2.0f)}, hit, kBounceRay);
    }
    EXPECT_LE(lost, 3);
  }
}

TEST(CompiledScene, ALookGoesThroughPanesToWhatIsBehind) {
  Surface pane;
  pane.baseColor = grey(1);
  pane.transmission = 1;
  pane.roughness = 0.02f;
  Surface frosted = pane;
  frosted.roughness = 0.5f;
  SceneMaker make;
  const auto sheet = [&](float x, const Surface& s) {
    make.add(parallelogram({x, -1, -1}, {0, 2, 0}, {0, 0, 2}), s);
  };
  sheet(1, pane);
  sheet(2, pane);
  sheet(3, lambert(grey(0.5f)));
  sheet(4, pane);
  const auto scene = make.compile();
  LaneRays rays{toLanes({0, 0, 0}), toLanes({1, 0, 0})};
  LaneHits hits;
  LaneVec through;
  scene->look(LaneMask(true), rays, hits, through);
  ASSERT_TRUE(lane(hits.found, 0));
  EXPECT_EQ(hits.instance[0], 2u);
  EXPECT_NEAR(lane(hits.t, 0), 3, 1e-5f);
  // A sheet of glass reflects 2R/(1+R) of what meets it head on, R being 0.04 at an index of 1.5.
  const float one = 1 - 0.08f / 1.04f;
  EXPECT_NEAR(lane(through.x, 0), one * one, 1e-4f);

  // The pane behind is not counted from the other side either; frosted glass is looked at, not through.
  rays.origin = toLanes({3.5f, 0, 0});
  scene->look(LaneMask(true), rays, hits, through);
  EXPECT_FALSE(any(hits.found));
  EXPECT_NEAR(lane(through.x, 0), one, 1e-4f);
  sheet(0.5f, frosted);
  const auto other = make.compile();
  rays.origin = toLanes({0, 0, 0});
  other->look(LaneMask(true), rays, hits, through);
  EXPECT_NEAR(lane(hits.t, 0), 0.5f, 1e-5f);
  EXPECT_NEAR(lane(through.x, 0), 1, 1e-6f);
}

TEST(CompiledScene, ALookEndsSomewhereAmongVeryManyPanes) {
  Surface pane;
  pane.baseColor = grey(1);
  pane.transmission = 1;
  pane.roughness = 0.02f;
  SceneMaker make;
  for (int i = 1; i <= 40; ++i)
    make.add(parallelogram({static_cast<float>(i), -1, -1}, {0, 2, 0}, {0, 0, 2}), pane);
  const auto scene = make.compile();
  LaneHits hits;
  LaneVec through;
  scene->look(LaneMask(true), {toLanes({0, 0, 0}), toLanes({1, 0, 0})}, hits, through);
  ASSERT_TRUE(lane(hits.found, 0));
  const float before = std::round(lane(hits.t, 0)) - 1;  // panes
  EXPECT_LE(before, 8);
  EXPECT_NEAR(lane(through.x, 0), std::pow(1 - 0.08f / 1.04f, before), 1e-3f);
}

TEST(CompiledScene, BrokenTrianglesAreHarmless) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  SceneMaker make;
  Mesh m = parallelogram({-1, -1, 1}, {2, 0, 0}, {0, 2, 0});
  m.positions.push_back({nan, 0, 1});
  m.positions.push_back({inf, 0, 1});
  m.positions.push_back({0, 0, 1});
  m.uvs.resize(m.positions.size());
  m.triangles.push_back({0, 1, 4});
  m.triangles.push_back({0, 5, 2});
  m.triangles.push_back({6, 6, 6});
  make.add(m, lambert(grey(0.5f), grey(10)));
  make.add(parallelogram({}, {1, 0, 0}, {0, 1, 0}), lambert(grey(0.5f)), Transformf::scaling({1, 1, 0}));
  make.add(parallelogram({}, {1, 0, 0}, {0, 1, 0}), lambert(grey(0.5f)),
           Transformf::translation({nan, 0, 0}));
  make.add(Mesh{}, lambert(grey(0.5f)));
  const auto scene = make.compile();
  Hit hit;
  EXPECT_TRUE(scene->intersect({{0.3f, 0.3f, 0.5f}, {0, 0, 1}}, hit, kBounceRay));
  EXPECT_NEAR(hit.t, 0.5f, 1e-6f);
  const float e = luminance(illuminance(*scene, {0, 0, 0.5f}, {0, 0, 1}, {.samples = 512}));
  EXPECT_TRUE(std::isfinite(e) && e > 1);
}

TEST(CompiledScene, RefusesWhatPointsNowhere) {
  SceneMaker none;
  none.scene().instances.emplace_back().mesh = 3;
  EXPECT_THROW(none.compile(), RenderError);
  SceneMaker vertex;
  Mesh m = parallelogram({}, {1, 0, 0}, {0, 1, 0});
  m.triangles.push_back({0, 1, 9});
  vertex.add(m, lambert(grey(0.5f)));
  EXPECT_THROW(vertex.compile(), RenderError);
  SceneMaker surface;
  surface.add(parallelogram({}, {1, 0, 0}, {0, 1, 0}), std::uint32_t{7});
  EXPECT_THROW(surface.compile(), RenderError);
}

TEST(CompiledScene, CoarseSmoothSpheresHaveNoBlackFaces) {
  SceneMaker make;
  make.add(sphereMesh({0, 0, 0}, 1, 6), lambert(grey(0.5f)));
  Surface mirror;
  mirror.metalness = 1;
  mirror.roughness = 0;
  make.add(sphereMesh({5, 0, 0}, 1, 6), mirror);
  const auto scene = make.compile();
  for (int i = 0; i < 2000; ++i) {
    const Vec2f u = hammersley(i, 2000);
    const Ray ray{{i % 2 ? 5.0f : 0.0f, -5, 0},
                  normalized(Vec3f{0.38f * (u.x - 0.5f), 1, 0.38f * (u.y - 0.5f)})};
    Hit hit;
    if (!scene->intersect(ray, hit, kBounceRay)) continue;
    const Interaction at = scene->interaction(ray, hit);
    EXPECT_GE(dot(at.ns, -ray.direction), 0.0f);
    const Vec3f mirrored = ray.direction - at.ns * (2 * dot(at.ns, ray.direction));
    EXPECT_GT(dot(mirrored, at.ng), 0.0f);
  }
}

}  // namespace
}  // namespace idap::render
