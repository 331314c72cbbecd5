#include "studio/window/file_flow.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QTimeZone>
#include <numbers>

#include "formats/registry.h"
#include "model/edits/arrange_edits.h"
#include "model/edits/piece_edits.h"
#include "studio/widgets/texts.h"
#include "studio/window/dialogs/cities.h"

namespace idap {

namespace {

constexpr std::size_t kMessages = 50;  // of one report: more are counted

std::filesystem::path pathOf(const QString& file) { return fromQt(file); }

QString withExtension(const QString& file) {
  return HomeFile::canWrite(pathOf(file)) ? file : file + QStringLiteral(".idap");
}

QString filters() {
  QString all, each;
  for (const HomeFormat& format : homeFormats()) {
    if (!format.read) continue;
    QString patterns;
    for (const std::string& extension : format.extensions)
      patterns += QStringLiteral(" *.") + toQt(extension);
    all += patterns;
    each += QStringLiteral(";;") + toQt(format.name) + QStringLiteral(" (") + patterns.trimmed() +
            QStringLiteral(")");
  }
  return FileFlow::tr("Homes") + QStringLiteral(" (") + all.trimmed() + QStringLiteral(")") + each;
}

// The town that this machine's time zone is named after, at eleven on midsummer's day.
void placeWhereThisMachineIs(Site& site) {
  const QTimeZone zone = QTimeZone::systemTimeZone();
  for (const City& city : cities()) {
    if (zone.id() != city.timeZone || !zone.id().endsWith(QByteArray(city.name).replace(' ', '_'))) continue;
    site.latitude = city.latitude * std::numbers::pi / 180;
    site.longitude = city.longitude * std::numbers::pi / 180;
    site.timeZone = city.timeZone;
    const QDate midsummer(QDate::currentDate().year(), city.latitude < 0 ? 12 : 6, 21);
    site.time = QDateTime(midsummer, QTime(11, 0), zone).toMSecsSinceEpoch();
  }
}

}  // namespace

FileFlow::FileFlow(Editor& editor, Preferences& preferences, QWidget* window)
    : QObject(window),
      editor_(editor),
      preferences_(preferences),
      window_(window),
      file_(editor),
      recovery_(editor) {
  connect(&file_, &HomeFile::jobStarted, this, &FileFlow::jobStarted);
  connect(&file_, &HomeFile::opened, this, [this](const QString& file, const ImportReport& what) {
    recovery_.drop();
    setOpen(true);
    const bool ofFile = !editor_.document().file().empty();
    if (ofFile) preferences_.addRecent(toQt(editor_.document().file().string()));
    report(file, what);
    emit titleChanged();
  });
  connect(&file_, &HomeFile::openFailed, this, [this](const QString& file, const QString& reason) {
    emit titleChanged();
    if (reason.isEmpty()) return;  // the user stopped it
    preferences_.removeRecent(QFileInfo(file).exists() ? QString() : file);
    editor_.say({QT_TRANSLATE_NOOP("idap", "%1 could not be opened: %2"), {fromQt(file), fromQt(reason)}},
                Editor::Severity::Error);
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Open"),
                                tr("“%1” could not be opened.").arg(QFileInfo(file).fileName()),
                                QMessageBox::Ok, window_);
    box->setInformativeText(reason);
    ask(box, {});
  });
  connect(&file_, &HomeFile::saved, this, [this](const QString& file) {
    preferences_.addRecent(file);
    if (!editor_.document().modified()) recovery_.drop();
    editor_.say({QT_TRANSLATE_NOOP("idap", "Saved %1"), {fromQt(QDir::toNativeSeparators(file))}});
    emit savedTo(file);
    emit titleChanged();
    afterSave(true);
  });
  connect(&file_, &HomeFile::saveFailed, this, [this](const QString& file, const QString& reason) {
    editor_.say({QT_TRANSLATE_NOOP("idap", "%1 could not be saved: %2"), {fromQt(file), fromQt(reason)}},
                Editor::Severity::Error);
    afterSave(false);
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Save"),
                                tr("“%1” could not be saved.").arg(QFileInfo(file).fileName()),
                                QMessageBox::Cancel, window_);
    box->setObjectName(QStringLiteral("saveFailed"));
    box->setInformativeText(reason + QStringLiteral("\n\n") +
                            tr("Your work is still open here and nothing of it is lost. Save it in another "
                               "place, or free some space "
                               "and try again."));
    QPushButton* elsewhere = box->addButton(tr("Save &as…"), QMessageBox::AcceptRole);
    QPushButton* again = box->addButton(tr("&Try again"), QMessageBox::ActionRole);
    box->setDefaultButton(elsewhere);
    ask(box, [this, box, elsewhere, again, file](int) {
      if (box->clickedButton() == elsewhere) saveAs();
      if (box->clickedButton() == again) saveTo(file);
    });
  });
  connect(&file_, &HomeFile::changedOnDisk, this, [this](const QString& file) {
    const auto then = std::exchange(afterSave_, {});
    auto* box = new QMessageBox(
        QMessageBox::Warning, tr("Save"),
        tr("“%1” was changed by another program since you opened it.").arg(QFileInfo(file).fileName()),
        QMessageBox::Cancel, window_);
    box->setObjectName(QStringLiteral("changedOnDisk"));
    box->setInformativeText(tr("Saving here would replace those changes with yours."));
    QPushButton* elsewhere = box->addButton(tr("Save &as…"), QMessageBox::AcceptRole);
    QPushButton* replace = box->addButton(tr("&Replace"), QMessageBox::DestructiveRole);
    box->setDefaultButton(elsewhere);
    ask(box, [this, box, elsewhere, replace, file, then](int) {
      if (box->clickedButton() == elsewhere) {
        afterSave_ = then;
        saveAs();
      } else if (box->clickedButton() == replace) {
        afterSave_ = then;
        saveTo(file, true);
      }
    });
  });
  connect(&recovery_, &Recovery::failed, this, [this](const QString& reason) {
    editor_.say({QT_TRANSLATE_NOOP("idap", "No safety copy of this home can be kept: %1"), {fromQt(reason)}},
                Editor::Severity::Warning);
  });
}

