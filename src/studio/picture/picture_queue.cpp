#include "studio/picture/picture_queue.h"

#include <QDateTime>

#include "model/edits/picture_edits.h"
#include "render/film/picture_file.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/images.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

LampPolicy policyOf(PictureLamps lamps) {
  return lamps == PictureLamps::On    ? LampPolicy::On
         : lamps == PictureLamps::Off ? LampPolicy::Off
                                      : LampPolicy::Auto;
}

PictureRequest requestOf(Home home, std::shared_ptr<const Catalog> catalog, const PictureSettings& s) {
  PictureRequest request;
  request.home = std::move(home);
  request.catalog = std::move(catalog);
  if (!s.fromAbove) request.camera = s.view;
  request.time = s.view.time;
  request.width = s.width;
  request.height = s.height;
  request.samples = s.samples;
  request.seconds = s.seconds;
  request.lamps = policyOf(s.lamps);
  request.classic = s.classic;
  request.tone = s.tone;
  request.brightness = s.brightness;
  request.aperture = s.aperture;
  request.upright = s.upright;
  request.keepLights = true;
  return request;
}

}  // namespace

PictureQueue::PictureQueue(Editor& editor, QObject* parent) : QObject(parent), editor_(editor) {
  connect(&worker_, &PictureWorker::pictured, this, [this](const QImage& picture) {
    if (Job* job = current()) {
      job->preview = picture;
      emit previewed(job->id);
    }
  });
  connect(&worker_, &PictureWorker::progressed, this, [this](double fraction, double secondsLeft) {
    if (Job* job = current()) {
      job->fraction = fraction;
      job->secondsLeft = secondsLeft;
      emit changed();
    }
  });
  connect(&worker_, &PictureWorker::failed, this, &PictureQueue::failed);
  connect(&worker_, &PictureWorker::finished, this, [this] { keep(); });
  subscription_ = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change != Editor::Change::Document) return;
    // Another home: these would be pictures of the one before.
    films_.clear();
    while (jobs_.size() > 1) remove(jobs_.back().id);
    if (!jobs_.empty()) remove(jobs_.front().id);
  }});
}

PictureQueue::~PictureQueue() { editor_.unsubscribe(subscription_); }

const PictureQueue::Job* PictureQueue::find(int id) const {
  const auto at = std::find_if(jobs_.begin(), jobs_.end(), [id](const Job& job) { return job.id == id; });
  return at == jobs_.end() ? nullptr : &*at;
}

int PictureQueue::add(std::string name, const PictureSettings& settings) {
  Job job;
  job.id = ++lastId_;
  job.name = std::move(name);
  job.settings = settings;
  homes_[job.id] = editor_.document().snapshot().home;
  jobs_.push_back(std::move(job));
  next();
  emit changed();
  return lastId_;
}

void PictureQueue::next() {
  Job* job = current();
  if (!job || job->state != Job::State::Waiting || worker_.busy()) return;
  job->state = Job::State::Tracing;
  removing_ = false;
  worker_.start(requestOf(homes_[job->id], editor_.sharedCatalog(), job->settings));
}

void PictureQueue::pause(int id, bool paused) {
  Job* job = current();
  if (!job || job->id != id || job->state == Job::State::Keeping || job->state == Job::State::Waiting) return;
  job->state = paused ? Job::State::Paused : Job::State::Tracing;
  worker_.pause(paused);
  emit changed();
}

void PictureQueue::stopAndKeep(int id) {
  const Job* job = find(id);
  if (!job) return;
  if (job->state == Job::State::Waiting)
    remove(id);
  else
    worker_.stop();
}

void PictureQueue::remove(int id) {
  const Job* job = find(id);
  if (!job || job->state == Job::State::Keeping) return;
  if (job == current() && worker_.busy()) {
    removing_ = true;
    worker_.stop();
    return;
  }
  homes_.erase(id);
  std::erase_if(jobs_, [id](const Job& j) { return j.id == id; });
  emit changed();
}

// The one being made has come to its end.
void PictureQueue::keep() {
  Job* job = current();
  if (!job) return;
  const int id = job->id;
  const auto forget = [this, id] {
    homes_.erase(id);
    std::erase_if(jobs_, [id](const Job& j) { return j.id == id; });
    next();
    emit changed();
  };
  if (removing_ || job->preview.isNull()) return forget();
  job->state = Job::State::Keeping;
  Picture picture;
  picture.name = job->name;
  picture.settings = job->settings;
  picture.made = QDateTime::currentMSecsSinceEpoch();
  picture.samples = worker_.samples();
  const QImage image = job->preview;
  const std::shared_ptr<const PictureFilm> film = worker_.film();
  const std::uint64_t ofHome = reinterpret_cast<std::uintptr_t>(&editor_.document());
  runInBackground<Bytes>(
      this, tr("Keeping the picture"),
      [image](const Progress&) { return render::encodePicture(toImage8(image), "png"); },
      [this, picture, film, id, ofHome, forget](Bytes png) {
        const auto bytes = std::make_shared<const Bytes>(std::move(png));
        const bool same = ofHome == reinterpret_cast<std::uintptr_t>(&editor_.document());
        const PictureId kept_{editor_.document().freeId()};
        forget();
        if (!same) return;
        try {
          editor_.document().amend([&](const Home& home) { return addPicture(home, kept_, picture, bytes); });
        } catch (const Error& error) {
          emit failed(toQt(error.what()));
          return;
        }
        if (film) films_[kept_] = film;
        emit kept(id, kept_);
      },
      [this, forget](std::exception_ptr error) {
        forget();
        if (const QString why = errorText(error); !why.isEmpty()) emit failed(why);
      });
  emit changed();
}

std::shared_ptr<const PictureFilm> PictureQueue::filmOf(PictureId picture) const {
  const auto at = films_.find(picture);
  return at == films_.end() ? nullptr : at->second;
}

}  // namespace idap
