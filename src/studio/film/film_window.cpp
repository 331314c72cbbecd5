#include "studio/film/film_window.h"

#include <QComboBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTimeEdit>
#include <QToolButton>
#include <cmath>
#include <thread>
#include <tuple>

#include "base/error.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/home_clock.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/images.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::pair<int, int> kSizes[] = {{320, 180}, {640, 360}, {1280, 720}, {1920, 1080}};
constexpr int kQualities[] = {6, 12, 32, 96};  // samples a pixel

}  // namespace

struct FilmWindow::Impl {
  FilmWindow& window;
  Editor& editor;
  int subscription = 0;
  QPointer<BackgroundJob> job;
  QTimer estimateSoon;

  QComboBox *kind = nullptr, *size = nullptr, *quality = nullptr, *lamps = nullptr;
  QListWidget* stops = nullptr;
  QToolButton *up = nullptr, *down = nullptr;
  QDoubleSpinBox* speed = nullptr;
  QDateEdit* date = nullptr;
  QTimeEdit *from = nullptr, *to = nullptr;
  QSpinBox *length = nullptr, *rate = nullptr;
  QLabel *preview = nullptr, *estimate = nullptr, *left = nullptr;
  QProgressBar* bar = nullptr;
  QPushButton *begin = nullptr, *halt = nullptr;
  std::vector<std::pair<QLabel*, const char*>> labels;
  QImage shown;

  Impl(FilmWindow& w, Editor& e) : window(w), editor(e) {}
  void build();
  void retranslate();
  void listStops();
  void enable();
  void showPreview();
  bool isDay() const { return kind->currentIndex() == 1; }
  FilmPlan plan() const;
  FilmSettings settings() const;
  void showEstimate();
  void askFile();
};

