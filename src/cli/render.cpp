#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/file.h"
#include "base/platform.h"
#include "catalog/catalog.h"
#include "cli/arguments.h"
#include "cli/command.h"
#include "cli/look.h"
#include "cli/open_home.h"
#include "cli/picture_output.h"
#include "cli/progress_bar.h"
#include "cli/usage_error.h"
#include "render/accel/compiled_scene.h"
#include "render/film/develop.h"
#include "render/film/noise_estimate.h"
#include "render/film/picture_file.h"
#include "render/session/fill_cache.h"
#include "render/session/pilot.h"
#include "render/session/render_job.h"
#include "scene/cut_away.h"
#include "scene/scene_builder.h"

namespace idap::cli {

namespace {

struct Options {
  std::string input, output, camera, size = "960x640", integrator = "path", at, lamps = "auto";
  Look look;
  int spp = 0, threads = 0;
  double time = 0, noise = 0;
  std::optional<double> clouds;
  bool noDenoise = false, quick = false, cutAway = false, resume = false, json = false;
  bool lightGroups = false, noLightGroups = false;
};

class Stopwatch {
 public:
  double lapMilliseconds() {
    const auto now = std::chrono::steady_clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return ms;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

constexpr std::size_t kMostUnaskedGroups = 64;  // lights kept apart where nobody asked for it
constexpr double kSaveEvery = 60;  // s of tracing between two files of a picture that is being made

// What a picture shows, in words: of the same words one can be taken up again.
std::string wordsFor(const Options& options, const Camera& camera, const BuildOptions& build, bool cut) {
  std::uint64_t hash = 14'695'981'039'346'656'037u;  // FNV-1a of the home's file
  for (const std::byte byte : readFile(options.input, std::size_t{1} << 31))
    hash = (hash ^ static_cast<std::uint64_t>(byte)) * 1'099'511'628'211u;
  return fmt::format(
      "home {:x}, eye {} {} {}, view {} {} {}, lens {}, time {}, lamps {}, clouds {}, cut {}, {}, {}, "
      "sampling {}",
      hash, camera.eye.x, camera.eye.y, camera.eye.z, camera.yaw, camera.pitch, camera.fieldOfView,
      static_cast<int>(camera.lens), build.time.value_or(0), options.lamps, build.cloudiness.value_or(-1),
      cut, options.integrator, options.quick ? options.look.words() + " quick" : options.look.words(),
      render::kSamplingVersion);
}

// Into an empty film, what was made of it before. Nothing there yet is no error: it is begun then.
void takeUp(render::Film& film, const std::string& made, const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return;
  render::Layers before = render::loadLayers(file);
  if (before.made != made || before.film.width != film.width || before.film.height != film.height ||
      before.film.groups.size() != film.groups.size())
    throw IoError(file +
                  ": was made of another home, view or size, or by another version of the program, and "
                  "cannot be gone on with; leave out --resume "
                  "to make it anew, or choose another name");
  film = std::move(before.film);
}

int renderPicture(const Options& options) {
  const auto [width, height] = parseSize(options.size);
  const PictureKind kind = pictureKind(options.output);
  options.look.check(kind);
  if (options.resume && kind != PictureKind::Exr)
    throw UsageError("--resume goes on with an OpenEXR picture: let -o end in .exr");
  if (options.lightGroups && kind != PictureKind::Exr)
    throw UsageError("--light-groups: only an OpenEXR picture keeps lights apart; let -o end in .exr");
  if (options.lightGroups && options.quick)
    throw UsageError(
        "--light-groups: the cache of --quick does not know whose light it holds; leave one of them out");
  render::Film::requireSize(width, height);  // before anybody waits for the home
  requireWritable(options.output);
  const bool classic = options.integrator == "classic";
  const std::optional<CivilTime> at = dateTimeArgument("--at", options.at);

  ProgressBar bar;
  Warnings warnings(options.input, [&] { bar.wipe(); });
  std::string phase = "reading";
  Progress progress([&](double fraction, std::string_view) { bar.show(fraction, phase); });
  const CancelOnInterrupt interrupt(progress);
  Stopwatch watch;

  const ReadResult read = openHome(options.input, warnings, progress);
  const Home& home = read.home;
  const double aspect = static_cast<double>(width) / height;
  BuildOptions build;
  bool fromAbove = false;
  const Camera camera = chooseCamera(home, options.camera, aspect, fromAbove);
  const bool cut = options.cutAway && isOutside(home, camera.eye);
  build.ceilings = !fromAbove && !cut;
  build.lamps = lampPolicy(options.lamps);
  build.cloudiness = options.clouds;
  build.time = camera.time;
  if (at) build.time = utcAtHome(home, *at);
  const double readMs = watch.lapMilliseconds();

  phase = "building";
  const Catalog catalog;
  const BuiltScene built = buildScene(home, catalog, build, progress);
  warnings.add(built.warnings);
  const double buildMs = watch.lapMilliseconds();
  render::CompiledScene scene(built.scene, options.threads, nullptr, render::BvhLevels::One);
  if (cut) cutAway(scene, built, camera.eye);
  progress.check();
  const double bvhMs = watch.lapMilliseconds();

  phase = "rendering";
  render::RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.spp = options.spp > 0 ? options.spp : options.time > 0 || options.noise > 0 ? 0 : classic ? 4 : 64;
  settings.timeLimitSeconds = options.time;
  settings.noise = static_cast<float>(options.noise);
  settings.threads = options.threads;
  settings.integrator = classic ? render::IntegratorKind::Classic : render::IntegratorKind::Path;
  settings.perLightGroupLayers =
      kind == PictureKind::Exr && !options.quick && !options.noLightGroups &&
      (options.lightGroups || built.scene->lightGroups.size() <= kMostUnaskedGroups);
  render::Film film(width, height,
                    settings.perLightGroupLayers ? static_cast<int>(built.scene->lightGroups.size()) : 0);
  options.look.apply(settings);
  const render::Camera view = options.look.camera(toRenderCamera(camera, built, aspect), scene);
  if (!classic) settings.clampIndirect = render::clampFor(render::pilotExposure(scene, view, settings));
  if (!classic && !options.quick) {
    settings.guide = render::fillGuide(scene, view, settings, progress);
  } else if (!classic) {
    // Learning takes about a sixth of the time.
    const double paths = options.time > 0 ? 50'000 * options.time : 0.15 * settings.spp * width * height;
    settings.cache =
        render::fillCache(scene, view, settings, static_cast<int>(std::clamp(paths, 24e3, 6e5)), progress);
  }
  const std::string made = kind == PictureKind::Exr ? wordsFor(options, camera, build, cut) : std::string();
  if (options.resume) takeUp(film, made, options.output);
  render::RenderStats stats;
  const bool begun = film.samples > 0;
  for (bool more = true; more;) {
    // A long picture is saved as it grows, so that what was traced is never lost.
    const double left = options.time > 0 ? options.time - stats.seconds : 1e300;
    settings.timeLimitSeconds = kind == PictureKind::Exr ? std::min(left, kSaveEvery) : options.time;
    const render::RenderStats slice = render::render(scene, view, settings, film, progress);
    stats = {stats.seconds + slice.seconds, stats.paths + slice.paths, stats.rays + slice.rays, slice.spp};
    more = kind == PictureKind::Exr && !progress.cancelled() && left > kSaveEvery && slice.paths > 0 &&
           (settings.spp == 0 || film.samples < settings.spp) &&
           !(options.noise > 0 && slice.seconds < 0.9 * kSaveEvery);
    if (more) writeFilm(options.output, film, built.scene->lightGroups, made);
  }
  if (stats.paths == 0 && !begun) throw Cancelled();
  const double renderMs = watch.lapMilliseconds();

  phase = "developing";
  bar.show(0, phase);
  render::DevelopSettings develop;
  options.look.apply(develop);
  if (classic) develop.toneMap = render::ToneMap::Classic;
  develop.denoise = !options.noDenoise && !classic;
  develop.threads = options.threads;
  if (kind == PictureKind::Exr)
    writeFilm(options.output, film, built.scene->lightGroups, made);
  else
    savePicture(options.output, kind, film, built.scene->lightGroups, develop, options.look.transparent);
  const double developMs = watch.lapMilliseconds();

  if (options.json) {
    const auto rounded = [](double ms) { return std::round(ms * 10) / 10; };
    const nlohmann::ordered_json json{{"read_ms", rounded(readMs)},
                                      {"build_ms", rounded(buildMs)},
                                      {"bvh_ms", rounded(bvhMs)},
                                      {"render_ms", rounded(renderMs)},
                                      {"develop_ms", rounded(developMs)},
                                      {"width", width},
                                      {"height", height},
                                      {"spp", stats.spp},
                                      {"noise", classic ? 0.0f : render::noiseLevel(film)},
                                      {"paths", stats.paths},
                                      {"rays", stats.rays},
                                      {"triangles", built.triangles},
                                      {"instances", built.scene->instances.size()},
                                      {"lights", built.scene->lightGroups.size() - 2},
                                      {"peak_rss_mb", rounded(peakMemoryMegabytes())},
                                      {"interrupted", progress.cancelled()},
                                      {"output", options.output}};
    fmt::print("{}\n", json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  }
  if (progress.cancelled()) {
    bar.wipe();
    printMessage(
        fmt::format("stopped; {} holds the {} samples a pixel made so far", options.output, stats.spp));
  }
  return 0;
}

}  // namespace

Job describeRender(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("FILE", options->input, "Home to show (.idap, .sh3d)")->required();
  app.add_option("-o,--output", options->output,
                 "Picture to write: .png, .jpg, .exr (linear, with layers), .pcx or .gif")
      ->required();
  app.add_option("--camera", options->camera, "Point of view: its name, its number from 1, or top")
      ->type_name("NAME|N|top");
  app.add_option("--size", options->size, "Width and height in pixels (960x640)")->type_name("WxH");
  CLI::Option* spp =
      app.add_option("--spp", options->spp, "Samples a pixel (64)")->check(CLI::Range(1, 1'000'000));
  app.add_option("--time", options->time, "Seconds to render for, instead of --spp")
      ->check(within(0.01, 1e7))
      ->excludes(spp);
  app.add_option("--noise", options->noise,
                 "Render until the noise is below this share of each pixel's brightness, for instance 0.02 "
                 "(with --spp or --time: at most so long)")
      ->check(within(1e-4, 1));
  app.add_option("--integrator", options->integrator, "path: light as it is; classic: the shading of 1993")
      ->check(CLI::IsMember({"path", "classic"}));
  options->look.describe(app);
  app.add_option("--at", options->at, "Date and time at the home, for instance 2026-06-21T16:30")
      ->type_name("DATETIME");
  app.add_option("--lamps", options->lamps, "auto: as the home has them; on; off")
      ->check(CLI::IsMember({"auto", "on", "off"}));
  app.add_option("--clouds", options->clouds, "0 clear sky to 1 overcast; without it, as the home has it")
      ->check(within(0, 1));
  app.add_option("--threads", options->threads, "Processors to use (all)")->check(CLI::Range(1, 1024));
  app.add_flag(
      "--resume", options->resume,
      "Go on with the .exr that is there, up to --spp or for --time more; begin it where there is none");
  CLI::Option* apart = app.add_flag(
      "--light-groups", options->lightGroups,
      "Keep a layer for each lamp, the sun and the sky, for 'idap mix'; an .exr does anyway where there "
      "are at most 64");
  app.add_flag("--no-light-groups", options->noLightGroups,
               "Keep no such layers: smaller and a little faster")
      ->excludes(apart);
  app.add_flag("--cut-away", options->cutAway,
               "From outside: without the ceilings and the walls that are in the way");
  app.add_flag("--quick", options->quick,
               "Light that has bounced comes from a cache: half the noise in the same time, some blotches; "
               "the lights in an .exr are not kept apart");
  app.add_flag("--no-denoise", options->noDenoise, "Leave the noise in");
  app.add_flag("--json", options->json, "Print figures as one JSON object on standard output");
  return [options] { return renderPicture(*options); };
}

}  // namespace idap::cli
