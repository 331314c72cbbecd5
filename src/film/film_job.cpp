#include "film/film_job.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>

#include "film/light_meter.h"
#include "film/video_writer.h"
#include "render/denoise/denoise.h"
#include "render/film/develop.h"
#include "render/film/exposure.h"
#include "render/session/fill_cache.h"
#include "render/session/pilot.h"
#include "render/session/render_job.h"
#include "scene/cut_away.h"
#include "scene/scene_memory.h"

namespace idap {

namespace {

constexpr double kDissolve = 0.5;        // s, from one take to the next
constexpr double kMeterEvery = 0.2;      // s of a walk between measurements of the light
constexpr int kMeterDay = 48;            // measurements in a day
constexpr double kAdaptation = 0.7;      // s of a walk over which the exposure follows
constexpr double kMeterShare = 0.04;     // of the progress
constexpr std::size_t kCacheViews = 24;  // of a walk, that its light is learned from
constexpr int kCachePaths = 24'000;      // from each of them
constexpr int kStillSamples = 3;         // times as many samples where the camera stands

class FilmMaker {
 public:
  FilmMaker(const FilmPlan& plan, const Catalog& catalog, const FilmSettings& settings,
            const Progress& progress)
      : plan_(plan),
        catalog_(catalog),
        settings_(settings),
        progress_(progress),
        film_(settings.width, settings.height) {
    render_.width = settings.width;
    render_.height = settings.height;
    render_.threads = settings.threads;
  }

  void meter() {
    const std::size_t every =
        plan_.day ? std::max<std::size_t>(1, plan_.frames.size() / kMeterDay)
                  : std::max<std::size_t>(1, static_cast<std::size_t>(kMeterEvery * plan_.framesPerSecond));
    std::size_t begin = 0;
    std::vector<std::size_t> ends = plan_.cuts;
    ends.push_back(plan_.frames.size());
    for (const std::size_t end : ends) {
      LightCurve curve;
      for (std::size_t i = begin;; i = std::min(i + every, end - 1)) {
        progress_.check();
        progress_.report(kMeterShare * static_cast<double>(i) / static_cast<double>(plan_.frames.size()),
                         "measuring the light");
        curve.add(i, measured(plan_.frames[i]));
        if (i == end - 1) break;
      }
      curve.smooth(plan_.day ? 2.0 * static_cast<double>(every) : kAdaptation * plan_.framesPerSecond);
      if (settings_.constantExposure) curve.makeConstant();
      curves_.push_back(std::move(curve));
      begin = end;
    }
  }

  Image8 frame(std::size_t number) {
    Image8 image = developed(number);
    const auto cut = std::upper_bound(plan_.cuts.begin(), plan_.cuts.end(), number);
    if (cut == plan_.cuts.end()) return image;
    // The end of a take, where the camera stands, shows more and more of the next one's beginning.
    const double left = static_cast<double>(*cut - number) / (kDissolve * plan_.framesPerSecond);
    if (left >= 1) return image;
    const Image8 next = developed(*cut);
    const int share = static_cast<int>(std::lround(256 * (1 - left)));
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
      image.rgb[i] =
          static_cast<std::uint8_t>((image.rgb[i] * (256 - share) + next.rgb[i] * share + 128) >> 8);
    return image;
  }

  const std::vector<std::string>& warnings() const { return built_.warnings; }

 private:
  // The scene at the frame's time; built once for a walk.
  void build(const Camera& camera) {
    if (scene_ && camera.time == time_) return;
    BuildOptions options;
    options.lamps = settings_.lamps;
    options.cloudiness = settings_.cloudiness;
    options.time = camera.time;
    // A day is seen from one place; somebody outside sees in, as in the live view. A walk stays as built.
    const bool outside = plan_.day && isOutside(plan_.home, camera.eye);
    options.ceilings = !outside;
    if (!scene_) progress_.report(0, "building");
    BuiltScene built = buildScene(plan_.home, catalog_, options, progress_, &memory_);
    auto scene =
        std::make_unique<render::CompiledScene>(built.scene, settings_.threads, scene_.get(),
                                                plan_.day ? render::BvhLevels::Two : render::BvhLevels::One);
    if (outside) cutAway(*scene, built, camera.eye);
    scene_ = std::move(scene);
    built_ = std::move(built);
    time_ = camera.time;
    render_.cache = nullptr;
    cached_ = false;
  }

  render::Camera seen(const Camera& camera) const {
    return toRenderCamera(camera, built_, double(settings_.width) / settings_.height);
  }

  MeteredLight measured(const Camera& camera) {
    if (camera == meteredCamera_) return metered_;
    build(camera);
    render::RenderSettings pilot = render_;
    pilot.width = 64;
    pilot.height = std::clamp(64 * settings_.height / settings_.width, 16, 128);
    pilot.spp = 12;
    render::Film film(pilot.width, pilot.height);
    render::render(*scene_, seen(camera), pilot, film, progress_);
    progress_.check();
    meteredCamera_ = camera;
    return metered_ = {render::autoExposure(film), render::estimateIlluminant(film)};
  }

  MeteredLight lightAt(std::size_t number) const {
    const auto take = static_cast<std::size_t>(
        std::upper_bound(plan_.cuts.begin(), plan_.cuts.end(), number) - plan_.cuts.begin());
    return curves_[take].at(number);
  }

