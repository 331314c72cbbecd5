#include "studio/view3d/light_popup.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateEdit>
#include <QFormLayout>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QSlider>
#include <cmath>
#include <utility>

#include "studio/view3d/view3d.h"
#include "studio/widgets/home_clock.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kWeather[] = {0, 0.5, 1};  // Environment::cloudiness of clear, partly cloudy, overcast

}  // namespace

LightPopup::LightPopup(Editor& editor, View3d& view, QWidget* parent)
    : QFrame(parent, Qt::Popup), editor_(editor), view_(view) {
  setObjectName(QStringLiteral("lightPopup"));
  setFrameShape(QFrame::StyledPanel);
  setAttribute(Qt::WA_DeleteOnClose);
  auto* all = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  all->addLayout(form);

  auto* date = new QDateEdit;
  date->setObjectName(QStringLiteral("liveDate"));
  date->setCalendarPopup(true);
  date->setDateRange(QDate(1900, 1, 1), QDate(2199, 12, 31));
  form->addRow(tr("Date"), date);
  refreshers_.push_back([this, date] {
    const QSignalBlocker quiet(date);
    const CivilTime at = civilFromUtc(editor_.home().site.time, zoneOf(editor_.home()));
    date->setDate(QDate(at.year, at.month, at.day));
  });
  connect(date, &QDateEdit::dateChanged, this, [this](const QDate& day) {
    changeSite(QT_TRANSLATE_NOOP("idap", "Change the date"), [this, day](Home& home) {
      CivilTime at = civilFromUtc(home.site.time, zoneOf(home));
      at.year = day.year(), at.month = day.month(), at.day = day.day();
      home.site.time = utcFromCivil(at, zoneOf(home));
    });
  });

  auto* weather = new QComboBox;
  weather->setObjectName(QStringLiteral("weather"));
  weather->addItems({tr("Clear"), tr("Partly cloudy"), tr("Overcast")});
  form->addRow(tr("Weather"), weather);
  refreshers_.push_back([this, weather] {
    const double clouds = editor_.home().environment.cloudiness;
    weather->setCurrentIndex(clouds < 0.34 ? 0 : clouds < 0.75 ? 1 : 2);
  });
  connect(weather, &QComboBox::activated, this, [this](int index) {
    changeSite(QT_TRANSLATE_NOOP("idap", "Change the weather"),
               [index](Home& home) { home.environment.cloudiness = kWeather[std::size_t(index)]; });
  });

  auto* exposure = new SliderField(-3, 3, 0.25, tr("EV"), 2);
  exposure->setObjectName(QStringLiteral("exposure"));
  exposure->setToolTip(tr("Brighter or darker than the automatic exposure, in stops"));
  exposure->setValue(view_.compensation());
  form->addRow(tr("Exposure"), exposure);
  connect(exposure, &SliderField::valueChanging, this, [this](double v) { view_.setCompensation(v); });
  connect(exposure, &SliderField::valueChanged, this, [this](double v) { view_.setCompensation(v); });

  addLamps(all);
  refresh();
  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document) close();
    if (change == Editor::Change::Home) refresh();
  };
  subscription_ = editor_.subscribe(std::move(listener));
}

LightPopup::~LightPopup() {
  if (dimming_) editor_.document().commit();  // closed while a dimmer was held
  editor_.unsubscribe(subscription_);
}

