#include "studio/view3d/live_panel.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QSlider>
#include <QTime>
#include <QToolButton>

#include "studio/view3d/light_popup.h"
#include "studio/view3d/view3d.h"
#include "studio/widgets/home_clock.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kGap = 6;
constexpr int kMinutes = 24 * 60, kMinuteStep = 5;
constexpr qulonglong kHere = ~0ull;  // of the list: where the user has gone

}  // namespace

struct LivePanel::Impl {
  LivePanel& panel;
  Editor& editor;
  int subscription = 0;
  View3d* view = nullptr;
  QComboBox* camera = nullptr;
  QToolButton *orbit = nullptr, *walk = nullptr, *cut = nullptr, *collide = nullptr, *store = nullptr;
  QToolButton* light = nullptr;
  QSlider* hour = nullptr;
  QLabel *sun = nullptr, *time = nullptr, *state = nullptr;
  bool dragging = false;  // the hour; one undo step
  bool arrived = false;   // the camera is the one that the list says
  int samples = 0;
  bool finished = false;

  Impl(LivePanel& p, Editor& e) : panel(p), editor(e) {}
  void build();
  void connectParts();
  void retranslate();
  void listCameras();
  void showManner();
  void showTime();
  void showState();
  void setMinute(int minute);
  std::int64_t now() const { return view->camera().time.value_or(editor.home().site.time); }
};

void LivePanel::Impl::build() {
  view = new View3d(editor, &panel);
  view->setObjectName(QStringLiteral("view3d"));
  camera = new QComboBox(&panel);
  camera->setObjectName(QStringLiteral("liveCamera"));
  camera->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  camera->setMinimumContentsLength(8);
  camera->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  camera->setMaximumWidth(panel.fontMetrics().averageCharWidth() * 36);
  orbit = toolButton("orbit", "orbit", &panel);
  walk = toolButton("walk", "walk", &panel);
  cut = toolButton("cut-away", "cutAway", &panel);
  collide = toolButton("collide", "collide", &panel);
  store = toolButton("camera", "storeView", &panel);
  light = toolButton("lamp", "light", &panel);
  for (QToolButton* button : {orbit, walk, cut, collide}) button->setCheckable(true);
  orbit->setAutoExclusive(true);
  walk->setAutoExclusive(true);
  cut->setChecked(true);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(kGap, kGap / 2, kGap / 2, kGap / 2);
  bar->setSpacing(kGap / 3);
  bar->addWidget(camera, 1);
  bar->addSpacing(kGap);
  for (QToolButton* button : {orbit, walk, cut, collide, store, light}) bar->addWidget(button);

  hour = new QSlider(Qt::Horizontal, &panel);
  hour->setObjectName(QStringLiteral("hour"));
  hour->setRange(0, kMinutes - kMinuteStep);
  hour->setSingleStep(kMinuteStep);
  hour->setPageStep(60);
  hour->setMinimumWidth(40);
  sun = new QLabel(&panel);
  time = new QLabel(&panel);
  time->setObjectName(QStringLiteral("liveTime"));
  time->setMinimumWidth(panel.fontMetrics().horizontalAdvance(QStringLiteral("00:00")));
  state = new QLabel(&panel);
  state->setObjectName(QStringLiteral("liveState"));
  state->setForegroundRole(QPalette::PlaceholderText);
  auto* below = new QHBoxLayout;
  below->setContentsMargins(kGap, kGap / 3, kGap, kGap / 3);
  below->addWidget(sun);
  below->addWidget(hour, 1);
  below->addWidget(time);
  below->addSpacing(kGap);
  below->addWidget(state);
  auto* all = new QVBoxLayout(&panel);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(0);
  all->addLayout(bar);
  all->addWidget(view, 1);
  all->addLayout(below);
}