void FilmWindow::Impl::build() {
  const auto named = [](auto* widget, const char* name) {
    widget->setObjectName(QLatin1String(name));
    return widget;
  };
  kind = named(new QComboBox, "filmKind");
  stops = named(new QListWidget, "filmStops");
  up = toolButton("up", "filmUp", &window);
  down = toolButton("down", "filmDown", &window);
  speed = named(new QDoubleSpinBox, "filmSpeed");
  speed->setRange(0.2, 5);
  speed->setSingleStep(0.1);
  speed->setDecimals(1);
  speed->setValue(1.2);
  date = named(new QDateEdit, "filmDate");
  date->setCalendarPopup(true);
  from = named(new QTimeEdit(QTime(6, 0)), "filmFrom");
  to = named(new QTimeEdit(QTime(20, 0)), "filmTo");
  length = named(new QSpinBox, "filmLength");
  length->setRange(1, 600);
  length->setValue(10);
  size = named(new QComboBox, "filmSize");
  for (const auto& [w, h] : kSizes) size->addItem(QStringLiteral("%1 × %2").arg(w).arg(h));
  size->setCurrentIndex(1);
  rate = named(new QSpinBox, "filmRate");
  rate->setRange(5, 60);
  rate->setValue(25);
  quality = named(new QComboBox, "filmQuality");
  lamps = named(new QComboBox, "filmLamps");
  preview = named(new QLabel, "filmPreview");
  preview->setMinimumSize(320, 180);
  preview->setAlignment(Qt::AlignCenter);
  preview->setFrameShape(QFrame::StyledPanel);
  preview->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  estimate = named(new QLabel, "filmEstimate");
  estimate->setWordWrap(true);
  bar = named(new QProgressBar, "filmProgress");
  bar->setRange(0, 1000);
  bar->setTextVisible(false);
  left = named(new QLabel, "filmLeft");
  begin = named(new QPushButton(icon("play"), {}), "filmBegin");
  halt = named(new QPushButton(icon("stop"), {}), "filmStop");

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  const auto row = [&](const char* words, QWidget* field) {
    auto* label = new QLabel;
    label->setBuddy(field);
    labels.emplace_back(label, words);
    form->addRow(label, field);
  };
  row(QT_TRANSLATE_NOOP("idap", "&Film of"), kind);
  auto* order = new QWidget;
  auto* orderRow = new QHBoxLayout(order);
  orderRow->setContentsMargins(0, 0, 0, 0);
  orderRow->addWidget(stops, 1);
  auto* turners = new QVBoxLayout;
  turners->addWidget(up);
  turners->addWidget(down);
  turners->addStretch();
  orderRow->addLayout(turners);
  stops->setMinimumHeight(7 * window.fontMetrics().height());
  row(QT_TRANSLATE_NOOP("idap", "T&hrough"), order);
  row(QT_TRANSLATE_NOOP("idap", "Metres a &second"), speed);
  row(QT_TRANSLATE_NOOP("idap", "&Date"), date);
  row(QT_TRANSLATE_NOOP("idap", "F&rom"), from);
  row(QT_TRANSLATE_NOOP("idap", "&To"), to);
  row(QT_TRANSLATE_NOOP("idap", "S&econds"), length);
  row(QT_TRANSLATE_NOOP("idap", "S&ize"), size);
  row(QT_TRANSLATE_NOOP("idap", "Frames &a second"), rate);
  row(QT_TRANSLATE_NOOP("idap", "&Quality"), quality);
  row(QT_TRANSLATE_NOOP("idap", "&Lamps"), lamps);
  auto* leftSide = new QVBoxLayout;
  leftSide->addLayout(form);
  leftSide->addStretch();
  leftSide->addWidget(estimate);
  auto* progress = new QHBoxLayout;
  progress->addWidget(bar, 1);
  progress->addWidget(left);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(halt);
  buttons->addWidget(begin);
  auto* right = new QVBoxLayout;
  right->addWidget(preview, 1);
  right->addLayout(progress);
  right->addLayout(buttons);
  auto* all = new QHBoxLayout(&window);
  all->addLayout(leftSide);
  all->addLayout(right, 1);

  const auto changed = [this] {
    enable();
    estimateSoon.start();
  };
  for (QComboBox* box : {kind, size, quality, lamps}) connect(box, &QComboBox::activated, &window, changed);
  connect(stops, &QListWidget::itemChanged, &window, changed);
  connect(speed, &QDoubleSpinBox::valueChanged, &window, changed);
  for (QSpinBox* box : {length, rate}) connect(box, &QSpinBox::valueChanged, &window, changed);
  for (const auto& [button, by] : {std::pair(up, -1), std::pair(down, 1)})
    connect(button, &QToolButton::clicked, &window, [this, by = by, changed] {
      const int at = stops->currentRow(), next = at + by;
      if (at < 0 || next < 0 || next >= stops->count()) return;
      stops->insertItem(next, stops->takeItem(at));
      stops->setCurrentRow(next);
      changed();
    });
  connect(begin, &QPushButton::clicked, &window, [this] { askFile(); });
  connect(halt, &QPushButton::clicked, &window, [this] { window.stop(); });
  estimateSoon.setSingleShot(true);
  estimateSoon.setInterval(150);
  connect(&estimateSoon, &QTimer::timeout, &window, [this] { showEstimate(); });
}

void FilmWindow::Impl::retranslate() {
  window.setWindowTitle(tr("Film"));
  for (const auto& [label, words] : labels) label->setText(translated(words));
  const auto refill = [](QComboBox* box, const QStringList& words, int first) {
    const int was = box->count() > 0 ? box->currentIndex() : first;
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItems(words);
    box->setCurrentIndex(was);
  };
  refill(kind, {tr("A walk through the home"), tr("A day of sunlight")}, 0);
  refill(quality, {tr("Draft"), tr("Good"), tr("Better"), tr("Best")}, 1);
  refill(lamps, {tr("As in the home"), tr("All on"), tr("All off")}, 0);
  stops->setToolTip(tr("The points of view that are ticked, in this order; a day is filmed from the first"));
  stops->setAccessibleName(tr("Points of view"));
  up->setToolTip(tr("Earlier"));
  down->setToolTip(tr("Later"));
  begin->setText(tr("&Make the film…"));
  halt->setText(tr("St&op"));
  halt->setToolTip(tr("Stops, and keeps the film so far"));
  if (shown.isNull()) preview->setText(tr("The film shows here while it is made."));
  listStops();
  enable();
  estimateSoon.start();
}

