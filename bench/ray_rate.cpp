// How much of its time the renderer spends outside Embree: renders a furnished room by path tracing on one
// thread, then has bare Embree trace the very same rays (nearest hits and shadow rays, in the same order),
// and prints both rates and their ratio. Also the same by kind of ray for the renderer's own way of tracing
// (the surface point with its normals and texture coordinates; what glass lets by) without any shading.
// Usage: bench_ray_rate [samples a pixel] [HOME...]; without a home, a made-up room by day and in the
// evening.
#include <embree3/rtcore.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iterator>
#include <vector>

#include "box_mesh.h"
#include "catalog/catalog.h"
#include "formats/registry.h"
#include "render/accel/compiled_scene.h"
#include "render/accel/embree_ray.h"
#include "render/session/fill_cache.h"
#include "render/session/render_job.h"
#include "scene/scene_builder.h"

namespace {

using namespace idap;
using namespace idap::render;
// Processor time, since other work on the machine is not to count.
double since(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

// A surface of revolution around z with a wavy radius, so that its triangles are of many shapes.
Mesh vase(float radius, float height, int rings, int sectors, float waves) {
  Mesh m;
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k <= sectors; ++k) {
      const float t = static_cast<float>(i) / static_cast<float>(rings);
      const float a = 2 * static_cast<float>(kPi) * static_cast<float>(k) / static_cast<float>(sectors);
      const float r = radius * (0.15f + std::sin(static_cast<float>(kPi) * t)) *
                      (1 + 0.08f * std::sin(waves * a + 9 * t));
      m.positions.push_back({r * std::cos(a), r * std::sin(a), t * height});
    }
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < sectors; ++k) {
      const auto a = static_cast<std::uint32_t>(i * (sectors + 1) + k),
                 b = a + static_cast<std::uint32_t>(sectors) + 1;
      m.triangles.push_back({a, a + 1, b});
      m.triangles.push_back({a + 1, b + 1, b});
    }
  computeSmoothNormals(m, 1.0f);
  return m;
}

