#include "studio/picture/picture_worker.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

#include "base/platform.h"
#include "render/accel/compiled_scene.h"
#include "render/denoise/denoise.h"
#include "render/film/develop.h"
#include "render/session/fill_cache.h"
#include "render/session/focus.h"
#include "render/session/pilot.h"
#include "render/session/render_job.h"
#include "scene/cut_away.h"
#include "studio/widgets/images.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFirstSlice =
    0.8;  // s of tracing before the picture is shown; each next one is twice as long
constexpr double kCoarsePixels = 24000;  // of the first look
constexpr int kCoarseSamples = 2;
constexpr std::size_t kMostLights = 64;  // that are kept apart
constexpr std::size_t kMostLightBytes = std::size_t{2} << 30;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

// A core is left to the window.
int threadsToUse() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) - 1); }

render::ToneMap toneMapOf(PictureTone tone) {
  return tone == PictureTone::Film         ? render::ToneMap::AgX
         : tone == PictureTone::FalseColor ? render::ToneMap::FalseColor
                                           : render::ToneMap::PbrNeutral;
}

// What is asked for, and how the asker reaches it while it is made.
struct Job {
  PictureRequest request;
  std::function<void()> tick;          // now and then, from the tracing threads
  Progress progress;                   // of all of it: cancelled by stop()
  std::atomic<bool> discarded{false};  // nobody wants the picture any more
  // What the end leaves.
  std::shared_ptr<PictureFilm> film;
  int samples = 0;

  std::mutex mutex;
  std::condition_variable resumed;
  std::shared_ptr<Progress> slice;  // under mutex: what is being traced, to be broken off
  bool paused = false;              // under mutex

  // The next slice of tracing. Waits while paused.
  std::shared_ptr<Progress> beginSlice() {
    std::unique_lock lock(mutex);
    resumed.wait(lock, [this] { return !paused || progress.cancelled(); });
    slice = std::make_shared<Progress>([this](double, std::string_view) {
      if (tick) tick();
    });
    if (progress.cancelled()) slice->cancel();
    return slice;
  }
  void pause(bool hold) {
    const std::lock_guard lock(mutex);
    paused = hold;
    if (hold && slice) slice->cancel();
    resumed.notify_all();
  }
  void stop() {
    const std::lock_guard lock(mutex);
    progress.cancel();
    if (slice) slice->cancel();
    resumed.notify_all();
  }
};

// One picture from home to pixels, on the worker's thread.
class Tracing {
 public:
  struct Report {
    std::function<void(QImage)> pictured;
    std::function<void(double, double)> progressed;
  };

  Tracing(Job& job, render::Denoiser& denoiser, Report report)
      : job_(job),
        request_(job.request),
        denoiser_(denoiser),
        report_(std::move(report)),
        aspect_(static_cast<double>(request_.width) / request_.height),
        made_(std::make_shared<PictureFilm>()),
        film_(made_->film) {}

  void make() {
    report_.progressed(0, -1);
    made_->look.compensation = static_cast<float>(request_.brightness);
    made_->look.toneMap = toneMapOf(request_.tone);
    build();
    showCoarse();
    refine();
    job_.samples = film_.samples;
    made_->lightGroups = built_.scene->lightGroups;
    made_->lamps = built_.lamps;
    made_->lamps.resize(made_->lightGroups.size());
    if (!request_.classic) job_.film = made_;
  }