void LivePanel::Impl::connectParts() {
  connect(camera, &QComboBox::activated, &panel, [this] {
    const qulonglong id = camera->currentData().toULongLong();
    if (id != kHere) panel.setCamera(CameraId{id});
  });
  connect(orbit, &QToolButton::clicked, &panel, [this] { view->setManner(View3d::Manner::Orbit); });
  connect(walk, &QToolButton::clicked, &panel, [this] {
    if (isOutside(editor.home(), view->camera().eye) && !editor.home().rooms.empty()) {
      // To walk one must be somewhere: in the middle of the first room of the level.
      for (const auto& [id, room] : editor.home().rooms) {
        if (editor.level() && room->level != editor.level()) continue;
        Vec2 middle;
        for (const Vec2 p : room->points) middle += p / double(room->points.size());
        Camera inside = view->camera();
        inside.eye = {middle.x, middle.y, elevationOf(editor.home(), room->level) + 1.6};
        inside.pitch = 0;
        inside.fieldOfView = 75 * kPi / 180;  // a room, not a part of it
        view->setCamera(inside);
        break;
      }
    }
    view->setManner(View3d::Manner::Walk);
    view->setFocus(Qt::OtherFocusReason);
  });
  connect(cut, &QToolButton::toggled, &panel,
          [this](bool on) { view->setCutAway(on ? CutAway::ByView : CutAway::Never); });
  connect(collide, &QToolButton::toggled, &panel, [this](bool on) { view->setStopsAtWalls(on); });
  connect(store, &QToolButton::clicked, &panel, [this] { panel.storeView(); });
  connect(light, &QToolButton::clicked, &panel, [this] {
    auto* popup = new LightPopup(editor, *view, &panel);
    popup->showBelow(light);
  });
  connect(view, &View3d::maximiseRequested, &panel, &LivePanel::maximiseRequested);
  connect(view, &View3d::contextMenuRequested, &panel, &LivePanel::contextMenuRequested);
  connect(view, &View3d::failed, &panel, [this](const QString& why) {
    editor.say(Text(QT_TRANSLATE_NOOP("idap", "The live view could not be made: %1"), {fromQt(why)}),
               Editor::Severity::Error);
  });
  connect(view, &View3d::cameraMoved, &panel, [this] {
    if (!arrived && camera->currentData().toULongLong() != kHere) {
      const int at = camera->findData(kHere);
      camera->setCurrentIndex(at);
    }
    showManner();
    showTime();
  });
  connect(view, &View3d::frameShown, &panel, [this](int n, bool done) {
    samples = n;
    finished = done;
    showState();
  });
  connect(hour, &QSlider::sliderPressed, &panel, [this] { dragging = true; });
  connect(hour, &QSlider::valueChanged, &panel, [this](int minute) { setMinute(minute); });
  connect(hour, &QSlider::sliderReleased, &panel, [this] {
    dragging = false;
    if (editor.document().inTransaction()) editor.document().commit();
  });
}

// The hour of the home, or of the point of view where that has its own.
void LivePanel::Impl::setMinute(int minute) {
  CivilTime at = civilFromUtc(now(), zoneOf(editor.home()));
  at.hour = minute / 60;
  at.minute = minute % 60;
  at.second = 0;
  const std::int64_t utc = utcFromCivil(at, zoneOf(editor.home()));
  if (utc == now()) return;
  if (view->camera().time) {
    Camera later = view->camera();
    later.time = utc;
    arrived = true;
    view->setCamera(later);
    arrived = false;
    return;
  }
  constexpr const char* kName = QT_TRANSLATE_NOOP("idap", "Change the time");
  const auto change = [utc](const Home& home) {
    Home next = home;
    next.site.time = utc;
    return next;
  };
  if (!dragging) {
    editor.apply(kName, change);
    return;
  }
  if (!editor.document().inTransaction()) editor.document().begin(kName);
  editor.preview(change);
}

void LivePanel::Impl::listCameras() {
  const QSignalBlocker quiet(camera);
  const QVariant chosen = camera->currentData();
  camera->clear();
  camera->addItem(icon("level"), tr("From above"), qulonglong(0));
  int number = 0;
  for (const auto& [id, view_] : editor.home().cameras) {
    ++number;
    camera->addItem(icon("camera"), view_->name.empty() ? tr("Camera %1").arg(number) : toQt(view_->name),
                    qulonglong(id.value));
  }
  camera->addItem(icon("walk"), tr("Here"), kHere);
  const int at = chosen.isValid() ? camera->findData(chosen) : -1;
  camera->setCurrentIndex(at >= 0 ? at : camera->findData(kHere));
  QAbstractItemView* names = camera->view();
  names->setMinimumWidth(names->sizeHintForColumn(0) + 2 * panel.fontMetrics().averageCharWidth());
}