// A room of 6 x 5 x 2.6 m with a table, six chairs, shelves full of things, a window and nine lamps. By day
// its bulbs are emissive meshes and sun and sky come in; in the evening there are nine spheres of light only.
std::shared_ptr<const Scene> furnishedRoom(bool evening) {
  auto scene = std::make_shared<Scene>();
  const auto surface = [&](Rgb color, float roughness, float metalness = 0, Rgb emission = {}) {
    Surface s;
    s.baseColor = color;
    s.roughness = roughness;
    s.metalness = metalness;
    s.emission = emission;
    scene->surfaces.push_back(s);
    return static_cast<std::uint32_t>(scene->surfaces.size() - 1);
  };
  const std::uint32_t white = surface({0.75f, 0.74f, 0.7f}, 0.9f), oak = surface({0.45f, 0.3f, 0.18f}, 0.4f),
                      blue = surface({0.15f, 0.25f, 0.5f}, 0.6f), clay = surface({0.6f, 0.3f, 0.2f}, 0.3f),
                      steel = surface({0.8f, 0.8f, 0.8f}, 0.3f, 1),
                      glow = surface({0.8f, 0.8f, 0.8f}, 0.9f, 0, {6000, 5000, 3500});
  const auto mesh = [&](Mesh m) {
    scene->meshes.push_back(std::make_shared<Mesh>(std::move(m)));
    return static_cast<std::uint32_t>(scene->meshes.size() - 1);
  };
  const auto put = [&](std::uint32_t m, std::uint32_t s, Transformf t) {
    Instance i;
    i.mesh = m;
    i.surfaces = {s};
    i.transform = t;
    scene->instances.push_back(i);
  };
  const auto block = [&](Vec3f a, Vec3f b, std::uint32_t s) { put(mesh(box(a, b)), s, {}); };
  block({-3, -2.5f, -0.2f}, {3, 2.5f, 0}, oak);
  block({-3, -2.5f, 2.6f}, {3, 2.5f, 2.8f}, white);
  block({-3.2f, -2.5f, 0}, {-3, 2.5f, 2.6f}, white);
  block({-3, -2.7f, 0}, {3, -2.5f, 2.6f}, white);
  block({-3, 2.5f, 0}, {3, 2.7f, 2.6f}, white);
  block({3, -2.5f, 0}, {3.2f, 2.5f, 0.9f}, white);
  block({3, -2.5f, 2.2f}, {3.2f, 2.5f, 2.6f}, white);
  block({3, -2.5f, 0.9f}, {3.2f, -1, 2.2f}, white);
  block({3, 1, 0.9f}, {3.2f, 2.5f, 2.2f}, white);
  block({-0.9f, -0.5f, 0.72f}, {0.9f, 0.5f, 0.75f}, oak);

  const std::uint32_t chair = mesh(vase(0.28f, 0.9f, 120, 100, 6)), jug = mesh(vase(0.09f, 0.3f, 70, 60, 3)),
                      plant = mesh(vase(0.4f, 1.2f, 160, 160, 17)),
                      bulb = mesh(vase(0.06f, 0.12f, 10, 12, 0));
  const auto at = [](float x, float y, float z, float turn) {
    return Transformf::translation({x, y, z}) * Transformf::rotationZ(turn);
  };
  for (int i = 0; i < 6; ++i)
    put(chair, i % 2 ? blue : oak,
        at(static_cast<float>(i % 3) * 0.8f - 0.8f, i < 3 ? -0.9f : 0.9f, 0, static_cast<float>(i)));
  for (int shelf = 0; shelf < 5; ++shelf) {
    const float z = 0.3f + 0.4f * static_cast<float>(shelf);
    block({-2.9f, 2.1f, z - 0.02f}, {1, 2.5f, z}, oak);
    for (int i = 0; i < 14; ++i)
      put(jug, (i + shelf) % 3 == 0 ? steel : clay,
          at(-2.75f + 0.28f * static_cast<float>(i), 2.3f, z, static_cast<float>(i * shelf)));
  }
  put(plant, blue, at(2.3f, 1.8f, 0, 0));
  put(plant, clay, at(-2.4f, -1.9f, 0, 1));
  for (int i = 0; i < 9; ++i) {
    const float x = static_cast<float>(i % 3) * 2 - 2, y = static_cast<float>(i / 3) * 1.6f - 1.6f;
    if (evening)
      scene->lamps.push_back({.position = {x, y, 2.45f}, .radius = 0.06f, .intensity = {60, 50, 35}});
    else
      put(bulb, glow, at(x, y, 2.4f, 0));
  }
  if (evening) return scene;
  scene->sun = {normalized(Vec3f{0.8f, 0.3f, 0.5f}), {60000, 55000, 45000}};
  scene->sky = {16, 8, std::vector<Rgb>(128, Rgb{3000, 3500, 4500})};
  scene->portals.push_back({{3.1f, -1, 0.9f}, {0, 2, 0}, {0, 0, 1.3f}});
  return scene;
}

// Bare Embree over the log; nearest hits and occlusion, nothing done with the results but a checksum.
double replay(RTCScene scene, const std::vector<LoggedRay>& rays, std::uint64_t& hits) {
  const std::clock_t start = std::clock();
  for (const LoggedRay& logged : rays) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        logged.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    RTCRayHit r;
    r.ray = embreeRay(logged.ray, logged.mask);
    if (logged.shadow) {
      rtcOccluded1(scene, &context, &r.ray);
      hits += r.ray.tfar < 0;
    } else {
      r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      r.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene, &context, &r);
      hits += r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
  }
  return since(start);
}

// The same through the renderer's interface, up to the surface point or the light that gets by.
double traceOnly(const CompiledScene& scene, const std::vector<LoggedRay>& rays, double& sum) {
  const std::clock_t start = std::clock();
  for (const LoggedRay& logged : rays) {
    if (logged.shadow) {
      sum += static_cast<double>(scene.transmittance(logged.ray).x);
      continue;
    }
    Hit hit;
    if (!scene.intersect(logged.ray, hit, logged.mask, logged.coherent)) continue;
    sum += hit.isLamp() ? 1.0 : static_cast<double>(scene.interaction(logged.ray, hit).ns.x);
  }
  return since(start);
}

