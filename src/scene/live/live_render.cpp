#include "scene/live/live_render.h"

#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "base/platform.h"
#include "render/denoise/denoise.h"
#include "render/film/carry_over.h"
#include "render/film/crop.h"
#include "render/film/develop.h"
#include "render/film/enlarge.h"
#include "render/film/exposure.h"
#include "render/session/fill_cache.h"
#include "render/session/pilot.h"
#include "render/session/render_job.h"
#include "scene/live/live_stage.h"

namespace idap {

namespace {

constexpr double kCoarsePixels = 3600;    // traced for the first frame, at most
constexpr double kSketchPixels = 50'000;  // that it is enlarged to, at most
constexpr double kCoarseTime = 0.026;     // s that it may take: slow machines trace fewer
constexpr double kAnswerTime = 0.035;  // s from an edit to its frame; less is left where building takes long
constexpr double kShortest = 0.012;    // s that are left at least
constexpr double kFewest = 0.3;        // share of those pixels, at least
constexpr int kCachePaths = 24'000;    // that a view's light is learned from at first
constexpr int kBetterPaths = 200'000;  // and once it has so many samples a pixel
constexpr int kBetterFrom = 8;
// Until there are so many samples a pixel, what has not changed is shown as it was before.
constexpr int kCarriedUntil = 8;
constexpr int kMovedSamples = 2;    // a pixel, of what has moved, before the whole view gets any
constexpr double kMostMoved = 0.4;  // of the view, for that to be worth while
constexpr double kCalm = 0.35;      // how far the exposure of coarse frames follows each new one
constexpr float kJump = 1.5f;       // stops from where it does so at once

// Tracing threads give way to the window's.
class LowPriority : public tbb::task_scheduler_observer {
 public:
  LowPriority() { observe(true); }
  ~LowPriority() override { observe(false); }
  void on_scheduler_entry(bool worker) override {
    if (worker) lowerThreadPriority();
  }
};

std::pair<int, int> sized(const LiveRequest& r, double pixels) {
  const double scale = std::min(1.0, std::sqrt(pixels / (double(r.width) * r.height)));
  return {std::max(8, static_cast<int>(std::lround(r.width * scale))),
          std::max(8, static_cast<int>(std::lround(r.height * scale)))};
}

}  // namespace

struct LiveRender::Impl {
  Sink sink;
  int threads;
  std::mutex mutex;
  std::condition_variable wake;
  std::optional<LiveRequest> waiting, last;                           // under mutex
  std::uint64_t generation = 0;                                       // under mutex: of the newest request
  bool paused = false, closing = false;                               // under mutex
  std::shared_ptr<Progress> refining;                                 // under mutex: to be broken off
  std::shared_ptr<Progress> building = std::make_shared<Progress>();  // broken off only at the end
  std::thread thread;

  // The render thread's own.
  LiveStage stage;
  render::Denoiser denoiser;
  LiveRequest request;
  std::uint64_t answering = 0;
  std::shared_ptr<LiveView> view;
  // A whole frame as it was last shown, before exposure, and what it was a view of.
  struct Clean {
    LiveRequest request;  // without the home
    std::shared_ptr<const LiveView> view;
    render::Features sketch;  // as coarse frames see it
    render::CleanPicture picture;
    float ev = 0;
    Rgb illuminant{1, 1, 1};
  };
  std::optional<Clean> before, latest;  // the request now answered; by it
  std::optional<float> ev;
  Rgb illuminant{1, 1, 1};
  double share = 1;  // of the coarse frame's pixels

  Impl(Sink s, int n) : sink(std::move(s)), threads(n), stage(n) {}

