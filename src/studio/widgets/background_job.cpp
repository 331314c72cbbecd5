#include "studio/widgets/background_job.h"

#include <QElapsedTimer>
#include <QTimer>
#include <atomic>
#include <new>
#include <thread>

#include "base/error.h"
#include "studio/widgets/texts.h"

namespace idap {

struct BackgroundJob::Impl {
  QString what;
  Done done;
  std::atomic<double> fraction{0};
  Progress progress{
      [this](double part, std::string_view) { fraction.store(part, std::memory_order_relaxed); }};
  std::exception_ptr error;
  QElapsedTimer clock;
  QTimer timer;
  bool cancellable = true;
  std::thread thread;
};

BackgroundJob::BackgroundJob(QString what, Work work, Done done, QObject* owner)
    : QObject(owner), impl_(std::make_unique<Impl>()) {
  impl_->what = std::move(what);
  impl_->done = std::move(done);
  impl_->clock.start();
  connect(&impl_->timer, &QTimer::timeout, this, &BackgroundJob::progressed);
  impl_->timer.start(100);
  impl_->thread = std::thread([this, work = std::move(work)] {
    try {
      work(impl_->progress);
    } catch (...) {
      impl_->error = std::current_exception();
    }
    QMetaObject::invokeMethod(
        this,
        [this] {
          impl_->thread.join();
          impl_->timer.stop();
          impl_->fraction = 1;
          const Done finished = std::move(impl_->done);
          deleteLater();
          if (finished) finished(std::exchange(impl_->error, nullptr));
        },
        Qt::QueuedConnection);
  });
}

BackgroundJob::~BackgroundJob() {
  impl_->progress.cancel();
  if (impl_->thread.joinable()) impl_->thread.join();
}

QString BackgroundJob::what() const { return impl_->what; }
double BackgroundJob::fraction() const { return impl_->fraction.load(std::memory_order_relaxed); }
bool BackgroundJob::cancellable() const { return impl_->cancellable; }
void BackgroundJob::setCancellable(bool cancellable) { impl_->cancellable = cancellable; }

std::optional<double> BackgroundJob::secondsLeft() const {
  const double done = fraction(), seconds = double(impl_->clock.elapsed()) / 1000;
  if (done < 0.05 || seconds < 1) return std::nullopt;
  return seconds * (1 - done) / done;
}

void BackgroundJob::cancel() {
  if (impl_->cancellable) impl_->progress.cancel();
}

QString errorText(std::exception_ptr error) {
  try {
    if (error) std::rethrow_exception(error);
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    return QCoreApplication::translate("idap::BackgroundJob", "There is not enough memory for it.");
  } catch (const std::exception& e) {
    return toQt(e.what());
  }
  return {};
}

}  // namespace idap
