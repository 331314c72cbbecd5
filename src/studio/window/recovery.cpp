#include "studio/window/recovery.h"

#include <QDateTime>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QLockFile>
#include <QTimer>
#include <QUuid>

#include "base/file.h"
#include "formats/registry.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace fs = std::filesystem;

namespace {

fs::path with(const fs::path& base, const char* extension) { return fs::path(base) += extension; }

void removeFiles(const fs::path& base) {
  std::error_code ignored;
  for (const char* extension : {".idap", ".json"}) fs::remove(with(base, extension), ignored);
}

std::unique_ptr<QLockFile> lockOf(const fs::path& base) {
  auto lock = std::make_unique<QLockFile>(toQt(with(base, ".lock").string()));
  lock->setStaleLockTime(0);  // stale only when its program is gone
  return lock;
}

}  // namespace

fs::path Recovery::folder() { return userDataFolder() / "recovery"; }

Recovery::Recovery(Editor& editor, QObject* parent)
    : QObject(parent), editor_(editor), timer_(new QTimer(this)) {
  base_ = folder() / QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  connect(timer_, &QTimer::timeout, this, &Recovery::keep);
  timer_->start(kSeconds * 1000);
}

Recovery::~Recovery() {
  delete writing_;
  removeFiles(base_);
}

void Recovery::keep() {
  const Document& document = editor_.document();
  if (writing_) return;
  if (!document.modified()) return drop();
  Document::Snapshot snapshot = document.snapshot();
  if (kept_ && snapshot.revision == keptRevision_) return;
  if (!lock_) {
    std::error_code ignored;
    fs::create_directories(folder(), ignored);
    lock_ = lockOf(base_);
    lock_->tryLock(0);
  }
  QJsonObject about;
  about[QStringLiteral("original")] = toQt(document.file().string());
  about[QStringLiteral("time")] = QDateTime::currentDateTime().toString(Qt::ISODate);
  const std::string json = QJsonDocument(about).toJson().toStdString();
  const auto revision = snapshot.revision;
  writing_ = new BackgroundJob(
      tr("Keeping a copy"),
      [home = std::move(snapshot.home), base = base_, json](const Progress& progress) {
        writeHome(home, with(base, ".idap"), progress);
        writeFileAtomically(with(base, ".json"), std::as_bytes(std::span(json)));
      },
      [this, revision](std::exception_ptr error) {
        writing_ = nullptr;
        if (!error) {
          kept_ = true;
          keptRevision_ = revision;
          emit kept();
          if (!editor_.document().modified()) drop();  // saved meanwhile
        } else if (!std::exchange(told_, true)) {
          emit failed(errorText(error));
        }
      },
      this);
}

void Recovery::drop() {
  delete std::exchange(writing_, nullptr);
  if (kept_ || lock_) removeFiles(base_);
  kept_ = false;
  if (lock_) lock_->unlock();
  lock_.reset();
}

std::vector<Recovery::Found> Recovery::findLeft() {
  std::vector<Found> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder(), error)) {
    if (entry.path().extension() != ".json") continue;
    const fs::path base = fs::path(entry.path()).replace_extension();
    std::error_code ignored;
    if (base == base_ || !fs::exists(with(base, ".idap"), ignored)) continue;
    auto lock = lockOf(base);
    if (!lock->tryLock(0)) continue;  // its program runs, or another window has found it
    QJsonObject about;
    try {
      const Bytes bytes = readFile(entry.path(), 1 << 20);
      const std::string_view text = asText(bytes);
      about = QJsonDocument::fromJson(QByteArray(text.data(), qsizetype(text.size()))).object();
    } catch (const Error&) {
      continue;
    }
    Found one;
    one.copy = with(base, ".idap");
    one.original = about[QStringLiteral("original")].toString().toStdString();
    one.time = QLocale().toString(
        QDateTime::fromString(about[QStringLiteral("time")].toString(), Qt::ISODate), QLocale::ShortFormat);
    found.push_back(std::move(one));
    claimed_.push_back(std::move(lock));
  }
  return found;
}

void Recovery::remove(const Found& found) { removeFiles(fs::path(found.copy).replace_extension()); }

}  // namespace idap