  void loop() {
    lowerThreadPriority();
    const LowPriority workers;
    for (;;) {
      std::shared_ptr<Progress> progress;
      {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return closing || (waiting && !paused); });
        if (closing) return;
        request = *std::exchange(waiting, std::nullopt);
        last = request;
        answering = generation;
        progress = refining = std::make_shared<Progress>();
      }
      try {
        const auto began = std::chrono::steady_clock::now();
        stage.follow(request, *building);
        keepWhatStays();
        const std::chrono::duration<double> built = std::chrono::steady_clock::now() - began;
        coarse(std::clamp(kAnswerTime - built.count(), kShortest, kCoarseTime));
        refine(*progress);
      } catch (const Cancelled&) {
      } catch (const std::exception& error) {
        if (sink.failed) sink.failed(error.what());
      }
    }
  }

  render::Camera camera() const {
    return toRenderCamera(request.camera, stage.built(), double(request.width) / request.height);
  }

  void lookThrough(int width, int height) {
    auto next = std::make_shared<LiveView>();
    next->camera = request.camera;
    next->outside = stage.outside();
    next->features = render::features(stage.scene(), camera(), width, height, threads);
    next->objects = stage.built().objects;
    next->parts = stage.parts();
    view = std::move(next);
  }

  void emitPicture(render::CleanPicture picture, int samples, bool finished) {
    const render::WhiteBalance balance(illuminant, render::DevelopSettings{}.whiteBalance);
    const float gain = render::exposureMultiplier(*ev - request.compensation);
    for (Rgb& c : picture.color) c = balance(c) * gain;
    sink.frame({answering, render::toImage(picture.color, picture.width, picture.height, request.toneMap),
                samples, finished, *ev - request.compensation, view});
  }

  // The exposure and the colour of the light. calmly: from few paths, which are not to make the view flicker.
  void meter(const render::Film& film, const std::vector<Rgb>& color, bool calmly) {
    const float measured = render::autoExposure(film, color);
    const Rgb light = render::estimateIlluminant(film);
    if (!calmly || !ev || std::fabs(measured - *ev) > kJump) {
      ev = measured;
      illuminant = light;
    } else {
      *ev += float(kCalm) * (measured - *ev);
      illuminant += (light - illuminant) * float(kCalm);
    }
  }

  // The same by what has changed, seen through the same film: small ones meter a little differently.
  void meterAgainstBefore(render::Film film, const render::CleanPicture& shown) {
    const auto measured = [&](const render::CleanPicture& picture) {
      std::vector<Rgb> color = render::reduced(picture, film.width, film.height);
      const float exposure = render::autoExposure(film, color);
      for (std::size_t i = 0; i < color.size(); ++i) film.color[i] = color[i] * film.weight[i];
      return std::pair(exposure, render::estimateIlluminant(film));
    };
    const auto [evNow, lightNow] = measured(shown);
    const auto [evBefore, lightBefore] = measured(before->picture);
    ev = before->ev + evNow - evBefore;
    illuminant = before->illuminant * lightNow / lightBefore;
  }

  // A frame at once: little light, much sharpness. Never broken off, so that something shows while changes
  // come in faster than frames.
  void coarse(double budget) {
    const auto began = std::chrono::steady_clock::now();
    const auto [w, h] = sized(request, share * kCoarsePixels);
    render::RenderSettings settings;
    settings.width = w;
    settings.height = h;
    settings.spp = 1;
    settings.threads = threads;
    if (ev) settings.clampIndirect = render::clampFor(*ev);
    render::Film film(w, h);
    render::render(stage.scene(), camera(), settings, film);
    auto [sw, sh] = sized(request, share * kSketchPixels);
    if (before) sw = before->sketch.width, sh = before->sketch.height;
    lookThrough(sw, sh);
    std::vector<Rgb> color = film.meanColors();
    denoiser.run(film, color, {.threads = threads, .fast = true});
    render::CleanPicture shown{sw, sh, render::enlarged(film, color, view->features, threads)};
    if (before) {
      shown =
          render::carriedOver(before->picture, before->sketch, film, view->features, shown.color, 1, threads);
      meterAgainstBefore(film, shown);
    } else {
      meter(film, color, true);
    }
    emitPicture(std::move(shown), 0, false);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    share = std::clamp(share * std::clamp(budget / took.count(), 0.7, 1.1), kFewest, 1.0);
  }

  // What was shown last is of use where the same is looked at in the same light.
  void keepWhatStays() {
    if (latest) before = std::exchange(latest, std::nullopt);
    if (!before) return;
    const LiveRequest& r = before->request;
    if (r.camera != request.camera || r.width != request.width || r.height != request.height ||
        r.cut != request.cut || r.lamps != request.lamps || r.catalog != request.catalog ||
        before->view->outside != stage.outside())
      before.reset();
  }

  void keep(const render::CleanPicture& picture) {
    if (!latest) {
      const auto [w, h] = sized(request, share * kSketchPixels);
      latest = Clean{request, view, render::features(stage.scene(), camera(), w, h, threads), {}};
      latest->request.home = {};
    }
    latest->picture = picture;
    latest->ev = *ev;
    latest->illuminant = illuminant;
  }

  // A third of the size first, then what has moved, then the whole in waves of doubling length.
  void refine(const Progress& progress) {
    render::RenderSettings settings;
    settings.threads = threads;
    settings.clampIndirect = render::clampFor(*ev);
    settings.width = std::max(8, request.width / 3);
    settings.height = std::max(8, request.height / 3);
    settings.spp = 1;
    settings.cache = render::fillCache(stage.scene(), camera(), settings, kCachePaths, progress);
    render::CleanPicture shown;
    {
      render::Film small(settings.width, settings.height);
      render::render(stage.scene(), camera(), settings, small, progress);
      progress.check();
      lookThrough(request.width, request.height);
      shown = show(small, 0, false, progress);
    }
    settings.width = request.width;
    settings.height = request.height;
    render::Film film(request.width, request.height);
    if (before) showWhatMoved(film, settings, std::move(shown), progress);
    for (int samples = 1; samples <= request.samples; samples *= 2) {
      settings.spp = samples;
      if (samples == kBetterFrom)
        settings.cache = render::fillCache(stage.scene(), camera(), settings, kBetterPaths, progress);
      render::render(stage.scene(), camera(), settings, film, progress);
      progress.check();
      show(film, samples, samples * 2 > request.samples, progress);
    }
  }

  // Shows the picture with what has moved made anew. The film keeps the paths.
  void showWhatMoved(render::Film& film, render::RenderSettings settings, render::CleanPicture shown,
                     const Progress& progress) {
    const render::Features &seen = before->view->features, &sees = view->features;
    const render::PixelRegion moved = render::changedRegion(seen, sees);
    if (moved.empty() || double(moved.pixels()) > kMostMoved * double(film.pixels())) return;
    settings.region = moved;
    settings.spp = kMovedSamples;
    render::render(stage.scene(), camera(), settings, film, progress);
    progress.check();
    const render::Film part = render::cropped(film, moved);
    std::vector<Rgb> color = part.meanColors();
    denoiser.run(part, color, {.threads = threads, .fast = true, .progress = &progress});
    progress.check();
    const render::CleanPicture was{moved.width, moved.height,
                                   render::cropped(shown.color, shown.width, moved)};
    const render::CleanPicture is = render::carriedOver(was, render::cropped(seen, moved), part,
                                                        render::cropped(sees, moved), color, 1, threads);
    render::paste(is.color, shown.color, shown.width, moved);
    emitPicture(std::move(shown), 0, false);
  }

  // Makes a frame of the film and shows it; its picture before exposure.
  render::CleanPicture show(const render::Film& film, int samples, bool finished, const Progress& progress) {
    std::vector<Rgb> color = film.meanColors();
    denoiser.run(film, color, {.threads = threads, .fast = !finished, .progress = &progress});
    progress.check();
    const bool carries = before && !finished && samples < kCarriedUntil;
    if (!carries) meter(film, color, false);
    if (film.width < request.width) color = render::enlarged(film, color, view->features, threads);
    render::CleanPicture shown{request.width, request.height, std::move(color)};
    if (carries) {
      const float old = 1 - static_cast<float>(samples) / static_cast<float>(kCarriedUntil);
      shown = render::carriedOver(before->picture, before->view->features, film, view->features, shown.color,
                                  old, threads);
      meterAgainstBefore(film, shown);
    }
    if (film.width == request.width) keep(shown);
    if (samples >= kCarriedUntil) before.reset();
    emitPicture(shown, samples, finished);
    return shown;
  }
};

LiveRender::LiveRender(Sink sink, int threads)
    : impl_(std::make_unique<Impl>(
          std::move(sink),
          threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())))) {
  impl_->thread = std::thread([this] { impl_->loop(); });
}

LiveRender::~LiveRender() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->closing = true;
    impl_->building->cancel();
    if (impl_->refining) impl_->refining->cancel();
  }
  impl_->wake.notify_all();
  impl_->thread.join();
}

std::uint64_t LiveRender::submit(LiveRequest request) {
  request.width = std::clamp(request.width, 16, 8192);
  request.height = std::clamp(request.height, 16, 8192);
  std::uint64_t generation = 0;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->waiting = std::move(request);
    generation = ++impl_->generation;
    if (impl_->refining) impl_->refining->cancel();
  }
  impl_->wake.notify_all();
  return generation;
}

void LiveRender::pause(bool paused) {
  {
    const std::lock_guard lock(impl_->mutex);
    if (impl_->paused == paused) return;
    impl_->paused = paused;
    if (paused && impl_->refining) impl_->refining->cancel();
    if (!paused && !impl_->waiting && impl_->generation > 0) impl_->waiting = impl_->last;
  }
  impl_->wake.notify_all();
}

}  // namespace idap
