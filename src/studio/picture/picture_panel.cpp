#include "studio/picture/picture_panel.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QDateTime>
#include <QFileDialog>
#include <QFrame>
#include <QLocale>
#include <QProgressBar>
#include <QStandardPaths>
#include <QToolButton>
#include <cmath>

#include "light/civil_time.h"
#include "model/edits/picture_edits.h"
#include "render/film/picture_file.h"
#include "studio/picture/picture_canvas.h"
#include "studio/picture/picture_worker.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/images.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kGap = 6;
constexpr CameraId kHere{~0ull};  // of the list: where the live view stands

}  // namespace

struct PicturePanel::Impl {
  PicturePanel& panel;
  Editor& editor;
  int subscription = 0;

  QComboBox* camera = nullptr;
  QLabel* time = nullptr;
  QToolButton *trace = nullptr, *stop = nullptr, *save = nullptr, *maximise = nullptr, *close = nullptr;
  PictureCanvas* canvas = nullptr;
  QWidget* empty = nullptr;  // what the canvas shows before the first picture
  QLabel *emptyDrawing = nullptr, *emptyTitle = nullptr, *emptyText = nullptr;
  QPushButton* begin = nullptr;
  QPushButton* note = nullptr;  // the home has changed since
  QFrame* progressRow = nullptr;
  QProgressBar* progress = nullptr;
  QLabel* left = nullptr;
  PictureWorker worker;

  CameraId chosen;
  std::optional<Camera> place;  // where the live view stood last
  bool byUser = false;          // chosen since then
  std::optional<Home> traced;   // what the picture shows
  int samples = 64;
  double seconds = 20;
  double secondsLeft = -1;

  Impl(PicturePanel& p, Editor& e) : panel(p), editor(e) {}

  void build();
  void retranslate();
  void listCameras();
  void showTime();
  void showTimeLeft();
  void showState();
  void drawEmpty();
  void fitEmpty();
  void forget();
  const Camera* chosenCamera() const {
    if (chosen == kHere) return place ? &*place : nullptr;
    return chosen == CameraId{} ? nullptr : editor.home().cameras.find(chosen);
  }
};

void PicturePanel::Impl::build() {
  camera = new QComboBox(&panel);
  camera->setObjectName(QStringLiteral("camera"));
  camera->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  camera->setMinimumContentsLength(10);
  camera->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  camera->setMaximumWidth(panel.fontMetrics().averageCharWidth() * 36);
  time = new QLabel(&panel);
  time->setObjectName(QStringLiteral("time"));
  time->setForegroundRole(QPalette::PlaceholderText);
  trace = toolButton("ray-trace", "rayTrace", &panel);
  stop = toolButton("stop", "stop", &panel);
  save = toolButton("save", "savePicture", &panel);
  maximise = toolButton("maximise", "maximise", &panel);
  close = toolButton("close", "backToLive", &panel);

  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(kGap, kGap / 2, kGap / 2, kGap / 2);
  bar->setSpacing(kGap);
  bar->addWidget(camera, 1);
  bar->addWidget(time);
  bar->addStretch();
  for (QToolButton* button : {trace, stop, save, maximise, close}) bar->addWidget(button);

  canvas = new PictureCanvas(&panel);
  canvas->setObjectName(QStringLiteral("canvas"));

  empty = new QWidget(canvas);
  empty->setObjectName(QStringLiteral("empty"));
  emptyDrawing = new QLabel(empty);
  drawEmpty();
  emptyDrawing->setAlignment(Qt::AlignCenter);
  emptyTitle = new QLabel(empty);
  emptyTitle->setAlignment(Qt::AlignCenter);
  QFont large = panel.font();
  large.setPointSizeF(large.pointSizeF() * 1.3);
  emptyTitle->setFont(large);
  emptyText = new QLabel(empty);
  emptyText->setAlignment(Qt::AlignCenter);
  emptyText->setWordWrap(true);
  begin = new QPushButton(icon("ray-trace"), {}, empty);
  begin->setObjectName(QStringLiteral("begin"));
  begin->setMinimumHeight(2 * panel.fontMetrics().height());
  auto* column = new QVBoxLayout(empty);
  column->setSpacing(kGap);
  column->addStretch();
  column->addWidget(emptyDrawing);
  column->addWidget(emptyTitle);
  column->addWidget(emptyText);
  column->addSpacing(kGap);
  column->addWidget(begin, 0, Qt::AlignCenter);
  column->addStretch();

  note = new QPushButton(icon("refresh"), {}, canvas);
  note->setObjectName(QStringLiteral("outdated"));

  // Over the picture, so that the picture keeps its place when it comes and goes.
  progressRow = new QFrame(canvas);
  progressRow->setAutoFillBackground(true);
  progress = new QProgressBar(progressRow);
  progress->setObjectName(QStringLiteral("progress"));
  progress->setTextVisible(false);
  progress->setMaximumHeight(panel.fontMetrics().height() / 2 + 2);
  left = new QLabel(progressRow);
  left->setObjectName(QStringLiteral("timeLeft"));
  auto* row = new QHBoxLayout(progressRow);
  row->setContentsMargins(kGap, kGap / 2, kGap, kGap / 2);
  row->addWidget(progress, 1);
  row->addWidget(left);

  auto* noteRow = new QHBoxLayout;
  noteRow->setContentsMargins(kGap, kGap, kGap, kGap);
  noteRow->addStretch();
  noteRow->addWidget(note);
  noteRow->addStretch();
  auto* over = new QVBoxLayout(canvas);
  over->setContentsMargins(0, 0, 0, 0);
  over->setSpacing(0);
  over->addWidget(empty, 1);
  over->addStretch();
  over->addLayout(noteRow);
  over->addWidget(progressRow);

  auto* all = new QVBoxLayout(&panel);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(bar);
  all->addWidget(canvas, 1);
}