  bool still(std::size_t number) const {
    const auto& f = plan_.frames;
    return !plan_.day && ((number + 1 < f.size() && f[number + 1] == f[number]) ||
                          (number > 0 && f[number - 1] == f[number]));
  }

  Image8 developed(std::size_t number) {
    const MeteredLight light = lightAt(number);
    std::vector<Rgb> color = traced(number, light);
    const render::WhiteBalance balance(light.illuminant, render::DevelopSettings{}.whiteBalance);
    const float gain = render::exposureMultiplier(light.ev - settings_.compensation);
    for (Rgb& c : color) c = balance(c) * gain;
    return render::toImage(color, settings_.width, settings_.height, render::ToneMap::PbrNeutral);
  }

  // One cache for the whole walk: a new one for every frame would make the light flicker.
  void fillCache() {
    std::vector<render::Camera> cameras;
    const std::size_t step = std::max<std::size_t>(1, plan_.frames.size() / kCacheViews);
    for (std::size_t i = 0; i < plan_.frames.size(); i += step)
      if (plan_.frames[i].time == time_) cameras.push_back(seen(plan_.frames[i]));
    const int paths = kCachePaths * static_cast<int>(cameras.size());
    render_.cache = render::fillCache(*scene_, cameras, render_, paths, progress_);
    cached_ = true;
  }

  // Radiance, without noise. Frames that show the same are traced once.
  const std::vector<Rgb>& traced(std::size_t number, const MeteredLight& light) {
    const Camera& camera = plan_.frames[number];
    for (const auto& kept : kept_)
      if (!kept.color.empty() && kept.camera == camera) return kept.color;
    build(camera);
    film_.clear();
    // The same seed for all: what noise is left stays in its place instead of dancing.
    render_.spp = settings_.samples * (still(number) ? kStillSamples : 1);
    render_.clampIndirect = render::clampFor(light.ev);
    if (!plan_.day && !cached_) fillCache();
    if (plan_.day) render_.guide = render::fillGuide(*scene_, seen(camera), render_, progress_);
    render::render(*scene_, seen(camera), render_, film_, progress_);
    progress_.check();
    next_ = (next_ + 1) % 2;
    Kept& kept = kept_[next_];
    kept.camera = camera;
    kept.color = film_.meanColors();
    denoiser_.run(film_, kept.color, {.threads = settings_.threads, .progress = &progress_});
    return kept.color;
  }

  const FilmPlan& plan_;
  const Catalog& catalog_;
  const FilmSettings& settings_;
  const Progress& progress_;
  SceneMemory memory_;
  BuiltScene built_;
  std::unique_ptr<render::CompiledScene> scene_;
  std::optional<std::int64_t> time_;
  render::RenderSettings render_;
  bool cached_ = false;
  render::Film film_;
  render::Denoiser denoiser_;
  std::vector<LightCurve> curves_;  // one a take
  std::optional<Camera> meteredCamera_;
  MeteredLight metered_;
  struct Kept {
    Camera camera;
    std::vector<Rgb> color;
  };
  Kept kept_[2];
  std::size_t next_ = 0;
};

}  // namespace

FilmResult makeFilm(const FilmPlan& plan, const Catalog& catalog, const FilmSettings& asked,
                    const std::filesystem::path& file, const Progress& progress,
                    const std::function<void(FilmFrame)>& onFrame) {
  if (plan.frames.empty()) throw Error("a film needs a frame");
  FilmSettings settings = asked;
  settings.width = settings.width / 2 * 2;
  settings.height = settings.height / 2 * 2;
  VideoWriter writer(file, settings.width, settings.height, plan.framesPerSecond);
  FilmMaker maker(plan, catalog, settings, progress);
  FilmResult result;
  const std::size_t count = plan.frames.size();
  try {
    maker.meter();
    for (std::size_t i = 0; i < count; ++i) {
      progress.check();
      Image8 image = maker.frame(i);
      writer.add(image);
      if (onFrame) onFrame({static_cast<int>(i), static_cast<int>(count), std::move(image)});
      progress.report(
          kMeterShare + (1 - kMeterShare) * static_cast<double>(i + 1) / static_cast<double>(count),
          "filming");
    }
  } catch (const Cancelled&) {
    if (writer.frames() < plan.framesPerSecond) throw;
    result.stopped = true;
  }
  writer.finish();
  result.frames = writer.frames();
  result.warnings = maker.warnings();
  if (!writer.remark().empty()) result.warnings.push_back(writer.remark());
  return result;
}

int tracedFrames(const FilmPlan& plan) {
  int count = 0;
  for (std::size_t i = 0; i < plan.frames.size(); ++i)
    count += i == 0 || !(plan.frames[i] == plan.frames[i - 1]);
  return count;
}

double estimatedSeconds(const FilmPlan& plan, const FilmSettings& settings) {
  // Measured in furnished homes: paths, and pixels taken through the denoiser, that one processor does in a
  // second.
  constexpr double kPaths = 350'000, kPixels = 250'000, kDayFrame = 0.5;
  const double processors =
      settings.threads > 0 ? settings.threads : std::max(1u, std::thread::hardware_concurrency());
  const double pixels = static_cast<double>(settings.width) * settings.height;
  const double frame = pixels * (settings.samples / kPaths + 1 / kPixels) / processors;
  return tracedFrames(plan) * (frame + (plan.day ? kDayFrame : 0));
}

}  // namespace idap
