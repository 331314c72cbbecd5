#include "studio/picture/picture_window.h"

#include <QClipboard>
#include <QDateTime>
#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QSplitter>
#include <QStandardPaths>
#include <QToolButton>

#include "model/edits/lamp_edits.h"
#include "model/edits/picture_edits.h"
#include "pictures/picture_kind.h"
#include "render/film/develop.h"
#include "render/film/exposure.h"
#include "render/film/light_mix.h"
#include "render/film/picture_file.h"
#include "studio/picture/compare_view.h"
#include "studio/picture/gallery_list.h"
#include "studio/picture/job_list.h"
#include "studio/picture/light_mixer.h"
#include "studio/picture/picture_form.h"
#include "studio/picture/picture_queue.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/images.h"
#include "studio/widgets/texts.h"

namespace idap {

struct PictureWindow::Impl {
  PictureWindow& window;
  Editor& editor;
  int subscription = 0;
  PictureQueue queue;
  PictureForm* form = nullptr;
  CompareView* view = nullptr;
  JobList* jobs = nullptr;
  GalleryList* gallery = nullptr;
  LightMixer* mixer = nullptr;
  QLabel *galleryTitle = nullptr, *facts = nullptr;
  QToolButton *save = nullptr, *copy = nullptr, *again = nullptr, *compare = nullptr, *mix = nullptr,
              *rename = nullptr, *remove = nullptr;
  int looking = 0;                     // the job whose preview is shown; 0: a picture of the gallery
  std::map<int, PictureId> madeAgain;  // job -> the picture that it is the new one of

