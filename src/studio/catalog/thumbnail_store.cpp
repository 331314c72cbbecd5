#include "studio/catalog/thumbnail_store.h"

#include <QBuffer>
#include <QCache>
#include <QCryptographicHash>
#include <QImage>
#include <QSet>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "base/error.h"
#include "base/platform.h"
#include "render/denoise/denoise.h"
#include "scene/thumbnail.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kVersion = 1;  // raised when the pictures, or the pieces built into the program, look different
constexpr int kKept = 400;   // pictures in memory
constexpr std::size_t kQueue = 160;  // pictures asked for: more than ever fit on a screen
constexpr int kDelay = 800;          // ms

struct Request {
  CatalogPiecePtr piece;
  int side = 0;
  QString key;
};

QString keyOf(const CatalogPiece& piece, int side) {
  const QString words = QStringLiteral("%1|%2|%3|%4|%5|%6|%7")
                            .arg(toQt(piece.id), toQt(piece.library))
                            .arg(piece.size.x, 0, 'g', 6)
                            .arg(piece.size.y, 0, 'g', 6)
                            .arg(piece.size.z, 0, 'g', 6)
                            .arg(side)
                            .arg(kVersion);
  return QString::fromLatin1(QCryptographicHash::hash(words.toUtf8(), QCryptographicHash::Md5).toHex());
}

QImage toQImage(const Image8& picture) {
  return QImage(picture.rgb.data(), picture.width, picture.height, picture.width * 3, QImage::Format_RGB888)
      .convertToFormat(QImage::Format_RGB32);
}

void saveQuietly(const QImage& image, const std::filesystem::path& file) {
  QByteArray png;
  QBuffer buffer(&png);
  if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")) return;
  try {
    std::error_code ignored;
    std::filesystem::create_directories(file.parent_path(), ignored);
    writeFileAtomically(file, {reinterpret_cast<const std::byte*>(png.constData()), std::size_t(png.size())});
  } catch (const IoError&) {
    // Without a cache the picture is traced again next time.
  }
}

}  // namespace

// One thread reads what is on disk, which takes a millisecond each; what is not there goes on to the other,
// which traces.
struct ThumbnailStore::Impl {
  ThumbnailStore* self = nullptr;
  std::shared_ptr<const Catalog> catalog;
  std::filesystem::path folder;

  // Of the GUI thread.
  QCache<QString, QPixmap> pictures{kKept};
  QSet<QString> asked, failed;
  std::vector<Request> batch;
  QTimer delay;

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Request> toRead, toTrace;  // the last is next
  bool stopping = false, mayTrace = false;
  Progress stop;
  std::thread reader, tracer;

  QPixmap find(const CatalogPiecePtr& piece, int side) {
    if (!piece) return {};
    const QString key = keyOf(*piece, side);
    if (const QPixmap* known = pictures.object(key)) return *known;
    if (failed.contains(key)) return {};
    ask({piece, side, key});
    return {};
  }

  // What a view asks for while it paints goes on together, so that its first picture comes first.
  void ask(Request request) {
    if (batch.empty()) QTimer::singleShot(0, self, [this] { passOn(); });
    batch.push_back(std::move(request));
  }

  void passOn() {
    {
      const std::lock_guard lock(mutex);
      for (; !batch.empty(); batch.pop_back()) {
        Request& request = batch.back();
        const auto same = [&](const Request& r) { return r.key == request.key; };
        if (!asked.contains(request.key)) {
          asked.insert(request.key);
          toRead.push_back(std::move(request));
        } else if (const auto at = std::find_if(toTrace.begin(), toTrace.end(), same); at != toTrace.end()) {
          std::rotate(at, at + 1, toTrace.end());  // asked again: still wanted
        }
      }
      forgetOldest(toRead);
      forgetOldest(toTrace);
      if (!reader.joinable()) reader = std::thread([this] { readAll(); });
    }
    changed.notify_all();
    if (!mayTrace && !delay.isActive()) delay.start();
  }

  void forgetOldest(std::deque<Request>& queue) {
    while (queue.size() > kQueue) {
      asked.remove(queue.front().key);
      queue.pop_front();
    }
  }

  void beginTracing() {
    {
      const std::lock_guard lock(mutex);
      mayTrace = true;
      if (!tracer.joinable()) tracer = std::thread([this] { traceAll(); });
    }
    changed.notify_all();
  }

  std::optional<Request> next(std::deque<Request>& queue, bool waitForTracing) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return stopping || (!queue.empty() && (mayTrace || !waitForTracing)); });
    if (stopping) return std::nullopt;
    Request request = std::move(queue.back());
    queue.pop_back();
    return request;
  }

  std::filesystem::path fileOf(const Request& request) const {
    return folder / (request.key.toStdString() + ".png");
  }

  void readAll() {
    lowerThreadPriority();
    while (auto request = next(toRead, false)) {
      QImage image;
      if (image.load(toQt(fileOf(*request).string())) && image.width() == request->side) {
        give(*request, image.convertToFormat(QImage::Format_RGB32));
        continue;
      }
      {
        const std::lock_guard lock(mutex);
        toTrace.push_back(std::move(*request));
      }
      changed.notify_all();
    }
  }

  void traceAll() {
    lowerThreadPriority();
    std::optional<render::Denoiser> denoiser;
    while (auto request = next(toTrace, true)) {
      if (!denoiser) denoiser.emplace();
      QImage image;
      try {
        image = toQImage(renderThumbnail(*catalog, *request->piece, request->side, stop, &*denoiser));
        saveQuietly(image, fileOf(*request));
      } catch (const Cancelled&) {
        return;
      } catch (const std::exception&) {
        // A damaged model has no picture.
      }
      give(*request, image);
      const std::lock_guard lock(mutex);
      if (toTrace.empty()) denoiser.reset();  // its memory is not small
    }
  }

  void give(const Request& request, const QImage& image) {
    QMetaObject::invokeMethod(
        self,
        [this, key = request.key, id = toQt(request.piece->id), image] {
          asked.remove(key);
          if (image.isNull()) {
            failed.insert(key);
          } else {
            pictures.insert(key, new QPixmap(QPixmap::fromImage(image)));
          }
          emit self->ready(id);
        },
        Qt::QueuedConnection);
  }
};

ThumbnailStore::ThumbnailStore(std::shared_ptr<const Catalog> catalog, QObject* parent,
                               std::filesystem::path folder)
    : QObject(parent), impl_(std::make_unique<Impl>()) {
  impl_->self = this;
  impl_->catalog = std::move(catalog);
  impl_->folder = std::move(folder);
  impl_->delay.setSingleShot(true);
  impl_->delay.setInterval(kDelay);
  connect(&impl_->delay, &QTimer::timeout, this, [this] { impl_->beginTracing(); });
}

ThumbnailStore::~ThumbnailStore() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->stop.cancel();
  impl_->changed.notify_all();
  if (impl_->reader.joinable()) impl_->reader.join();
  if (impl_->tracer.joinable()) impl_->tracer.join();
}

QPixmap ThumbnailStore::thumbnail(const CatalogPiecePtr& piece) { return impl_->find(piece, kSide); }
QPixmap ThumbnailStore::large(const CatalogPiecePtr& piece) { return impl_->find(piece, kLargeSide); }

void ThumbnailStore::setDelay(int milliseconds) { impl_->delay.setInterval(milliseconds); }

}  // namespace idap
