// Our side of a comparison with another renderer. Four jobs:
//   peer scene HOME FOLDER [--camera N] [--matte] [--night] [--size WxH]
//       writes scene.glb, sky.exr and scene.json (lamps, sun, camera): what bench/peers/cycles.py reads
//   peer render HOME OUT.exr [the same] [--spp N | --time S] [--threads N] [--denoise] [--clamp] [--cache
//   PATHS] [--no-looks] [--no-guide] [--no-portals]
//       renders the same scene and prints its figures as JSON
//   peer compare A.exr REFERENCE.exr [--block 16] [--without-lamps]
//       prints how far A is from the reference, by pixel and by block
//   peer develop A.exr OUT.png [--like B.exr]
//       the picture for a screen, exposed as B would be
// --night: lamps only. --matte: every surface a Lambertian one, panes of glass without reflections, so that
// two renderers whose materials differ have to agree on the light.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "catalog/catalog.h"
#include "formats/gltf/gltf_writer.h"
#include "formats/registry.h"
#include "render/accel/compiled_scene.h"
#include "render/denoise/denoise.h"
#include "render/film/develop.h"
#include "render/film/exposure.h"
#include "render/film/noise_estimate.h"
#include "render/film/picture_file.h"
#include "render/session/fill_cache.h"
#include "render/session/pilot.h"
#include "render/session/render_job.h"
#include "scene/scene_builder.h"

namespace {

using namespace idap;
using nlohmann::json;

struct Arguments {
  std::vector<std::string> files;
  std::map<std::string, std::string> options;

  bool has(const std::string& name) const { return options.contains(name); }
  std::string text(const std::string& name, const std::string& otherwise) const {
    const auto it = options.find(name);
    return it == options.end() ? otherwise : it->second;
  }
  double number(const std::string& name, double otherwise) const {
    return has(name) ? std::stod(options.at(name)) : otherwise;
  }
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--")) {
      static const std::set<std::string> kFlags{"--matte",    "--denoise",    "--clamp",
                                                "--no-looks", "--no-guide",   "--no-portals",
                                                "--night",    "--two-levels", "--without-lamps"};
      const bool flag = kFlags.contains(word);
      a.options[word.substr(2)] = flag || i + 1 >= argc ? "" : argv[++i];
    } else {
      a.files.push_back(word);
    }
  }
  return a;
}

struct Prepared {
  BuiltScene built;
  render::Camera camera;
  int width = 640, height = 480;
};

void makeMatte(render::Scene& scene) {
  for (render::Surface& s : scene.surfaces) {
    s.metalness = 0;
    s.roughness = 1;
    s.ior = 1;
    s.normalMap = s.roughnessMap = nullptr;
    s.thin = true;
  }
}

Prepared prepare(const Arguments& a) {
  Prepared p;
  const std::string size = a.text("size", "640x480");
  p.width = std::stoi(size), p.height = std::stoi(size.substr(size.find('x') + 1));
  const double aspect = static_cast<double>(p.width) / p.height;
  const Home home = readHome(a.files.at(0)).home;
  const Catalog catalog;
  BuildOptions options;
  Camera camera;
  const auto number = static_cast<std::size_t>(a.number("camera", 1));
  if (number >= 1 && number <= home.cameras.size()) {
    camera = *std::next(home.cameras.begin(), static_cast<std::ptrdiff_t>(number - 1))->second;
  } else if (home.observer) {
    camera = *home.observer;
  }
  options.lamps = a.text("lamps", "on") == "off" ? LampPolicy::Off : LampPolicy::On;
  options.time = camera.time;
  p.built = buildScene(home, catalog, options);
  if (a.has("night")) p.built.scene->sun = {}, p.built.scene->sky = {}, p.built.scene->portals.clear();
  if (a.has("no-portals")) p.built.scene->portals.clear();
  if (a.has("matte")) makeMatte(*p.built.scene);
  p.camera = toRenderCamera(camera, p.built, aspect);
  p.camera.projection = render::Projection::Perspective;
  return p;
}

json list(Vec3f v) { return {v.x, v.y, v.z}; }

// Other programs begin the picture of the sky at -x and go clockwise.
render::Film skyFilm(const render::Sky& sky) {
  render::Film film(sky.width, sky.height);
  for (int y = 0; y < sky.height; ++y)
    for (int x = 0; x < sky.width; ++x) {
      const int from = (sky.width / 2 - 1 - x + sky.width) % sky.width;
      film.color[film.index(x, y)] = sky.radiance[static_cast<std::size_t>(y * sky.width + from)];
      film.weight[film.index(x, y)] = 1;
    }
  return film;
}