  Impl(PictureWindow& w, Editor& e) : window(w), editor(e), queue(e) {}
  void build();
  void connectParts();
  void retranslate();
  void enable();
  const Picture* find(PictureId id) const { return editor.home().pictures.find(id); }
  QImage imageOf(PictureId id) const;
  void show(PictureId id);
  void begin();
  void makeAgain();
  void askFile();
  void chooseOther();
  void compareWith(PictureId other);
  void mixCurrent();
  void keepMix();
  void takeMixOver();
};

void PictureWindow::Impl::build() {
  form = new PictureForm(editor);
  view = new CompareView;
  view->setObjectName(QStringLiteral("pictureView"));
  jobs = new JobList(queue);
  gallery = new GalleryList(editor);
  gallery->setObjectName(QStringLiteral("gallery"));
  galleryTitle = new QLabel;
  facts = new QLabel;
  facts->setForegroundRole(QPalette::PlaceholderText);
  facts->setMinimumWidth(1);
  facts->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  save = toolButton("save", "savePicture", &window);
  copy = toolButton("copy", "copyPicture", &window);
  again = toolButton("refresh", "makeAgain", &window);
  compare = toolButton("flip-horizontally", "comparePicture", &window);
  mix = toolButton("lamp", "mixPicture", &window);
  mix->setCheckable(true);
  rename = toolButton("text", "renamePicture", &window);
  remove = toolButton("delete", "removePicture", &window);
  auto* bar = new QHBoxLayout;
  bar->addStretch();
  for (QToolButton* button : {again, mix, compare, save, copy, rename, remove}) {
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->addWidget(button);
  }
  auto* right = new QWidget;
  auto* column = new QVBoxLayout(right);
  column->addWidget(view, 1);
  column->addLayout(bar);
  column->addWidget(jobs);
  auto* titleRow = new QHBoxLayout;
  titleRow->addWidget(galleryTitle);
  titleRow->addWidget(facts, 1);
  column->addLayout(titleRow);
  column->addWidget(gallery);
  auto* splitter = new QSplitter(&window);
  splitter->addWidget(form);
  splitter->addWidget(right);
  mixer = new LightMixer;
  mixer->hide();
  splitter->addWidget(mixer);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  auto* all = new QVBoxLayout(&window);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(splitter);
}

void PictureWindow::Impl::connectParts() {
  connect(form, &PictureForm::requested, &window, [this] { begin(); });
  connect(&queue, &PictureQueue::previewed, &window, [this](int id) {
    if (id != looking) return;
    const PictureQueue::Job* job = queue.find(id);
    const Picture* old = madeAgain.contains(id) ? find(madeAgain[id]) : nullptr;
    if (old)
      view->compare(imageOf(madeAgain[id]), GalleryList::nameOf(*old), job->preview, tr("Now"));
    else
      view->show(job->preview, toQt(job->name));
  });
  connect(&queue, &PictureQueue::kept, &window, [this](int job, PictureId picture) {
    const auto was = madeAgain.find(job);
    const bool watched = looking == job || view->picture().isNull();
    if (watched) {
      looking = 0;
      gallery->setCurrent(picture);
      show(picture);
      if (was != madeAgain.end() && find(was->second)) compareWith(was->second);
    }
    if (was != madeAgain.end()) madeAgain.erase(was);
  });
  connect(&queue, &PictureQueue::changed, &window, [this] {
    // The next one is worth watching when the one that was looked at is done.
    if (looking != 0 && !queue.find(looking) && !queue.jobs().empty()) looking = queue.jobs().front().id;
  });
  connect(&queue, &PictureQueue::failed, &window, [this](const QString& why) {
    editor.say(Text(QT_TRANSLATE_NOOP("idap", "The picture could not be made: %1"), {fromQt(why)}),
               Editor::Severity::Error);
  });
  connect(jobs, &JobList::looked, &window, [this](int id) {
    looking = id;
    if (const PictureQueue::Job* job = queue.find(id); job && !job->preview.isNull())
      view->show(job->preview, toQt(job->name));
  });
  connect(gallery, &GalleryList::chosen, &window, [this](PictureId id) {
    looking = 0;
    show(id);
  });
  connect(gallery, &GalleryList::renamed, &window, [this](PictureId id, const QString& name) {
    editor.document().amend([&](const Home& home) { return renamePicture(home, id, fromQt(name)); });
  });
  connect(again, &QToolButton::clicked, &window, [this] { makeAgain(); });
  connect(save, &QToolButton::clicked, &window, [this] { askFile(); });
  connect(copy, &QToolButton::clicked, &window,
          [this] { QApplication::clipboard()->setImage(imageOf(gallery->current())); });
  connect(mix, &QToolButton::toggled, &window, [this](bool on) {
    mixer->setVisible(on);
    if (on)
      mixCurrent();
    else
      show(gallery->current());
  });
  connect(mixer, &LightMixer::previewed, &window, [this](const QImage& picture) {
    const Picture* mixed = find(gallery->current());
    if (mix->isChecked() && mixed && looking == 0) view->show(picture, GalleryList::nameOf(*mixed));
  });
  connect(mixer, &LightMixer::keepAsked, &window, [this] { keepMix(); });
  connect(mixer, &LightMixer::takeOverAsked, &window, [this] { takeMixOver(); });
  connect(mixer, &LightMixer::failed, &window, [this](const QString& why) {
    editor.say(Text(QT_TRANSLATE_NOOP("idap", "The lights cannot be mixed: %1"), {fromQt(why)}),
               Editor::Severity::Error);
  });
  connect(rename, &QToolButton::clicked, &window, [this] {
    if (gallery->currentItem()) gallery->editItem(gallery->currentItem());
  });
  connect(compare, &QToolButton::clicked, &window, [this] { chooseOther(); });
  connect(remove, &QToolButton::clicked, &window, [this] {
    const PictureId id = gallery->current();
    editor.apply(QT_TRANSLATE_NOOP("idap", "Delete picture"),
                 [id](const Home& home) { return removePicture(home, id); });
  });
  subscription = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document) {
      looking = 0;
      madeAgain.clear();
      view->show({}, {});
    }
    if (change == Editor::Change::Document || change == Editor::Change::Home) {
      if (looking == 0 && !find(gallery->current()) && !view->comparing()) view->show({}, {});
      enable();
    }
  }});
}

void PictureWindow::Impl::retranslate() {
  window.setWindowTitle(tr("Pictures"));
  galleryTitle->setText(tr("Gallery of the home"));
  const auto name = [](QToolButton* button, const QString& words, const QString& tip) {
    button->setText(words);
    button->setToolTip(tip);
  };
  name(again, tr("A&gain"), tr("Makes this picture again, of the home as it is now, and compares the two"));
  name(mix, tr("&Light"),
       tr("Dims, recolours and switches the lights of this picture without making it again"));
  name(compare, tr("&Compare"), tr("Lays another picture beside this one, with a divider to drag"));
  name(save, tr("&Save…"),
       tr("As PNG, JPEG, PCX or GIF; as OpenEXR while the program runs in which it was made"));
  name(copy, tr("Cop&y"), tr("Into the clipboard"));
  name(rename, tr("Rena&me"), tr("Gives this picture another name (F2)"));
  name(remove, tr("&Delete"), tr("Takes this picture out of the gallery; can be undone"));
  enable();
}