void PicturePanel::Impl::retranslate() {
  camera->setToolTip(tr("Where the picture is seen from: above, or a camera of the home"));
  trace->setToolTip(tr("Ray Trace: make a picture of the home as it is now"));
  stop->setToolTip(tr("Stop tracing and keep the picture as it is"));
  save->setToolTip(tr("Save the picture as a PNG or JPEG file"));
  maximise->setToolTip(tr("Give this view the whole window, and back (double click)"));
  close->setToolTip(tr("Back to the live view"));
  emptyTitle->setText(tr("No picture yet"));
  emptyText->setText(tr("Ray Trace shows your home in its real light, from above or from a camera."));
  begin->setText(tr("Ray Trace"));
  begin->setToolTip(trace->toolTip());
  note->setText(tr("Picture of an earlier state: Ray Trace again"));
  note->setToolTip(tr("The home has changed since this picture was begun"));
  progress->setToolTip(tr("How far the picture is: it becomes finer until then"));
  listCameras();
  showTimeLeft();
  fitEmpty();
}

void PicturePanel::Impl::listCameras() {
  const QSignalBlocker quiet(camera);
  camera->clear();
  camera->addItem(icon("level"), tr("From above"), qulonglong(0));
  if (place) camera->addItem(icon("view-picture"), tr("Where the live view stands"), qulonglong(kHere.value));
  int number = 0;
  for (const auto& [id, view] : editor.home().cameras) {
    ++number;
    camera->addItem(icon("camera"), view->name.empty() ? tr("Camera %1").arg(number) : toQt(view->name),
                    qulonglong(id.value));
  }
  int at = camera->findData(qulonglong(chosen.value));
  if (at < 0) {
    chosen = {};
    at = 0;
  }
  camera->setCurrentIndex(at);
  // The list that drops down is wide enough for its names, however narrow the box is.
  QAbstractItemView* names = camera->view();
  names->setMinimumWidth(names->sizeHintForColumn(0) + 2 * panel.fontMetrics().averageCharWidth());
  showTime();
}

void PicturePanel::Impl::showTime() {
  const Site& site = editor.home().site;
  const Camera* view = chosenCamera();
  const CivilTime at = civilFromUtc(view && view->time ? *view->time : site.time,
                                    isTimeZone(site.timeZone) ? site.timeZone : std::string("UTC"));
  time->setText(QTime(at.hour, at.minute).toString(QStringLiteral("HH:mm")));
  const QDate date(at.year, at.month, at.day);
  time->setToolTip(tr("The time of the picture's daylight: %1, %2")
                       .arg(QLocale().toString(date, QStringLiteral("d MMMM yyyy")), time->text()));
}