int writeScene(const Arguments& a) {
  const Prepared p = prepare(a);
  const render::Scene& scene = *p.built.scene;
  const std::filesystem::path folder = a.files.at(1);
  std::filesystem::create_directories(folder);
  const double aspect = static_cast<double>(p.width) / p.height;
  const GltfCamera camera{"view", p.camera, aspect};
  writeFileAtomically(folder / "scene.glb", writeGlb(scene, std::span(&camera, 1)));
  json j{{"width", p.width},
         {"height", p.height},
         {"matte", a.has("matte")},
         {"eye", list(p.camera.eye)},
         {"forward", list(p.camera.forward)},
         {"up", list(p.camera.up)},
         {"horizontalFov", p.camera.horizontalFov},
         {"sun",
          {{"direction", list(scene.sun.direction)},
           {"illuminance", list(scene.sun.illuminance)},
           {"angularRadius", scene.sun.angularRadius}}}};
  j["lamps"] = json::array();
  for (const render::Lamp& lamp : scene.lamps)
    j["lamps"].push_back({{"position", list(lamp.position)},
                          {"radius", lamp.radius},
                          {"intensity", list(lamp.intensity)},
                          {"axis", list(lamp.axis)},
                          {"beamAngle", lamp.beamAngle}});
  j["portals"] = json::array();
  for (const render::Portal& portal : scene.portals)
    j["portals"].push_back(
        {{"corner", list(portal.corner)}, {"edgeU", list(portal.edgeU)}, {"edgeV", list(portal.edgeV)}});
  if (!scene.sky.radiance.empty()) {
    render::saveLayers(folder / "sky.exr", skyFilm(scene.sky));
    j["sky"] = "sky.exr";
  }
  std::ofstream(folder / "scene.json") << j.dump(1) << '\n';
  return 0;
}

int renderScene(const Arguments& a) {
  const Prepared p = prepare(a);
  using Clock = std::chrono::steady_clock;
  const auto seconds = [](Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  };
  auto start = Clock::now();
  const render::CompiledScene scene(p.built.scene, 0, nullptr,
                                    a.has("two-levels") ? render::BvhLevels::Two : render::BvhLevels::One);
  const double compiled = seconds(start);
  render::RenderSettings settings;
  settings.width = p.width, settings.height = p.height;
  settings.spp = static_cast<int>(a.number("spp", 0));
  settings.timeLimitSeconds = a.number("time", 0);
  settings.noise = static_cast<float>(a.number("noise", 0));
  settings.threads = static_cast<int>(a.number("threads", 0));
  settings.looks = !a.has("no-looks");
  if (a.has("matte")) settings.filter = render::PixelFilter::Box;
  settings.seed = static_cast<std::uint64_t>(a.number("seed", 0));
  if (a.has("clamp"))
    settings.clampIndirect = render::clampFor(render::pilotExposure(scene, p.camera, settings));
  render::Film film(p.width, p.height);
  start = Clock::now();
  if (a.has("cache"))
    settings.cache = render::fillCache(scene, p.camera, settings, static_cast<int>(a.number("cache", 0)));
  else if (!a.has("no-guide"))
    settings.guide = render::fillGuide(scene, p.camera, settings);
  const double learned = seconds(start);
  if (settings.timeLimitSeconds > 0)
    settings.timeLimitSeconds = std::max(0.01, settings.timeLimitSeconds - learned);
  start = Clock::now();
  const render::RenderStats stats = render::render(scene, p.camera, settings, film);
  const double rendered = seconds(start);
  double denoised = 0;
  if (a.has("denoise")) {
    start = Clock::now();
    std::vector<Rgb> clean = film.meanColors();
    render::denoise(film, clean);
    denoised = seconds(start);
    for (std::size_t i = 0; i < clean.size(); ++i) film.color[i] = clean[i] * film.weight[i];
  }
  render::saveLayers(a.files.at(1), film);
  const json j{{"compile_s", compiled},
               {"learn_s", learned},
               {"render_s", rendered},
               {"denoise_s", denoised},
               {"spp", static_cast<double>(stats.paths) / static_cast<double>(film.pixels())},
               {"noise", render::noiseLevel(film)},
               {"paths_per_s", static_cast<double>(stats.paths) / rendered},
               {"rays_per_s", static_cast<double>(stats.rays) / rendered}};
  fmt::print("{}\n", j.dump());
  return 0;
}