void PictureWindow::Impl::enable() {
  const Picture* picture = find(gallery->current());
  for (QToolButton* button : {again, mix, save, copy, rename, remove}) button->setEnabled(picture != nullptr);
  compare->setEnabled(picture && editor.home().pictures.size() > 1);
  facts->setText(picture ? GalleryList::describe(*picture).replace(QLatin1Char('\n'), QStringLiteral(" · "))
                         : QString());
}

QImage PictureWindow::Impl::imageOf(PictureId id) const {
  const Picture* picture = find(id);
  if (!picture) return {};
  const auto file = editor.home().assets->find(picture->asset);
  if (file == editor.home().assets->end()) return {};
  return QImage::fromData(reinterpret_cast<const uchar*>(file->second->data()),
                          int(std::min<std::size_t>(file->second->size(), INT_MAX)));
}

void PictureWindow::Impl::show(PictureId id) {
  if (const Picture* picture = find(id)) view->show(imageOf(id), GalleryList::nameOf(*picture));
  enable();
  if (mix->isChecked()) mixCurrent();
}

void PictureWindow::Impl::mixCurrent() { mixer->setFilm(queue.filmOf(gallery->current())); }

// At full size, denoised, as bright and as white as the picture was.
void PictureWindow::Impl::keepMix() {
  const Picture* picture = find(gallery->current());
  const auto film = mixer->film();
  if (!picture || !film) return;
  Picture kept = *picture;
  kept.name = fromQt(tr("%1, other light").arg(GalleryList::nameOf(*picture)));
  kept.made = QDateTime::currentMSecsSinceEpoch();
  const std::uint64_t ofHome = reinterpret_cast<std::uintptr_t>(&editor.document());
  runInBackground<Bytes>(
      &window, tr("Keeping the mix"),
      [film, changes = mixer->changes()](const Progress& progress) {
        render::DevelopSettings settings = film->look;
        settings.progress = &progress;
        settings.ev = render::autoExposure(film->film);
        settings.illuminant = render::estimateIlluminant(film->film);
        const render::Film mixed = render::mixed(film->film, film->lightGroups, changes);
        return render::encodePicture(render::develop(mixed, settings), "png");
      },
      [this, kept, ofHome](Bytes png) {
        if (ofHome != reinterpret_cast<std::uintptr_t>(&editor.document())) return;
        const PictureId id{editor.document().freeId()};
        const auto bytes = std::make_shared<const Bytes>(std::move(png));
        editor.document().amend([&](const Home& home) { return addPicture(home, id, kept, bytes); });
        mix->setChecked(false);
        gallery->setCurrent(id);
        show(id);
      },
      [this](std::exception_ptr error) {
        if (const QString why = errorText(error); !why.isEmpty()) emit mixer->failed(why);
      });
}

void PictureWindow::Impl::takeMixOver() {
  const std::vector<LampChange> changes = mixer->lampChanges();
  editor.apply(QT_TRANSLATE_NOOP("idap", "Change lamps"),
               [&changes](const Home& home) { return withLampsChanged(home, changes); });
  editor.say(Text(QT_TRANSLATE_NOOP("idap", "The lamps of the home are as in the picture now"), {}),
             Editor::Severity::Note);
}

void PictureWindow::Impl::begin() {
  int first = 0;
  for (const PictureForm::Wanted& wanted : form->wanted()) {
    const int id = queue.add(wanted.name, wanted.settings);
    if (!first) first = id;
  }
  if (first && !queue.find(looking)) {
    looking = first;
    gallery->setCurrentItem(nullptr);
    view->show({}, {});
    enable();
  }
}

void PictureWindow::Impl::makeAgain() {
  const PictureId id = gallery->current();
  const Picture* picture = find(id);
  if (!picture) return;
  const int job = queue.add(picture->name, picture->settings);
  madeAgain[job] = id;
  looking = job;
}