void FilmWindow::Impl::listStops() {
  std::vector<std::pair<qulonglong, bool>> before;
  for (int i = 0; i < stops->count(); ++i)
    before.emplace_back(stops->item(i)->data(Qt::UserRole).toULongLong(),
                        stops->item(i)->checkState() == Qt::Checked);
  const QSignalBlocker quiet(stops);
  stops->clear();
  const auto add = [this](CameraId id, const Camera& camera, int number, bool on) {
    auto* item = new QListWidgetItem(
        icon("camera"), camera.name.empty() ? tr("Camera %1").arg(number) : toQt(camera.name), stops);
    item->setData(Qt::UserRole, qulonglong(id.value));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
  };
  int number = 0;
  for (const auto& [id, on] : before)
    if (const Camera* camera = editor.home().cameras.find(CameraId{id}))
      add(CameraId{id}, *camera, ++number, on);
  for (const auto& [id, camera] : editor.home().cameras) {
    const bool known =
        std::any_of(before.begin(), before.end(), [&](const auto& b) { return b.first == id.value; });
    if (!known) add(id, *camera, ++number, true);
  }
}

void FilmWindow::Impl::enable() {
  const bool running = window.busy();
  for (QWidget* field : std::initializer_list<QWidget*>{date, from, to, length}) field->setEnabled(isDay());
  speed->setEnabled(!isDay());
  begin->setEnabled(!running);
  halt->setVisible(running);
  bar->setVisible(running);
  left->setVisible(running);
}

FilmPlan FilmWindow::Impl::plan() const {
  const Home home = editor.document().snapshot().home;
  std::vector<Camera> chosen;
  for (int i = 0; i < stops->count(); ++i)
    if (stops->item(i)->checkState() == Qt::Checked)
      if (const Camera* camera =
              home.cameras.find(CameraId{stops->item(i)->data(Qt::UserRole).toULongLong()}))
        chosen.push_back(*camera);
  if (chosen.empty() && home.cameras.empty()) chosen = defaultStops(home);
  if (chosen.empty()) throw Error(fromQt(tr("tick a point of view to film from, or add cameras (C)")));
  if (isDay()) {
    DaySettings day;
    day.framesPerSecond = rate->value();
    day.seconds = length->value();
    day.date.year = date->date().year(), day.date.month = date->date().month(),
    day.date.day = date->date().day();
    day.from = from->time().hour() + from->time().minute() / 60.0;
    day.to = to->time().hour() + to->time().minute() / 60.0;
    return planDay(home, chosen.front(), day);
  }
  WalkSettings walk;
  walk.framesPerSecond = rate->value();
  walk.pace.speed = speed->value();
  return planWalk(home, chosen, walk);
}

FilmSettings FilmWindow::Impl::settings() const {
  FilmSettings s;
  std::tie(s.width, s.height) = kSizes[std::size_t(std::max(0, size->currentIndex()))];
  s.samples = kQualities[std::size_t(std::max(0, quality->currentIndex()))];
  s.lamps = lamps->currentIndex() == 1   ? LampPolicy::On
            : lamps->currentIndex() == 2 ? LampPolicy::Off
                                         : LampPolicy::Auto;
  s.threads = std::max(1, int(std::thread::hardware_concurrency()) - 1);  // one is left to the window
  return s;
}

void FilmWindow::Impl::showEstimate() {
  if (!window.isVisible() || window.busy()) return;
  try {
    const FilmPlan film = plan();
    const int minutes = int(std::ceil(estimatedSeconds(film, settings()) / 60));
    QString words = tr("%1 seconds of film; making it takes about %2 min.")
                        .arg(QLocale().toString(film.seconds(), 'f', 1))
                        .arg(minutes);
    for (const std::string& warning : film.warnings) words += QLatin1Char('\n') + toQt(warning);
    estimate->setText(words);
    begin->setEnabled(true);
  } catch (const std::exception& error) {
    estimate->setText(toQt(error.what()));
    begin->setEnabled(false);
  }
}