int compare(const Arguments& a) {
  const render::Film film = render::loadLayers(a.files.at(0)).film,
                     reference = render::loadLayers(a.files.at(1)).film;
  if (film.width != reference.width || film.height != reference.height)
    throw Error("the pictures differ in size");
  const std::vector<Rgb> x = film.meanColors(), y = reference.meanColors();
  double mean = 0;
  for (const Rgb c : y) mean += static_cast<double>(luminance(c));
  mean /= static_cast<double>(y.size());

  // By pixel: the mean difference over the brightness, a hundredth of the mean added so that black pixels do
  // not decide, without the worst thousandth. And as people see it: the root mean square of what a screen
  // shows, in steps of 255.
  std::vector<double> errors(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double difference = static_cast<double>(luminance(x[i]) - luminance(y[i]));
    errors[i] = std::fabs(difference) / (static_cast<double>(luminance(y[i])) + 0.01 * mean);
  }
  std::ranges::sort(errors);
  errors.resize(errors.size() - errors.size() / 1000);
  double sum = 0;
  for (const double e : errors) sum += e;
  render::DevelopSettings settings;
  settings.denoise = false;
  settings.ev = render::autoExposure(reference);
  settings.illuminant = render::estimateIlluminant(reference);
  const Image8 shown = render::develop(film, settings), wanted = render::develop(reference, settings);
  double squares = 0;
  for (std::size_t i = 0; i < shown.rgb.size(); ++i) {
    const double d = static_cast<double>(shown.rgb[i]) - static_cast<double>(wanted.rgb[i]);
    squares += d * d;
  }

  constexpr double kLamp = 12;
  const bool lamps = a.has("without-lamps");
  int left = 0;
  const int block = static_cast<int>(a.number("block", 16));
  std::vector<double> blocks;
  double worst = 0;
  json where;
  for (int by = 0; by + block <= film.height; by += block)
    for (int bx = 0; bx + block <= film.width; bx += block) {
      double p = 0, q = 0, brightest = 0;
      for (int v = by; v < by + block; ++v)
        for (int u = bx; u < bx + block; ++u) {
          p += static_cast<double>(luminance(x[film.index(u, v)]));
          q += static_cast<double>(luminance(y[film.index(u, v)]));
          brightest = std::max(brightest, static_cast<double>(luminance(film.meanColor(film.index(u, v)))));
        }
      // Bulbs seen directly, which Cycles does not show.
      if (lamps && brightest > kLamp * mean) {
        ++left;
        continue;
      }
      const double relative = std::fabs(p - q) / std::max(q, 1e-9);
      if (relative > worst) worst = relative, where = {bx, by, p / q};
      blocks.push_back(relative);
    }
  std::ranges::sort(blocks);
  const auto quantile = [&](double f) {
    return blocks[static_cast<std::size_t>(f * static_cast<double>(blocks.size() - 1))];
  };
  double ours = 0;
  for (const Rgb c : x) ours += static_cast<double>(luminance(c));
  const auto within = static_cast<double>(std::ranges::upper_bound(blocks, 0.03) - blocks.begin());
  const json j{{"relative_error", sum / static_cast<double>(errors.size())},
               {"display_rmse", std::sqrt(squares / static_cast<double>(shown.rgb.size()))},
               {"mean_ratio", ours / static_cast<double>(x.size()) / mean},
               {"blocks",
                {{"median", quantile(0.5)},
                 {"p95", quantile(0.95)},
                 {"p99", quantile(0.99)},
                 {"largest", worst},
                 {"where", where},
                 {"left_out", left},
                 {"within_3_percent", within / static_cast<double>(blocks.size())}}}};
  fmt::print("{}\n", j.dump());
  return 0;
}

int developPicture(const Arguments& a) {
  const render::Film film = render::loadLayers(a.files.at(0)).film;
  const render::Film like = a.has("like") ? render::loadLayers(a.text("like", "")).film : film;
  render::DevelopSettings settings;
  settings.denoise = false;
  settings.ev = render::autoExposure(like);
  settings.illuminant = render::estimateIlluminant(like);
  render::savePicture(a.files.at(1), render::develop(film, settings));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string job = argc > 1 ? argv[1] : "";
    const Arguments a = parse(argc, argv);
    if (job == "scene" && a.files.size() == 2) return writeScene(a);
    if (job == "render" && a.files.size() == 2) return renderScene(a);
    if (job == "compare" && a.files.size() == 2) return compare(a);
    if (job == "develop" && a.files.size() == 2) return developPicture(a);
    fmt::print(stderr,
               "usage: peer scene HOME FOLDER | render HOME OUT.exr | compare A.exr REFERENCE.exr | "
               "develop A.exr OUT.png\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "peer: {}\n", error.what());
  }
  return 1;
}