void PicturePanel::Impl::showTimeLeft() {
  if (secondsLeft < 0)
    left->setText(tr("Preparing…"));
  else
    left->setText(tr("%1 s left").arg(int(std::ceil(secondsLeft))));
}

void PicturePanel::Impl::showState() {
  const bool busy = worker.busy(), none = canvas->picture().isNull();
  // One takes the other's place; first out, then in, so that the panel never needs the room of both.
  (busy ? trace : stop)->hide();
  (busy ? stop : trace)->show();
  stop->setEnabled(busy);
  progressRow->setVisible(busy);
  save->setEnabled(!none);
  empty->setVisible(none && !busy);
  note->setVisible(!none && !busy && panel.outdated());
}

// In the colour of the theme.
void PicturePanel::Impl::drawEmpty() {
  const int side = 3 * panel.fontMetrics().height();
  emptyDrawing->setPixmap(icon("ray-trace").pixmap(QSize(side, side), panel.devicePixelRatioF()));
}

// Where there is little room, the button matters most, then the words, then the drawing.
void PicturePanel::Impl::fitEmpty() {
  const int line = panel.fontMetrics().lineSpacing(), width = std::max(canvas->width() - 4 * kGap, 1);
  const auto high = [&](QLabel* label) {
    return label->hasHeightForWidth() ? label->heightForWidth(width) : label->sizeHint().height();
  };
  int room = canvas->height() - 4 * kGap - begin->minimumHeight();
  for (QLabel* label : {emptyTitle, emptyText, emptyDrawing}) {
    room -= high(label) + kGap;
    label->setVisible(room > line / 2);
  }
}

// Another document: its picture is not this one.
void PicturePanel::Impl::forget() {
  canvas->setPicture({});
  traced.reset();
  place.reset();
  chosen = {};
}

PicturePanel::PicturePanel(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  Impl& d = *impl_;
  d.build();
  d.retranslate();
  d.showState();

  connect(d.trace, &QToolButton::clicked, this, &PicturePanel::rayTrace);
  connect(d.begin, &QPushButton::clicked, this, &PicturePanel::rayTrace);
  connect(d.note, &QPushButton::clicked, this, &PicturePanel::rayTrace);
  connect(d.stop, &QToolButton::clicked, this, &PicturePanel::stop);
  connect(d.save, &QToolButton::clicked, this, &PicturePanel::askWhereToSave);
  connect(d.maximise, &QToolButton::clicked, this, &PicturePanel::maximiseRequested);
  connect(d.close, &QToolButton::clicked, this, &PicturePanel::closed);
  connect(d.canvas, &PictureCanvas::resized, this, [&d] { d.fitEmpty(); });
  connect(d.canvas, &PictureCanvas::doubleClicked, this, &PicturePanel::maximiseRequested);
  connect(d.camera, &QComboBox::currentIndexChanged, this, [&d] {
    d.chosen = CameraId{d.camera->currentData().toULongLong()};
    d.byUser = true;
    d.showTime();
  });

  connect(&d.worker, &PictureWorker::pictured, this, [&d](const QImage& picture) {
    d.canvas->setPicture(picture);
    d.save->setEnabled(true);
  });
  connect(&d.worker, &PictureWorker::progressed, this, [&d](double fraction, double secondsLeft) {
    d.secondsLeft = secondsLeft;
    d.progress->setRange(0, secondsLeft < 0 ? 0 : 1000);
    d.progress->setValue(int(fraction * 1000));
    d.showTimeLeft();
  });
  connect(&d.worker, &PictureWorker::failed, this, [&d](const QString& why) {
    d.editor.say(Text(QT_TRANSLATE_NOOP("idap", "The picture could not be made: %1"), {fromQt(why)}),
                 Editor::Severity::Error);
  });
  connect(&d.worker, &PictureWorker::finished, this, [this, &d] {
    d.showState();
    emit finished();
  });

  Editor::Listener listener;
  listener.changed = [&d](Editor::Change change) {
    if (change == Editor::Change::Document) {
      d.worker.stop();
      d.forget();
    }
    if (change == Editor::Change::Document || change == Editor::Change::Home) {
      d.listCameras();
      d.showState();
    }
  };
  d.subscription = editor.subscribe(std::move(listener));
}