void measureKind(const char* name, CompiledScene& compiled, const std::vector<LoggedRay>& log,
                 const std::function<bool(const LoggedRay&)>& belongs) {
  std::vector<LoggedRay> rays;
  std::copy_if(log.begin(), log.end(), std::back_inserter(rays), belongs);
  double own = 1e9, bare = 1e9, sum = 0;
  std::uint64_t hits = 0;
  for (int round = 0; round < 3; ++round) {
    own = std::min(own, traceOnly(compiled, rays, sum));
    compiled.setFilters(false);
    bare = std::min(bare, replay(compiled.embreeScene(), rays, hits));
    compiled.setFilters(true);
  }
  std::printf("  %-14s%.2f M rays: tracing without shading reaches %.1f %% of bare Embree\n", name,
              static_cast<double>(rays.size()) / 1e6, 100 * bare / own);
}

void measure(const char* name, const std::shared_ptr<const Scene>& scene, const idap::render::Camera& camera,
             int spp) {
  CompiledScene compiled(scene, 0, nullptr, BvhLevels::One);
  const CompileStats& build = compiled.stats();
  std::printf("%s: %.0f k triangles (%.0f k instanced), built in %.3f s, %.1f MB\n", name,
              static_cast<double>(build.uniqueTriangles) / 1e3,
              static_cast<double>(build.instancedTriangles) / 1e3, build.seconds,
              static_cast<double>(build.embreeBytes) / 1e6);

  RenderSettings settings{.width = 200, .height = 150, .spp = spp, .threads = 1};
  settings.guide = fillGuide(compiled, camera, settings);  // as pictures have it; not counted
  std::vector<LoggedRay> log;
  {
    Film film(settings.width, settings.height);
    compiled.setLog(&log);
    idap::render::render(compiled, camera, settings, film);
    compiled.setLog(nullptr);
  }
  std::size_t shadows = 0;
  for (const LoggedRay& ray : log) shadows += ray.shadow;

  // Turn about, the best of three each, so that other work on the machine weighs on neither side.
  double full = 1e9, bare = 1e9;
  std::uint64_t hits = 0;
  for (int round = 0; round < 3; ++round) {
    Film film(settings.width, settings.height);
    const std::clock_t start = std::clock();
    idap::render::render(compiled, camera, settings, film);
    full = std::min(full, since(start));
    compiled.setFilters(false);
    bare = std::min(bare, replay(compiled.embreeScene(), log, hits));
    compiled.setFilters(true);
  }
  const auto count = static_cast<double>(log.size());
  std::printf("  %.2f M rays, %.0f %% of them shadow rays; checksum %llu\n", count / 1e6,
              100 * static_cast<double>(shadows) / count, static_cast<unsigned long long>(hits));
  std::printf("  bare Embree   %.3f s  %.2f M rays/s\n", bare, count / bare / 1e6);
  std::printf("  path tracing  %.3f s  %.2f M rays/s\n", full, count / full / 1e6);
  std::printf("  ratio         %.1f %%\n", 100 * bare / full);
  measureKind("primary", compiled, log, [](const LoggedRay& ray) { return !ray.shadow && ray.coherent; });
  measureKind("bounce", compiled, log, [](const LoggedRay& ray) { return !ray.shadow && !ray.coherent; });
  measureKind("shadow", compiled, log, [](const LoggedRay& ray) { return ray.shadow; });
}

// As it is seen from its first point of view.
void measureHome(const char* file, int spp) {
  const Home home = readHome(file).home;
  const Catalog catalog;
  idap::Camera camera;
  if (!home.cameras.empty()) camera = *home.cameras.begin()->second;
  BuildOptions options;
  options.time = camera.time;
  const BuiltScene built = buildScene(home, catalog, options);
  measure(file, built.scene, toRenderCamera(camera, built, 4.0 / 3), spp);
}

}  // namespace

int main(int argc, char** argv) {
  const int spp = argc > 1 ? std::max(1, std::atoi(argv[1])) : 4;
  idap::render::Camera camera;
  camera.eye = {2.6f, -2.2f, 1.5f};
  camera.forward = normalized(Vec3f{-1, 0.85f, -0.15f});
  camera.up = normalized(cross(cross(camera.forward, Vec3f{0, 0, 1}), camera.forward));
  if (argc > 2) {
    for (int i = 2; i < argc; ++i) measureHome(argv[i], spp);
    return 0;
  }
  measure("furnished room by day", furnishedRoom(false), camera, spp);
  measure("furnished room in the evening", furnishedRoom(true), camera, spp);
  return 0;
}