void LightPopup::addLamps(QVBoxLayout* all) {
  auto* rows = new QWidget;
  auto* grid = new QGridLayout(rows);
  int row = 0;
  for (const auto& [lampId, piece] : editor_.home().furniture) {
    if (!piece->lamp) continue;
    const FurnitureId id = lampId;
    auto* on = new QCheckBox(piece->name.empty() ? tr("Lamp") : toQt(piece->name));
    on->setObjectName(QStringLiteral("lamp%1").arg(id.value));
    auto* dimmer = new QSlider(Qt::Horizontal);
    dimmer->setObjectName(QStringLiteral("dimmer%1").arg(id.value));
    dimmer->setRange(1, 100);
    dimmer->setMinimumWidth(8 * fontMetrics().height());
    dimmer->setAccessibleName(tr("Brightness of %1").arg(on->text()));
    dimmer->setToolTip(dimmer->accessibleName());
    grid->addWidget(on, row, 0);
    grid->addWidget(dimmer, row++, 1);
    connect(on, &QCheckBox::clicked, this, [this, id](bool lit) {
      changeLamp(
          QT_TRANSLATE_NOOP("idap", "Switch a lamp"), id, [lit](Lamp& lamp) { lamp.on = lit; }, false);
    });
    constexpr const char* kDim = QT_TRANSLATE_NOOP("idap", "Dim a lamp");
    connect(dimmer, &QSlider::valueChanged, this, [this, id, dimmer](int percent) {
      changeLamp(
          kDim, id, [percent](Lamp& lamp) { lamp.dimmer = percent / 100.0; }, dimmer->isSliderDown());
    });
    connect(dimmer, &QSlider::sliderReleased, this, [this] {
      if (std::exchange(dimming_, false)) editor_.document().commit();
    });
    refreshers_.push_back([this, id, on, dimmer] {
      const Furniture* lamp = editor_.home().furniture.find(id);
      on->setEnabled(lamp && lamp->lamp);
      dimmer->setEnabled(lamp && lamp->lamp && lamp->lamp->on);
      if (!lamp || !lamp->lamp) return;
      const QSignalBlocker quiet(dimmer);
      on->setChecked(lamp->lamp->on);
      if (!dimmer->isSliderDown()) dimmer->setValue(int(std::lround(lamp->lamp->dimmer * 100)));
    });
  }
  if (row == 0) {
    all->addWidget(new QLabel(tr("This home has no lamps yet.")));
    delete rows;
    return;
  }
  auto* buttons = new QHBoxLayout;
  for (const bool on : {true, false}) {
    auto* button = new QPushButton(on ? tr("All lamps on") : tr("All lamps off"));
    button->setObjectName(on ? QStringLiteral("allOn") : QStringLiteral("allOff"));
    connect(button, &QPushButton::clicked, this, [this, on] { switchAll(on); });
    buttons->addWidget(button);
  }
  all->addLayout(buttons);
  auto* scroll = new QScrollArea;
  scroll->setWidget(rows);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(rows->sizeHint().width() + 2 * fontMetrics().height());
  scroll->setMinimumHeight(std::min(rows->sizeHint().height() + 4, 14 * fontMetrics().height()));
  all->addWidget(scroll);
}

void LightPopup::changeSite(const char* name, const std::function<void(Home&)>& change) {
  editor_.apply(name, [&](const Home& home) {
    Home next = home;
    change(next);
    return next;
  });
}

void LightPopup::changeLamp(const char* name, FurnitureId id, const std::function<void(Lamp&)>& change,
                            bool goesOn) {
  const auto edit = [id, change](const Home& home) {
    const Furniture* piece = home.furniture.find(id);
    if (!piece || !piece->lamp) return home;
    Furniture changed = *piece;
    change(*changed.lamp);
    Home next = home;
    next.furniture.set(id, std::move(changed));
    return next;
  };
  if (!goesOn) {
    editor_.apply(name, edit);
    return;
  }
  if (!dimming_) editor_.document().begin(name);
  dimming_ = true;
  editor_.preview(edit);
}

void LightPopup::switchAll(bool on) {
  changeSite(on ? QT_TRANSLATE_NOOP("idap", "Switch all lamps on")
                : QT_TRANSLATE_NOOP("idap", "Switch all lamps off"),
             [on](Home& home) {
               for (const auto& [id, piece] : home.furniture) {
                 if (!piece->lamp || piece->lamp->on == on) continue;
                 Furniture changed = *piece;
                 changed.lamp->on = on;
                 home.furniture.set(id, std::move(changed));
               }
             });
}

void LightPopup::refresh() {
  for (const auto& refresher : refreshers_) refresher();
}

void LightPopup::showBelow(QWidget* button) {
  adjustSize();
  QPoint at = button->mapToGlobal(QPoint(button->width() - width(), button->height()));
  if (const QScreen* screen = button->screen()) {
    const QRect area = screen->availableGeometry();
    at.setX(std::clamp(at.x(), area.left(), std::max(area.left(), area.right() - width())));
    at.setY(std::clamp(at.y(), area.top(), std::max(area.top(), area.bottom() - height())));
  }
  move(at);
  show();
}

}  // namespace idap
