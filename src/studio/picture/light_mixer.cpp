#include "studio/picture/light_mixer.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>
#include <map>

#include "light/color_temperature.h"
#include "render/film/mix_preview.h"
#include "studio/widgets/background_job.h"
#include "studio/widgets/images.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr double kMostPercent = 300;
constexpr double kLeastShare = 1e-4;  // of the picture's light; what makes less cannot be seen
struct Warmth {
  double kelvin;  // 0: the light's own
  const char* name;
};
constexpr Warmth kWarmths[] = {{0, QT_TRANSLATE_NOOP("idap", "Own colour")},
                               {2200, QT_TRANSLATE_NOOP("idap", "Candle, 2200 K")},
                               {2700, QT_TRANSLATE_NOOP("idap", "Warm white, 2700 K")},
                               {3000, QT_TRANSLATE_NOOP("idap", "Soft white, 3000 K")},
                               {4000, QT_TRANSLATE_NOOP("idap", "Neutral white, 4000 K")},
                               {6500, QT_TRANSLATE_NOOP("idap", "Daylight, 6500 K")}};

}  // namespace

struct LightMixer::Impl {
  struct Row {
    std::size_t group = 0;
    QCheckBox* on = nullptr;
    SliderField* strength = nullptr;
    QComboBox* warmth = nullptr;  // null where the light's own colour is not known
  };

  LightMixer& mixer;
  std::shared_ptr<const PictureFilm> film;
  std::shared_ptr<const render::MixPreview> preview;
  BackgroundJob* preparing = nullptr;
  QLabel *title = nullptr, *hint = nullptr;
  QProgressBar* progress = nullptr;
  QScrollArea* scroll = nullptr;
  QPushButton *reset = nullptr, *keep = nullptr, *takeOver = nullptr;
  std::vector<Row> rows;

  explicit Impl(LightMixer& m) : mixer(m) {}
  void build();
  void retranslate();
  void fill();
  void show();
  render::LightChange changeOf(const Row& row) const;
};

void LightMixer::Impl::build() {
  title = new QLabel;
  QFont bold = mixer.font();
  bold.setBold(true);
  title->setFont(bold);
  hint = new QLabel;
  hint->setObjectName(QStringLiteral("mixHint"));
  hint->setWordWrap(true);
  progress = new QProgressBar;
  progress->setObjectName(QStringLiteral("mixProgress"));
  progress->setRange(0, 1000);
  progress->setTextVisible(false);
  scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("mixLights"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  reset = new QPushButton;
  reset->setObjectName(QStringLiteral("mixReset"));
  keep = new QPushButton;
  keep->setObjectName(QStringLiteral("mixKeep"));
  takeOver = new QPushButton;
  takeOver->setObjectName(QStringLiteral("mixTakeOver"));
  // Wide enough for its rows before they are there, so that the picture is not pushed aside later.
  mixer.setMinimumWidth(36 * mixer.fontMetrics().averageCharWidth());
  auto* column = new QVBoxLayout(&mixer);
  column->addWidget(title);
  column->addWidget(hint);
  column->addWidget(progress);
  column->addWidget(scroll, 1);
  for (QPushButton* button : {keep, takeOver, reset}) column->addWidget(button);
  connect(reset, &QPushButton::clicked, &mixer, [this] { mixer.reset(); });
  connect(keep, &QPushButton::clicked, &mixer, &LightMixer::keepAsked);
  connect(takeOver, &QPushButton::clicked, &mixer, &LightMixer::takeOverAsked);
}

void LightMixer::Impl::retranslate() {
  title->setText(tr("Lights of this picture"));
  keep->setText(tr("&Keep as a picture"));
  keep->setToolTip(tr("Puts the mix into the gallery, beside the picture it was made of"));
  takeOver->setText(tr("Set the &home's lamps so"));
  takeOver->setToolTip(
      tr("Dims, recolours and switches the lamps of the home as they are here; can be undone"));
  reset->setText(tr("As the picture &was"));
  fill();
}

render::LightChange LightMixer::Impl::changeOf(const Row& row) const {
  render::LightChange change;
  change.strength = row.on->isChecked() ? static_cast<float>(row.strength->value() / 100) : 0.0f;
  const double kelvin = row.warmth ? row.warmth->currentData().toDouble() : 0;
  if (kelvin > 0) change.color = rgbFromTemperature(kelvin);
  return change;
}

// A row a light, the strongest first.
void LightMixer::Impl::fill() {
  const bool mixable = film && !film->film.groups.empty();
  progress->setVisible(mixable && !preview);
  scroll->setVisible(preview != nullptr);
  hint->setVisible(!preview);
  hint->setText(!film ? tr("The light of this picture is no longer known. Make it again to mix its lights.")
                : !mixable ? tr("This picture keeps no light by itself.")
                           : tr("Taking the lights apart…"));
  for (QPushButton* button : {reset, keep, takeOver}) button->setEnabled(false);
  rows.clear();
  if (!preview) {
    scroll->setWidget(new QWidget);
    return;
  }
  auto* list = new QWidget;
  auto* grid = new QGridLayout(list);
  grid->setContentsMargins(0, 0, 0, 0);
  std::vector<std::size_t> order;
  for (std::size_t g = 0; g < preview->groups().size(); ++g)
    if (preview->shares()[g] > kLeastShare) order.push_back(g);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t g) { return preview->shares()[g]; });
  int line = 0;
  std::map<QString, int> named;
  for (const std::size_t g : order) {
    Row row;
    row.group = g;
    const render::LightGroup& light = preview->groups()[g];
    const QString name = g == 0                                                   ? tr("Sky")
                         : light.name == "sun" && film->lamps[g] == FurnitureId{} ? tr("Sun")
                                                                                  : toQt(light.name);
    const int same = ++named[name];  // lamps of one name are told apart by numbers
    row.on = new QCheckBox(same == 1 ? name : QStringLiteral("%1 (%2)").arg(name).arg(same));
    row.on->setObjectName(QStringLiteral("mixOn%1").arg(g));
    row.on->setChecked(true);
    row.on->setToolTip(tr("%1 % of the picture's light").arg(100 * double(preview->shares()[g]), 0, 'f', 1));
    row.strength = new SliderField(0, kMostPercent, 1, QStringLiteral("%"), 0);
    row.strength->setObjectName(QStringLiteral("mixStrength%1").arg(g));
    row.strength->setValue(100);
    row.strength->number()->setAccessibleName(tr("Strength of %1").arg(name));
    row.strength->slider()->setAccessibleName(tr("Strength of %1").arg(name));
    if (line > 0) grid->setRowMinimumHeight(line++, 4);
    grid->addWidget(row.on, line++, 0);
    grid->addWidget(row.strength, line++, 0);
    if (luminance(light.color) > 0) {
      row.warmth = new QComboBox;
      row.warmth->setObjectName(QStringLiteral("mixWarmth%1").arg(g));
      row.warmth->setAccessibleName(tr("Colour of %1").arg(name));
      for (const Warmth& w : kWarmths) row.warmth->addItem(translated(w.name), w.kelvin);
      grid->addWidget(row.warmth, line++, 0);
      connect(row.warmth, &QComboBox::currentIndexChanged, &mixer, [this] { show(); });
    }
    connect(row.on, &QCheckBox::toggled, &mixer, [this, field = row.strength](bool on) {
      field->setEnabled(on);
      show();
    });
    connect(row.strength, &SliderField::valueChanging, &mixer, [this] { show(); });
    connect(row.strength, &SliderField::valueChanged, &mixer, [this] { show(); });
    rows.push_back(row);
  }
  grid->setRowStretch(line, 1);
  scroll->setWidget(list);
  list->ensurePolished();
  scroll->setMinimumWidth(std::max(list->sizeHint().width(), list->minimumSizeHint().width()) +
                          scroll->verticalScrollBar()->sizeHint().width());
  show();
}