 private:
  void build() {
    const Camera camera = request_.camera ? *request_.camera : topCamera(request_.home, aspect_);
    // Somebody outside sees in, as in the live view.
    const bool outside = isOutside(request_.home, camera.eye);
    BuildOptions options;
    options.ceilings = request_.camera.has_value() && !outside;
    options.time = request_.camera ? camera.time : request_.time;
    options.lamps = request_.lamps;
    built_ = buildScene(request_.home, *request_.catalog, options, job_.progress);
    scene_.emplace(built_.scene, threads_);
    job_.progress.check();
    if (outside && request_.camera) cutAway(*scene_, built_, camera.eye);
    // Each lamp's light by itself, so that it can be dimmed afterwards, where there is room for that.
    settings_.perLightGroupLayers =
        !request_.classic && request_.keepLights && built_.scene->lightGroups.size() <= kMostLights &&
        render::Film::bytesNeeded(request_.width, request_.height, int(built_.scene->lightGroups.size())) <
            kMostLightBytes;
    film_ = render::Film(request_.width, request_.height,
                         settings_.perLightGroupLayers ? int(built_.scene->lightGroups.size()) : 0);
    view_ = toRenderCamera(camera, built_, aspect_);
    if (request_.upright && request_.camera) view_ = render::upright(view_);
    if (request_.aperture > 0)
      view_ = render::withAperture(*scene_, view_, static_cast<float>(request_.aperture));
    settings_.width = request_.width;
    settings_.height = request_.height;
    settings_.spp = request_.samples;
    settings_.threads = threads_;
    if (request_.classic) {
      settings_.integrator = render::IntegratorKind::Classic;
    } else {
      settings_.clampIndirect = render::clampFor(render::pilotExposure(*scene_, view_, settings_));
      settings_.guide = render::fillGuide(*scene_, view_, settings_, job_.progress);
    }
    job_.progress.check();
  }

  void showCoarse() {
    const double scale = std::sqrt(kCoarsePixels / static_cast<double>(film_.pixels()));
    if (scale > 0.7) return;  // the real one comes as soon
    render::RenderSettings coarse = settings_;
    coarse.width = std::max(8, static_cast<int>(std::lround(request_.width * scale)));
    coarse.height = std::max(8, static_cast<int>(std::lround(coarse.width / aspect_)));
    coarse.spp = kCoarseSamples;
    coarse.perLightGroupLayers = false;
    render::Film film(coarse.width, coarse.height);
    render::render(*scene_, view_, coarse, film, job_.progress);
    job_.progress.check();
    show(film, true);
  }

  // Slices of doubling length, so that the cost of showing stays small beside that of tracing.
  void refine() {
    job_.tick = [this] { tell(); };
    double slice = kFirstSlice, shownAt = 0;
    const bool timed = request_.seconds > 0;
    for (bool last = false; !last && !job_.progress.cancelled(); slice *= 2) {
      const double left = timed ? request_.seconds - traced_ : 1e300;
      // The last slice takes the rest rather than leave a crumb.
      settings_.timeLimitSeconds = slice * 1.5 > left ? left : slice;
      const std::shared_ptr<Progress> progress = job_.beginSlice();
      begun_ = Clock::now();
      render::render(*scene_, view_, settings_, film_, *progress);
      traced_ += secondsSince(*begun_);
      begun_.reset();
      samples_ = film_.samples;
      const bool covered = film_.samples >= 1;
      // A slow machine goes on until every pixel has been looked at once.
      if (timed && !covered && traced_ >= request_.seconds) request_.seconds = 2 * traced_;
      last = (timed && traced_ >= request_.seconds - 0.05) ||
             (request_.samples > 0 && film_.samples >= request_.samples);
      if (!covered || job_.progress.cancelled()) continue;
      show(film_, !last);
      shownAt = traced_;
    }
    // Stopped: what was traced since the last look is worth showing when it is much.
    if (film_.samples >= 1 && traced_ > 1.5 * shownAt && !job_.discarded) show(film_, true);
  }

  void tell() {
    const std::unique_lock lock(telling_, std::try_to_lock);
    if (!lock || !begun_ || (told_ && secondsSince(*told_) < 0.2)) return;
    told_ = Clock::now();
    const double done = traced_ + secondsSince(*begun_);
    double total = request_.seconds > 0 ? request_.seconds : 1e300;
    if (samples_ > 0 && request_.samples > 0) total = std::min(total, traced_ * request_.samples / samples_);
    total = std::max(total, done);
    report_.progressed(total < 1e299 ? done / total : 0, total < 1e299 ? total - done : -1);
  }

  void show(const render::Film& film, bool fast) {
    if (job_.discarded) return;
    render::DevelopSettings settings = made_->look;
    settings.fastDenoise = fast;
    settings.threads = threads_;
    if (request_.classic) {
      settings.toneMap = render::ToneMap::Classic;
      settings.denoise = false;
    }
    QImage image = toQImage(render::develop(film, settings, &denoiser_));
    if (!job_.discarded) report_.pictured(std::move(image));
  }