void FilmWindow::Impl::showPreview() {
  if (shown.isNull()) return;
  const qreal ratio = window.devicePixelRatioF();
  QPixmap pixels = QPixmap::fromImage(
      shown.scaled(preview->contentsRect().size() * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  pixels.setDevicePixelRatio(ratio);
  preview->setPixmap(pixels);
}

void FilmWindow::Impl::askFile() {
  const std::filesystem::path document = editor.document().file();
  const QString folder = document.empty() ? QStandardPaths::writableLocation(QStandardPaths::MoviesLocation)
                                          : toQt(document.parent_path().string());
  auto* dialog = new QFileDialog(&window, tr("Make the film"), folder, tr("Films (*.mp4)"));
  dialog->setObjectName(QStringLiteral("filmDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("mp4"));
  QString name = toQt(document.stem().string());
  if (name.isEmpty()) name = tr("Home");
  dialog->selectFile(name + QStringLiteral(".mp4"));
  connect(dialog, &QFileDialog::fileSelected, &window,
          [this](const QString& file) { window.make(fromQt(file)); });
  dialog->open();
}

FilmWindow::FilmWindow(Editor& editor, QWidget* parent)
    : QWidget(parent, Qt::Window), impl_(std::make_unique<Impl>(*this, editor)) {
  setObjectName(QStringLiteral("filmWindow"));
  impl_->build();
  const CivilTime at = civilFromUtc(editor.home().site.time, zoneOf(editor.home()));
  impl_->date->setDate(QDate(at.year, at.month, at.day));
  impl_->retranslate();
  impl_->subscription = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change != Editor::Change::Document && change != Editor::Change::Home) return;
    impl_->listStops();
    impl_->estimateSoon.start();
  }});
  const int em = fontMetrics().height();
  resize(50 * em, 34 * em);
}

FilmWindow::~FilmWindow() {
  impl_->editor.unsubscribe(impl_->subscription);
  delete impl_->job;
}

bool FilmWindow::busy() const { return impl_->job; }

void FilmWindow::stop() {
  if (impl_->job) impl_->job->cancel();
}

void FilmWindow::make(const std::filesystem::path& file) {
  Impl& d = *impl_;
  if (busy()) return;
  FilmPlan plan;
  try {
    plan = d.plan();
  } catch (const std::exception& error) {
    d.estimate->setText(toQt(error.what()));
    return;
  }
  const FilmSettings settings = d.settings();
  const auto catalog = d.editor.sharedCatalog();
  const auto result = std::make_shared<FilmResult>();
  d.job = new BackgroundJob(
      tr("Making a film"),
      [this, plan = std::move(plan), catalog, settings, file, result](const Progress& progress) {
        *result = makeFilm(plan, *catalog, settings, file, progress, [this](const FilmFrame& frame) {
          QMetaObject::invokeMethod(
              this,
              [this, image = toQImage(frame.image)] {
                impl_->shown = image;
                impl_->showPreview();
              },
              Qt::QueuedConnection);
        });
      },
      [this, file, result](std::exception_ptr error) {
        impl_->job = nullptr;
        impl_->enable();
        impl_->estimateSoon.start();
        const QString why = error ? errorText(error) : QString();
        if (!why.isEmpty())
          impl_->editor.say(Text(QT_TRANSLATE_NOOP("idap", "The film could not be made: %1"), {fromQt(why)}),
                            Editor::Severity::Error);
        else if (!error)
          impl_->editor.say(Text(QT_TRANSLATE_NOOP("idap", "Film saved as %1"), {file.string()}));
        emit finished(!error);
      },
      this);
  connect(d.job, &BackgroundJob::progressed, this, [this] {
    if (!impl_->job) return;
    impl_->bar->setValue(int(impl_->job->fraction() * 1000));
    const auto seconds = impl_->job->secondsLeft();
    impl_->left->setText(seconds ? tr("%1 left").arg(QTime(0, 0).addSecs(int(*seconds)).toString("h:mm:ss"))
                                 : tr("preparing…"));
  });
  d.bar->setValue(0);
  d.enable();
}

void FilmWindow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
}

}  // namespace idap