void LightMixer::Impl::show() {
  if (!preview) return;
  const bool changed = mixer.changed();
  reset->setEnabled(changed);
  keep->setEnabled(changed);
  takeOver->setEnabled(!mixer.lampChanges().empty());
  emit mixer.previewed(
      toQImage(preview->picture(mixer.changes(), film->look.toneMap, film->look.compensation)));
}

LightMixer::LightMixer(QWidget* parent) : QWidget(parent), impl_(std::make_unique<Impl>(*this)) {
  setObjectName(QStringLiteral("lightMixer"));
  impl_->build();
  impl_->retranslate();
}

LightMixer::~LightMixer() { delete impl_->preparing; }

void LightMixer::setFilm(std::shared_ptr<const PictureFilm> film) {
  Impl& d = *impl_;
  if (film && film == d.film) return;
  delete d.preparing;
  d.preparing = nullptr;
  d.film = std::move(film);
  d.preview.reset();
  d.fill();
  if (!d.film || d.film->film.groups.empty()) return;
  using Preview = std::shared_ptr<const render::MixPreview>;
  d.progress->setValue(0);
  d.preparing = runInBackground<Preview>(
      this, tr("Taking the lights apart"),
      [film = d.film](const Progress& progress) -> Preview {
        return std::make_shared<const render::MixPreview>(film->film, film->lightGroups, 200'000, progress);
      },
      [this](Preview preview) {
        impl_->preparing = nullptr;
        impl_->preview = std::move(preview);
        impl_->fill();
      },
      [this](std::exception_ptr error) {
        impl_->preparing = nullptr;
        if (const QString why = errorText(error); !why.isEmpty()) emit failed(why);
      });
  connect(d.preparing, &BackgroundJob::progressed, this, [this] {
    if (impl_->preparing) impl_->progress->setValue(int(1000 * impl_->preparing->fraction()));
  });
}

std::shared_ptr<const PictureFilm> LightMixer::film() const { return impl_->film; }
bool LightMixer::ready() const { return impl_->preview != nullptr; }

bool LightMixer::changed() const {
  return std::ranges::any_of(impl_->rows, [this](const Impl::Row& row) {
    const render::LightChange change = impl_->changeOf(row);
    return change.strength != 1 || change.color;
  });
}

std::vector<render::LightChange> LightMixer::changes() const {
  std::vector<render::LightChange> all(impl_->film ? impl_->film->film.groups.size() : 0);
  for (const Impl::Row& row : impl_->rows)
    if (row.group < all.size()) all[row.group] = impl_->changeOf(row);
  return all;
}

std::vector<LampChange> LightMixer::lampChanges() const {
  std::vector<LampChange> all;
  for (const Impl::Row& row : impl_->rows) {
    const FurnitureId lamp = impl_->film->lamps[row.group];
    const render::LightChange change = impl_->changeOf(row);
    if (lamp == FurnitureId{} || (change.strength == 1 && !change.color)) continue;
    LampChange& one = all.emplace_back(LampChange{lamp, double(change.strength), {}});
    if (change.color) one.kelvin = row.warmth->currentData().toDouble();
  }
  return all;
}

void LightMixer::reset() {
  for (Impl::Row& row : impl_->rows) {
    const QSignalBlocker on(row.on);
    row.on->setChecked(true);
    row.strength->setEnabled(true);
    row.strength->setValue(100);
    if (!row.warmth) continue;
    const QSignalBlocker warmth(row.warmth);
    row.warmth->setCurrentIndex(0);
  }
  impl_->show();
}

void LightMixer::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->retranslate();
}

}  // namespace idap