void PictureWindow::Impl::chooseOther() {
  auto* menu = new QMenu(&window);
  menu->setObjectName(QStringLiteral("compareMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  for (int i = 0; i < gallery->count(); ++i) {
    const QListWidgetItem& item = *gallery->item(i);
    const PictureId other{item.data(Qt::UserRole).toULongLong()};
    if (other == gallery->current()) continue;
    menu->addAction(item.icon(), item.text(), &window, [this, other] { compareWith(other); });
  }
  menu->popup(compare->mapToGlobal(QPoint(0, compare->height())));
}

// The other one left, as it is mostly the one from before.
void PictureWindow::Impl::compareWith(PictureId other) {
  const PictureId id = gallery->current();
  const Picture *left = find(other), *right = find(id);
  if (!left || !right) return;
  QString leftName = GalleryList::nameOf(*left), rightName = GalleryList::nameOf(*right);
  if (leftName == rightName) leftName = tr("%1, before").arg(leftName);
  view->compare(imageOf(other), leftName, imageOf(id), rightName);
  view->setFocus(Qt::OtherFocusReason);
}

void PictureWindow::Impl::askFile() {
  const PictureId id = gallery->current();
  const Picture* picture = find(id);
  if (!picture) return;
  const std::filesystem::path document = editor.document().file();
  const QString folder = document.empty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
                                          : toQt(document.parent_path().string());
  auto* dialog = new QFileDialog(&window, tr("Save picture"), folder);
  dialog->setObjectName(QStringLiteral("savePictureDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  QStringList filters;
  for (const PictureKindInfo& info : pictureKinds())
    if (info.kind != PictureKind::Exr || queue.filmOf(id))
      filters << QStringLiteral("%1 (*%2)").arg(translated(info.name), QLatin1String(info.extension));
  dialog->setNameFilters(filters);
  dialog->setDefaultSuffix(QStringLiteral("png"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.mid(filter.lastIndexOf(QLatin1Char('.')) + 1, 3));
  });
  QString name = GalleryList::nameOf(*picture);
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  dialog->selectFile(name + QStringLiteral(".png"));
  connect(dialog, &QFileDialog::fileSelected, &window,
          [this, id](const QString& file) { window.savePicture(id, file); });
  dialog->open();
}

PictureWindow::PictureWindow(Editor& editor, QWidget* parent)
    : QWidget(parent, Qt::Window), impl_(std::make_unique<Impl>(*this, editor)) {
  setObjectName(QStringLiteral("pictureWindow"));
  impl_->build();
  impl_->connectParts();
  impl_->retranslate();
  const int em = fontMetrics().height();
  resize(66 * em, 46 * em);
}

PictureWindow::~PictureWindow() { impl_->editor.unsubscribe(impl_->subscription); }

PictureForm& PictureWindow::form() { return *impl_->form; }
PictureQueue& PictureWindow::queue() { return impl_->queue; }

void PictureWindow::lookAt(PictureId picture) {
  impl_->gallery->setCurrent(picture);
  impl_->show(picture);
}

void PictureWindow::savePicture(PictureId id, const QString& file) {
  Editor& editor = impl_->editor;
  const std::filesystem::path path = fromQt(file);
  const auto kind = pictureKindOf(path);
  const auto film = impl_->queue.filmOf(id);
  const auto fail = [&editor](const std::string& why) {
    editor.say(Text(QT_TRANSLATE_NOOP("idap", "The picture was not saved: %1"), {why}),
               Editor::Severity::Error);
  };
  if (!kind) return fail(fromQt(tr("%1 should end in .png, .jpg, .pcx, .gif or .exr").arg(file)));
  if (*kind == PictureKind::Exr && !film)
    return fail(fromQt(tr("an OpenEXR file needs the light it was made of; make the picture again first")));
  const QImage image = impl_->imageOf(id);
  new BackgroundJob(
      tr("Saving the picture"),
      [image, path, film, kind](const Progress&) {
        if (*kind == PictureKind::Exr)
          writeFilm(path, film->film, film->lightGroups);
        else
          writePicture(path, *kind, toImage8(image));
      },
      [&editor, fail, path](std::exception_ptr error) {
        if (error)
          fail(fromQt(errorText(error)));
        else
          editor.say(Text(QT_TRANSLATE_NOOP("idap", "Picture saved as %1"), {path.string()}));
      },
      this);
}

void PictureWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
}

}  // namespace idap
