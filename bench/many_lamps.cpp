// What lamps cost: a hall with 10 and with 1000 lamps of the same light altogether, and the time that each
// takes to the same error. Also the picture of 1993, 320x200, in frames a second, and the denoiser at
// 640x480.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "box_mesh.h"
#include "render/accel/compiled_scene.h"
#include "render/denoise/denoise.h"
#include "render/session/render_job.h"

namespace {

using namespace idap;
using namespace idap::render;
using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// 16 x 12 x 3 m with partition walls and tables; the lamps on a grid under the ceiling.
std::shared_ptr<const Scene> hall(int lamps) {
  auto scene = std::make_shared<Scene>();
  Surface wall, wood;
  wall.baseColor = {0.7f, 0.7f, 0.68f};
  wall.roughness = 0.9f;
  wood.baseColor = {0.4f, 0.27f, 0.16f};
  scene->surfaces = {wall, wood};
  const auto put = [&](Vec3f a, Vec3f b, std::uint32_t surface) {
    scene->meshes.push_back(std::make_shared<Mesh>(box(a, b)));
    Instance instance;
    instance.mesh = static_cast<std::uint32_t>(scene->meshes.size() - 1);
    instance.surfaces = {surface};
    scene->instances.push_back(instance);
  };
  put({0, 0, 0}, {16, 12, 3}, 0);
  for (int i = 1; i < 4; ++i) {
    const float x = 4.0f * static_cast<float>(i);
    put({x, 0, 0}, {x + 0.1f, 9, 2.2f}, 0);
    put({x - 2.5f, 3, 0.7f}, {x - 1, 6, 0.75f}, 1);
  }
  const int columns = static_cast<int>(std::ceil(std::sqrt(lamps * 16.0 / 12)));
  const int rows = (lamps + columns - 1) / columns;
  for (int i = 0; i < lamps; ++i)
    scene->lamps.push_back(
        {.position = {16 * (static_cast<float>(i % columns) + 0.5f) / static_cast<float>(columns),
                      12 * (static_cast<float>(i / columns) + 0.5f) / static_cast<float>(rows), 2.6f},
         .intensity = Rgb{1, 0.9f, 0.7f} * (8000.0f / static_cast<float>(lamps))});
  return scene;
}

Film traced(const CompiledScene& scene, const Camera& camera, RenderSettings settings, double& seconds) {
  Film film(settings.width, settings.height);
  const auto start = Clock::now();
  render::render(scene, camera, settings, film);
  seconds = since(start);
  return film;
}

// Time to an error of one per cent of the mean, from that of a shorter render: errors fall with the root of
// it.
double timeToOnePerCent(int lamps) {
  const CompiledScene scene(hall(lamps));
  Camera camera;
  camera.eye = {0.6f, 11.2f, 1.6f};
  camera.forward = normalized(Vec3f{1, -0.7f, -0.15f});
  camera.up = normalized(cross(cross(camera.forward, Vec3f{0, 0, 1}), camera.forward));
  RenderSettings settings{.width = 160, .height = 120, .spp = 1024, .seed = 1};
  double seconds = 0;
  const Film truth = traced(scene, camera, settings, seconds);
  settings.spp = 64;
  settings.seed = 2;
  const Film film = traced(scene, camera, settings, seconds);
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < truth.pixels(); ++i) {
    mean += static_cast<double>(luminance(truth.meanColor(i)));
    squares += std::pow(static_cast<double>(luminance(film.meanColor(i) - truth.meanColor(i))), 2);
  }
  const double pixels = static_cast<double>(truth.pixels());
  const double error = std::sqrt(squares / pixels) / (mean / pixels);
  const double needed = seconds * std::pow(error / 0.01, 2);
  fmt::print("{:5} lamps: {:.2f} s for 64 paths a pixel, error {:.2f} %; {:.1f} s to 1 %\n", lamps, seconds,
             100 * error, needed);
  return needed;
}

}  // namespace

int main() {
  const double few = timeToOnePerCent(10), many = timeToOnePerCent(1000);
  fmt::print("1000 lamps cost {:.2f} times what 10 lamps cost, for equal error\n", many / few);

  const CompiledScene scene(hall(1));
  Camera camera;
  camera.eye = {0.6f, 11.2f, 1.6f};
  camera.forward = normalized(Vec3f{1, -0.7f, -0.15f});
  camera.up = normalized(cross(cross(camera.forward, Vec3f{0, 0, 1}), camera.forward));
  double seconds = 0;
  RenderSettings classic{.width = 320, .height = 200, .spp = 40, .integrator = IntegratorKind::Classic};
  traced(scene, camera, classic, seconds);
  fmt::print("the classic picture of a hall with one lamp, 320x200: {:.0f} a second\n", 40 / seconds);

  const Film film = traced(scene, camera, {.width = 640, .height = 480, .spp = 2}, seconds);
  for (const bool fast : {false, true}) {
    Denoiser denoiser;
    double best = 1e9;
    for (int round = 0; round < 5; ++round) {
      std::vector<Rgb> color = film.meanColors();
      const auto start = Clock::now();
      denoiser.run(film, color, {.fast = fast});
      best = std::min(best, since(start));
    }
    fmt::print("denoising 640x480, {} network: {:.0f} ms\n", fast ? "small" : "normal", 1000 * best);
  }
  return 0;
}