void FileFlow::setOpen(bool open) {
  open_ = open;
  emit openChanged();
}

QString FileFlow::title() const {
  const auto& file = editor_.document().file();
  return file.empty() ? tr("New home") : toQt(file.stem().string());
}

void FileFlow::newRoom(double x, double y, double z) {
  whenSafe([this, x, y, z] {
    recovery_.drop();
    Home home = makeRoomHome(x, y, z, preferences_.editor().wallThickness, fromQt(tr("Room")));
    placeWhereThisMachineIs(home.site);
    file_.start(std::move(home));
    setOpen(true);
    emit titleChanged();
    emit newHome();
  });
}

void FileFlow::startFromTemplate(const QString& file) {
  whenSafe([this, file] { file_.open(pathOf(file), true); });
}

void FileFlow::openDialog() {
  auto* dialog = new QFileDialog(window_, tr("Open a home"), preferences_.lastFolder(), filters());
  dialog->setObjectName(QStringLiteral("openDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &FileFlow::open);
  dialog->open();
}

void FileFlow::open(const QString& file) {
  const QString absolute = QFileInfo(file).absoluteFilePath();
  whenSafe([this, absolute] {
    preferences_.setLastFolder(QFileInfo(absolute).path());
    file_.open(pathOf(absolute));
  });
}

void FileFlow::report(const QString& file, const ImportReport& what) {
  std::size_t told = 0;
  for (const ImportReport::Entry& entry : what.entries) {
    if (++told > kMessages) break;
    editor_.say({entry.count > 1 ? QT_TRANSLATE_NOOP("idap", "%1: %2 (%3 times)") : "%1: %2",
                 {entry.place, entry.what, std::to_string(entry.count)}},
                Editor::Severity::Warning);
  }
  if (what.entries.size() > kMessages)
    editor_.say({QT_TRANSLATE_NOOP("idap", "… and %1 more of the kind"),
                 {std::to_string(what.entries.size() - kMessages)}},
                Editor::Severity::Warning);
  const std::string name = fromQt(QFileInfo(file).fileName());
  if (what.empty())
    editor_.say({QT_TRANSLATE_NOOP("idap", "Opened %1"), {name}});
  else
    editor_.say(
        {QT_TRANSLATE_NOOP("idap", "Opened %1; some of it had to be mended or left out: see the messages"),
         {name}},
        Editor::Severity::Warning);
}

void FileFlow::save() {
  const auto& file = editor_.document().file();
  if (file.empty()) return saveAsDialog({});
  if (!HomeFile::canWrite(file))
    return saveAsDialog(
        tr("“%1” cannot be written in its own format, so the home is saved as an IDAP home beside it. "
           "The original stays as it is.")
            .arg(toQt(file.filename().string())));
  saveTo(toQt(file.string()));
}

void FileFlow::saveAs() { saveAsDialog({}); }

void FileFlow::saveAsDialog(const QString& why) {
  if (!why.isEmpty()) editor_.say(Text("%1", {fromQt(why)}));
  const auto& file = editor_.document().file();
  const QString folder = file.empty() ? preferences_.lastFolder() : toQt(file.parent_path().string());
  auto* dialog = new QFileDialog(window_, why.isEmpty() ? tr("Save the home as") : why, folder,
                                 tr("IDAP homes") + QStringLiteral(" (*.idap)"));
  dialog->setObjectName(QStringLiteral("saveDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("idap"));
  dialog->selectFile(title() + QStringLiteral(".idap"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
    preferences_.setLastFolder(QFileInfo(chosen).path());
    saveTo(withExtension(chosen), true);  // the dialog has asked about a file that is there
  });
  connect(dialog, &QDialog::rejected, this, [this] { afterSave(false); });
  dialog->open();
}

void FileFlow::saveTo(const QString& file, bool evenIfChanged) { file_.save(pathOf(file), evenIfChanged); }

void FileFlow::saveCompact() {
  auto* dialog = new QFileDialog(window_, tr("Save a compact copy"), preferences_.lastFolder(),
                                 tr("IDAP homes") + QStringLiteral(" (*.idap)"));
  dialog->setObjectName(QStringLiteral("compactDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("idap"));
  dialog->selectFile(title() + QStringLiteral("-") + tr("compact") + QStringLiteral(".idap"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& chosen) {
    const std::filesystem::path target = pathOf(withExtension(chosen));
    auto* job = new BackgroundJob(
        tr("Saving %1").arg(QFileInfo(chosen).fileName()),
        [home = editor_.document().snapshot().home, target](const Progress& progress) {
          writeHome(withoutUnusedAssets(home), target, progress);
        },
        [this, target](std::exception_ptr error) {
          const std::string file = target.string();
          if (const QString reason = errorText(error); !reason.isEmpty())
            editor_.say({QT_TRANSLATE_NOOP("idap", "%1 could not be saved: %2"), {file, fromQt(reason)}},
                        Editor::Severity::Error);
          else if (!error)
            editor_.say({QT_TRANSLATE_NOOP("idap", "Saved a compact copy as %1"), {file}});
        },
        this);
    emit jobStarted(job);
  });
  dialog->open();
}

void FileFlow::closeHome() {
  whenSafe([this] {
    recovery_.drop();
    file_.start({});
    setOpen(false);
    emit titleChanged();
  });
}

bool FileFlow::safe() const {
  return !question_ && !file_.saving() && (!open_ || !editor_.document().modified());
}

void FileFlow::whenSafe(std::function<void()> then) {
  if (question_) return question_->raise();
  if (file_.saving()) {  // its end says whether anything is left to ask
    afterSave_ = [this, then = std::move(then)] { whenSafe(then); };
    return;
  }
  if (safe()) return then();
  auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                              tr("Save the changes to “%1”?").arg(title()),
                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
  box->setObjectName(QStringLiteral("askToSave"));
  box->setInformativeText(tr("Without saving, what you did since the last time is lost."));
  box->setDefaultButton(QMessageBox::Save);
  ask(box, [this, then = std::move(then)](int button) {
    if (button == QMessageBox::Discard) {
      recovery_.drop();
      then();
    } else if (button == QMessageBox::Save) {
      afterSave_ = [this, then] { whenSafe(then); };  // edits made meanwhile are asked about again
      save();
    }
  });
}

void FileFlow::afterSave(bool saved) {
  if (file_.saving()) return;
  const auto then = std::exchange(afterSave_, {});
  // Out of the signal of the save: what follows may close the window.
  if (then && saved) QMetaObject::invokeMethod(this, then, Qt::QueuedConnection);
}

void FileFlow::offerRestore() {
  if (!std::exchange(looked_, true)) left_ = recovery_.findLeft();
  if (left_.empty() || open_) return;
  const Recovery::Found last = left_.back();
  left_.pop_back();
  const QString name = last.original.empty() ? tr("a new home") : toQt(last.original.filename().string());
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("Restore"),
      tr("The program did not end in order last time. A copy of %1 from %2 is there.").arg(name, last.time),
      QMessageBox::NoButton, window_);
  box->setObjectName(QStringLiteral("askToRestore"));
  box->setInformativeText(tr("Restored, it opens as unsaved work; the file itself is not touched."));
  QPushButton* restore = box->addButton(tr("&Restore"), QMessageBox::AcceptRole);
  QPushButton* discard = box->addButton(tr("&Throw away"), QMessageBox::DestructiveRole);
  QPushButton* later = box->addButton(tr("Ask &later"), QMessageBox::RejectRole);
  box->setDefaultButton(restore);
  box->setEscapeButton(later);
  ask(box, [this, box, restore, discard, last](int) {
    if (box->clickedButton() == discard) {
      Recovery::remove(last);
      QMetaObject::invokeMethod(this, &FileFlow::offerRestore, Qt::QueuedConnection);
    } else if (box->clickedButton() == restore) {
      file_.restore(last.copy, last.original);
      // The old copy goes when the window has one of its own.
      connect(&file_, &HomeFile::opened, &recovery_, &Recovery::keep, Qt::SingleShotConnection);
      connect(
          &recovery_, &Recovery::kept, this, [last] { Recovery::remove(last); }, Qt::SingleShotConnection);
    }
  });
}

void FileFlow::ask(QMessageBox* box, std::function<void(int button)> answered) {
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setWindowModality(Qt::WindowModal);
  question_ = box;
  connect(box, &QMessageBox::finished, this, [this, box, answered = std::move(answered)](int button) {
    question_ = nullptr;
    if (answered)
      answered(box->standardButton(box->clickedButton()) ? box->standardButton(box->clickedButton())
                                                         : button);
  });
  box->open();
}

}  // namespace idap