  Job& job_;
  PictureRequest& request_;
  render::Denoiser& denoiser_;
  Report report_;
  double aspect_;
  int threads_ = request_.allProcessors ? 0 : threadsToUse();
  std::shared_ptr<PictureFilm> made_;
  render::Film& film_;
  BuiltScene built_;
  std::optional<render::CompiledScene> scene_;
  render::Camera view_;
  render::RenderSettings settings_;
  double traced_ = 0;  // s, in the slices that are over
  int samples_ = 0;    // a pixel, of the slices that are over
  std::optional<Clock::time_point> begun_, told_;
  std::mutex telling_;
};

}  // namespace

struct PictureWorker::Impl {
  PictureWorker& worker;
  std::shared_ptr<Job> current;             // GUI thread: being made or waiting
  std::shared_ptr<const PictureFilm> film;  // of the last finished one
  int samples = 0;
  std::mutex mutex;
  std::condition_variable wake;
  std::shared_ptr<Job> waiting;  // under mutex
  bool closing = false;          // under mutex
  std::thread thread;

  explicit Impl(PictureWorker& w) : worker(w) {}

  void loop() {
    lowerThreadPriority();
    render::Denoiser denoiser;
    for (;;) {
      std::shared_ptr<Job> job;
      {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return closing || waiting; });
        if (closing) return;
        job = std::exchange(waiting, nullptr);
      }
      run(job, denoiser);
    }
  }

  void run(const std::shared_ptr<Job>& job, render::Denoiser& denoiser) {
    QString trouble;
    try {
      Tracing(*job, denoiser,
              {.pictured =
                   [&](QImage image) {
                     tell(job, [image = std::move(image)](PictureWorker& w) { emit w.pictured(image); });
                   },
               .progressed =
                   [&](double fraction, double left) {
                     tell(job, [=](PictureWorker& w) { emit w.progressed(fraction, left); });
                   }})
          .make();
    } catch (const Cancelled&) {
    } catch (const std::exception& error) {
      trouble = toQt(error.what());
    }
    tell(job, [this, job, trouble](PictureWorker& w) {
      current = nullptr;
      film = job->film;
      samples = job->samples;
      if (!trouble.isEmpty()) emit w.failed(trouble);
      emit w.finished();
    });
  }

  // On the GUI thread, unless the job has been replaced by then.
  template <class Action>
  void tell(const std::shared_ptr<Job>& job, Action action) {
    QMetaObject::invokeMethod(
        &worker,
        [this, job, action = std::move(action)] {
          if (current == job) action(worker);
        },
        Qt::QueuedConnection);
  }

  void discard() {
    if (!current) return;
    current->discarded = true;
    current->stop();
    current = nullptr;
  }
};

PictureWorker::PictureWorker(QObject* parent) : QObject(parent), impl_(std::make_unique<Impl>(*this)) {}

PictureWorker::~PictureWorker() {
  impl_->discard();
  if (!impl_->thread.joinable()) return;
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->closing = true;
  }
  impl_->wake.notify_all();
  impl_->thread.join();
}

void PictureWorker::start(PictureRequest request) {
  impl_->discard();
  impl_->current = std::make_shared<Job>();
  impl_->current->request = std::move(request);
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->waiting = impl_->current;
  }
  impl_->wake.notify_all();
  if (!impl_->thread.joinable()) impl_->thread = std::thread([this] { impl_->loop(); });
}

void PictureWorker::stop() {
  if (impl_->current) impl_->current->stop();
}

void PictureWorker::pause(bool paused) {
  if (impl_->current) impl_->current->pause(paused);
}

bool PictureWorker::paused() const {
  if (!impl_->current) return false;
  const std::lock_guard lock(impl_->current->mutex);
  return impl_->current->paused;
}

std::shared_ptr<const PictureFilm> PictureWorker::film() const { return impl_->film; }
int PictureWorker::samples() const { return impl_->samples; }

bool PictureWorker::busy() const { return impl_->current != nullptr; }

}  // namespace idap