PicturePanel::~PicturePanel() { impl_->editor.unsubscribe(impl_->subscription); }

void PicturePanel::setCamera(CameraId camera) {
  impl_->chosen = camera;
  impl_->byUser = true;
  impl_->listCameras();
}

void PicturePanel::setPlace(const Camera& place) {
  Impl& d = *impl_;
  const bool moved = !d.place || !(*d.place == place);
  d.place = place;
  if (moved && !d.byUser) d.chosen = kHere;
  d.byUser = false;
  d.listCameras();
}

void PicturePanel::rayTrace() {
  Impl& d = *impl_;
  PictureRequest request;
  request.home = d.editor.home();
  request.catalog = d.editor.sharedCatalog();
  if (const Camera* camera = d.chosenCamera()) request.camera = *camera;
  QSize size = d.canvas->pixels();
  if (request.camera && request.camera->lens == Lens::Spherical)
    size.setHeight(std::max(1, size.width() / 2));
  if (request.camera && request.camera->lens == Lens::Fisheye)
    size = QSize(1, 1) * std::min(size.width(), size.height());
  request.width = size.width();
  request.height = size.height();
  request.samples = d.samples;
  request.seconds = d.seconds;
  d.traced = request.home;
  d.secondsLeft = -1;
  d.progress->setRange(0, 0);
  d.showTimeLeft();
  d.worker.start(std::move(request));
  d.showState();
  emit started();
}

void PicturePanel::stop() {
  impl_->worker.stop();
  impl_->stop->setEnabled(false);
}

bool PicturePanel::busy() const { return impl_->worker.busy(); }
QImage PicturePanel::picture() const { return impl_->canvas->picture(); }
bool PicturePanel::outdated() const {
  return impl_->traced && !sameDesign(*impl_->traced, impl_->editor.home());
}

void PicturePanel::setQuality(int samples, double seconds) {
  impl_->samples = samples;
  impl_->seconds = seconds;
}

void PicturePanel::savePicture(const QString& file) {
  const QImage picture = impl_->canvas->picture();
  if (picture.isNull()) return;
  Editor& editor = impl_->editor;
  const std::string path = fromQt(file);
  new BackgroundJob(
      tr("Saving the picture"),
      [picture, path](const Progress&) { render::savePicture(path, toImage8(picture)); },
      [&editor, path](std::exception_ptr error) {
        if (error)
          editor.say(
              Text(QT_TRANSLATE_NOOP("idap", "The picture was not saved: %1"), {fromQt(errorText(error))}),
              Editor::Severity::Error);
        else
          editor.say(Text(QT_TRANSLATE_NOOP("idap", "Picture saved as %1"), {path}));
      },
      this);
}

void PicturePanel::askWhereToSave() {
  const std::filesystem::path document = impl_->editor.document().file();
  const QString folder = document.empty() ? QStandardPaths::writableLocation(QStandardPaths::PicturesLocation)
                                          : toQt(document.parent_path().string());
  QString name = toQt(document.stem().string());
  if (name.isEmpty()) name = tr("Picture");
  auto* dialog = new QFileDialog(this, tr("Save picture"), folder);
  dialog->setObjectName(QStringLiteral("savePictureDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("PNG picture (*.png)"), tr("JPEG picture (*.jpg *.jpeg)")});
  dialog->setDefaultSuffix(QStringLiteral("png"));
  dialog->selectFile(name + QStringLiteral(".png"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.contains(QStringLiteral("*.jpg")) ? QStringLiteral("jpg")
                                                                      : QStringLiteral("png"));
  });
  connect(dialog, &QFileDialog::fileSelected, this, &PicturePanel::savePicture);
  dialog->open();
}

void PicturePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
  if (event->type() == QEvent::PaletteChange) impl_->drawEmpty();
  QWidget::changeEvent(event);
}

}  // namespace idap