void LivePanel::Impl::showManner() {
  const bool walks = view->manner() == View3d::Manner::Walk;
  walk->setChecked(walks);
  orbit->setChecked(!walks);
}

void LivePanel::Impl::showTime() {
  const CivilTime at = civilFromUtc(now(), zoneOf(editor.home()));
  if (!dragging) {
    const QSignalBlocker quiet(hour);
    hour->setValue(at.hour * 60 + at.minute);
  }
  time->setText(QTime(at.hour, at.minute).toString(QStringLiteral("HH:mm")));
}

void LivePanel::Impl::showState() {
  state->setText(samples == 0 ? tr("Coarse") : finished ? tr("Clean") : tr("%1 samples").arg(samples));
}

void LivePanel::Impl::retranslate() {
  camera->setToolTip(tr("Where the view is seen from"));
  orbit->setToolTip(tr("Circle: drag turns the home, the wheel comes nearer, the middle button shifts"));
  walk->setToolTip(
      tr("Walk: drag looks around; W A S D walk, Q and E lower and raise the eye, Shift hurries"));
  cut->setToolTip(tr("Cut away the walls and ceilings that are in the way of an eye outside"));
  collide->setToolTip(tr("Walls stop the walker; doors let them through"));
  store->setToolTip(tr("Keep this point of view in the home"));
  light->setToolTip(tr("Date, weather, lamps and exposure"));
  hour->setToolTip(tr("Time of day"));
  hour->setAccessibleName(tr("Time of day"));
  sun->setPixmap(icon("sun").pixmap(QSize(1, 1) * panel.fontMetrics().height(), panel.devicePixelRatioF()));
  state->setToolTip(tr("How fine the view is; it becomes clean while nothing changes"));
  state->setMinimumWidth(panel.fontMetrics().horizontalAdvance(tr("%1 samples").arg(256)));
  listCameras();
  showState();
}

LivePanel::LivePanel(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  impl_->build();
  impl_->connectParts();
  impl_->retranslate();
  impl_->showManner();
  impl_->showTime();
  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document || change == Editor::Change::Home) {
      impl_->listCameras();
      impl_->showTime();
    }
  };
  impl_->subscription = editor.subscribe(std::move(listener));
}

LivePanel::~LivePanel() { impl_->editor.unsubscribe(impl_->subscription); }

View3d& LivePanel::view() const { return *impl_->view; }

void LivePanel::setCamera(CameraId id) {
  Impl& d = *impl_;
  d.arrived = true;
  if (const Camera* camera = d.editor.home().cameras.find(id))
    d.view->setCamera(*camera);
  else
    d.view->seeWholeHome();
  d.arrived = false;
  const QSignalBlocker quiet(d.camera);
  d.camera->setCurrentIndex(std::max(0, d.camera->findData(qulonglong(id.value))));
}

void LivePanel::storeView() {
  Impl& d = *impl_;
  Camera camera = d.view->camera();
  camera.name = fromQt(tr("View %1").arg(d.editor.home().cameras.size() + 1));
  CameraId added;
  d.editor.apply(QT_TRANSLATE_NOOP("idap", "Keep the point of view"), [&](const Home& home) {
    Home next = home;
    added = next.newId<CameraId>();
    next.cameras.set(added, camera);
    return next;
  });
  if (!d.editor.home().cameras.contains(added)) return;
  const QSignalBlocker quiet(d.camera);
  d.camera->setCurrentIndex(std::max(0, d.camera->findData(qulonglong(added.value))));
  d.editor.say(Text(QT_TRANSLATE_NOOP("idap", "The point of view is kept as %1"), {camera.name}));
}

void LivePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
  QWidget::changeEvent(event);
}

}  // namespace idap
