#include "studio/window/home_file.h"

#include <QFileInfo>
#include <cctype>

#include "base/error.h"
#include "catalog/library/own_library.h"
#include "catalog/library/own_models.h"
#include "formats/registry.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

QString nameOf(const std::filesystem::path& file) { return toQt(file.filename().string()); }

// With the models of the user's own furniture, which is not there where the home goes.
Home whole(const Home& home) {
  if (!usesOwnFurniture(home)) return home;
  try {
    return withOwnModels(home, OwnLibrary());
  } catch (const Error&) {
    return home;  // the library is damaged: no reason not to save
  }
}

}  // namespace

HomeFile::HomeFile(Editor& editor, QObject* parent)
    : QObject(parent), editor_(editor), stamp_(std::make_shared<std::optional<Stamp>>()) {}

HomeFile::~HomeFile() {
  delete reading_;
  delete saving_;
}

bool HomeFile::canWrite(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  for (const HomeFormat& format : homeFormats())
    if (format.write &&
        std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
      return true;
  return false;
}

std::optional<HomeFile::Stamp> HomeFile::stampOf(const std::filesystem::path& file) {
  std::error_code error;
  Stamp stamp;
  stamp.time = std::filesystem::last_write_time(file, error);
  if (error) return std::nullopt;
  stamp.size = std::filesystem::file_size(file, error);
  if (error) return std::nullopt;
  return stamp;
}

void HomeFile::open(const std::filesystem::path& file, bool asTemplate) {
  read(file, {}, asTemplate ? std::filesystem::path() : file);
}

void HomeFile::restore(const std::filesystem::path& copy, const std::filesystem::path& original) {
  read(
      copy, [](Document& document) { document.markUnsaved(); }, original);
}

void HomeFile::start(Home home) {
  ++generation_;
  stamped_.clear();
  editor_.open(std::make_unique<Document>(std::move(home)));
}

void HomeFile::read(const std::filesystem::path& file, std::function<void(Document&)> settle,
                    const std::filesystem::path& documentFile) {
  delete std::exchange(reading_, nullptr);  // another one was chosen meanwhile
  auto stamp = std::make_shared<std::optional<Stamp>>();
  reading_ = runInBackground<Opened>(
      this, tr("Reading %1").arg(nameOf(file)),
      [file, documentFile, stamp](const Progress& progress) {
        // Before reading: what changes while it is read is noticed then.
        if (documentFile == file) *stamp = stampOf(file);
        ReadResult result = readHome(file, progress);
        progress.check();
        return Opened{std::make_unique<Document>(std::move(result.home), documentFile),
                      std::move(result.report)};
      },
      [this, file, documentFile, stamp, settle = std::move(settle)](Opened opened) {
        reading_ = nullptr;
        if (settle) settle(*opened.document);
        ++generation_;
        stamped_ = documentFile == file ? file : std::filesystem::path();
        stamp_ = stamp;
        editor_.open(std::move(opened.document));
        emit this->opened(toQt(file.string()), opened.report);
      },
      [this, file](std::exception_ptr error) {
        reading_ = nullptr;
        emit openFailed(toQt(file.string()), errorText(error));
      });
  emit jobStarted(reading_);
}

void HomeFile::save(const std::filesystem::path& file, bool evenIfChanged) {
  Save save{file, editor_.document().snapshot(), evenIfChanged};
  std::erase_if(waiting_, [&file](const Save& other) { return other.file == file; });
  waiting_.push_back(std::move(save));
  if (!saving_) writeNext();
}

void HomeFile::writeNext() {
  if (waiting_.empty()) return;
  Save next = std::move(waiting_.front());
  waiting_.erase(waiting_.begin());
  write(std::move(next));
}

void HomeFile::write(Save save) {
  const std::filesystem::path file = save.file;
  // Shared with the work: a save that waited for the one before sees the stamp that it left.
  const auto known = file == stamped_ ? stamp_ : nullptr;
  auto after = std::make_shared<std::optional<Stamp>>();
  saving_ = new BackgroundJob(
      tr("Saving %1").arg(nameOf(file)),
      [save, known, after](const Progress& progress) {
        if (known && known->has_value() && !save.evenIfChanged) {
          const auto now = stampOf(save.file);
          if (now && *now != **known) throw ChangedOnDisk(save.file.string());
        }
        writeHome(whole(save.snapshot.home), save.file, progress);
        *after = stampOf(save.file);
      },
      [this, file, after, revision = save.snapshot.revision,
       generation = generation_](std::exception_ptr error) {
        saving_ = nullptr;
        if (!error) {
          if (generation == generation_) {
            stamped_ = file;
            stamp_ = after;
            editor_.document().markSaved(file, revision);
          }
          emit saved(toQt(file.string()));
        } else {
          try {
            std::rethrow_exception(error);
          } catch (const ChangedOnDisk&) {
            emit changedOnDisk(toQt(file.string()));
          } catch (...) {
            emit saveFailed(toQt(file.string()), errorText(error));
          }
        }
        if (!saving_) writeNext();
      },
      this);
  // Stopped half way it would leave the old file, which is no reason to lose the new one.
  saving_->setCancellable(false);
  emit jobStarted(saving_);
}

}  // namespace idap
