#include "studio/picture/picture_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QFormLayout>
#include <QListWidget>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QToolButton>
#include <cmath>

#include "base/error.h"
#include "render/film/film.h"
#include "studio/picture/picture_sizes.h"
#include "studio/widgets/home_clock.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr qulonglong kLive = ~0ull, kAbove = 0;
constexpr int kClassic = 3;  // of the looks; the others are PictureTone
constexpr double kApertures[] = {0, 8, 2.8, 1.4};
constexpr int kSamples[] = {16, 64, 256};  // draft, good, best; then by time

}  // namespace

struct PictureForm::Impl {
  PictureForm& form;
  Editor& editor;
  int subscription = 0;
  std::function<Camera()> live;

  QFormLayout* rows = nullptr;
  QListWidget* views = nullptr;
  QComboBox *size = nullptr, *proportion = nullptr, *quality = nullptr, *look = nullptr, *lamps = nullptr,
            *sharpness = nullptr;
  QSpinBox *width = nullptr, *height = nullptr, *seconds = nullptr;
  QToolButton* turn = nullptr;
  SliderField* brightness = nullptr;
  QCheckBox *ownTime = nullptr, *upright = nullptr;
  QDateTimeEdit* time = nullptr;
  QLabel* trouble = nullptr;
  QPushButton* begin = nullptr;
  std::vector<std::pair<QLabel*, const char*>> labels;

  Impl(PictureForm& f, Editor& e) : form(f), editor(e) {}
  void build();
  void fill();  // words
  void listViews();
  void chooseSize(int index);
  void keepProportion(bool byWidth);
  void update();
  void tick(QListWidgetItem* item, bool on) { item->setCheckState(on ? Qt::Checked : Qt::Unchecked); }
};

void PictureForm::Impl::build() {
  views = new QListWidget;
  views->setObjectName(QStringLiteral("pictureViews"));
  views->setMinimumHeight(6 * form.fontMetrics().height());
  const auto combo = [](const char* name) {
    auto* made = new QComboBox;
    made->setObjectName(QLatin1String(name));
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(14);
    return made;
  };
  size = combo("pictureSize");
  proportion = combo("pictureProportion");
  quality = combo("pictureQuality");
  look = combo("pictureLook");
  lamps = combo("pictureLamps");
  sharpness = combo("pictureSharpness");
  brightness = new SliderField(-3, 3, 0.1, QString(), 1);
  brightness->setObjectName(QStringLiteral("pictureBrightness"));
  brightness->setValue(0);
  upright = new QCheckBox;
  upright->setObjectName(QStringLiteral("pictureUpright"));
  const auto pixels = [](const char* name, int value) {
    auto* made = new QSpinBox;
    made->setObjectName(QLatin1String(name));
    made->setRange(16, 16384);
    made->setValue(value);
    made->setKeyboardTracking(false);
    return made;
  };
  width = pixels("pictureWidth", 1280);
  height = pixels("pictureHeight", 800);
  turn = toolButton("rotate-right", "pictureTurn", &form);
  seconds = new QSpinBox;
  seconds->setObjectName(QStringLiteral("pictureSeconds"));
  seconds->setRange(1, 36000);
  seconds->setValue(60);
  ownTime = new QCheckBox;
  ownTime->setObjectName(QStringLiteral("pictureOwnTime"));
  time = new QDateTimeEdit;
  time->setObjectName(QStringLiteral("pictureTime"));
  time->setDateRange(QDate(1900, 1, 1), QDate(2199, 12, 31));
  time->setEnabled(false);
  trouble = new QLabel;
  trouble->setObjectName(QStringLiteral("pictureTrouble"));
  trouble->setWordWrap(true);
  begin = new QPushButton(icon("ray-trace"), {});
  begin->setObjectName(QStringLiteral("pictureBegin"));
  begin->setMinimumHeight(2 * form.fontMetrics().height());
  begin->setDefault(true);

  auto* across = new QHBoxLayout;
  across->addWidget(width, 1);
  across->addWidget(new QLabel(QStringLiteral("×")));
  across->addWidget(height, 1);
  across->addWidget(turn);
  auto* column = new QVBoxLayout(&form);
  const auto heading = [&](const char* words, QWidget* of) {
    auto* label = new QLabel;
    label->setBuddy(of);
    labels.emplace_back(label, words);
    return label;
  };
  const auto row = [&](const char* words, QWidget* field) { rows->addRow(heading(words, field), field); };
  column->addWidget(heading(QT_TRANSLATE_NOOP("idap", "&Points of view"), views));
  column->addWidget(views, 1);
  rows = new QFormLayout;
  rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  rows->setRowWrapPolicy(QFormLayout::DontWrapRows);
  row(QT_TRANSLATE_NOOP("idap", "L&ook"), look);
  row(QT_TRANSLATE_NOOP("idap", "S&ize"), size);
  row(QT_TRANSLATE_NOOP("idap", "Proportio&ns"), proportion);
  rows->addRow(heading(QT_TRANSLATE_NOOP("idap", "Pi&xels"), width), across);
  row(QT_TRANSLATE_NOOP("idap", "&Quality"), quality);
  row(QT_TRANSLATE_NOOP("idap", "S&econds"), seconds);
  row(QT_TRANSLATE_NOOP("idap", "&Lamps"), lamps);
  row(QT_TRANSLATE_NOOP("idap", "&Brightness"), brightness);
  row(QT_TRANSLATE_NOOP("idap", "S&harpness"), sharpness);
  rows->addRow(upright);
  rows->addRow(ownTime, time);
  column->addLayout(rows);
  column->addWidget(trouble);
  column->addWidget(begin);

  connect(views, &QListWidget::itemChanged, &form, [this] { update(); });
  connect(size, &QComboBox::activated, &form, [this](int index) { chooseSize(index); });
  connect(proportion, &QComboBox::activated, &form, [this] { keepProportion(true); });
  connect(width, &QSpinBox::valueChanged, &form, [this] { keepProportion(true); });
  connect(height, &QSpinBox::valueChanged, &form, [this] { keepProportion(false); });
  connect(turn, &QToolButton::clicked, &form, [this] {
    const QSignalBlocker quietWidth(width), quietHeight(height);
    const int was = width->value();
    width->setValue(height->value());
    height->setValue(was);
    proportion->setCurrentIndex(0);
    update();
  });
  connect(look, &QComboBox::activated, &form, [this](int index) {
    if (index != kClassic) return update();
    const QSignalBlocker quietWidth(width), quietHeight(height);  // 1993's own size, to begin with
    width->setValue(320);
    height->setValue(200);
    proportion->setCurrentIndex(0);
    update();
  });
  connect(quality, &QComboBox::activated, &form, [this] { update(); });
  connect(ownTime, &QCheckBox::toggled, &form, [this](bool on) {
    time->setEnabled(on);
    update();
  });
  connect(begin, &QPushButton::clicked, &form, &PictureForm::requested);
}

void PictureForm::Impl::fill() {
  for (const auto& [label, words] : labels) label->setText(translated(words));
  const auto refill = [](QComboBox* box, const QStringList& words) {
    const int was = box->currentIndex();
    const QSignalBlocker quiet(box);
    box->clear();
    box->addItems(words);
    box->setCurrentIndex(std::max(0, was));
  };
  QStringList sizes, proportions;
  for (const PictureSize& s : pictureSizes()) {
    const QString pixels = QStringLiteral("%1 × %2").arg(s.width).arg(s.height);
    sizes << (*s.name ? translated(s.name) + QStringLiteral("  (") + pixels + QLatin1Char(')') : pixels);
  }
  sizes << tr("Own size");
  for (const PictureProportion& p : pictureProportions()) proportions << translated(p.name);
  const bool first = size->count() == 0;
  refill(size, sizes);
  if (first) size->setCurrentIndex(2);
  refill(proportion, proportions);
  const bool firstQuality = quality->count() == 0;
  refill(quality, {tr("Draft"), tr("Good"), tr("Best"), tr("By time")});
  if (firstQuality) quality->setCurrentIndex(1);
  refill(look, {tr("Ray-traced light"), tr("Ray-traced, like film"), tr("Brightness as colour"),
                tr("Classic, as in 1993")});
  look->setItemData(1, tr("Softer contrast; bright lights turn white"), Qt::ToolTipRole);
  look->setItemData(2, tr("Blue is dark, green a middle grey, red as bright as the screen can show"),
                    Qt::ToolTipRole);
  refill(sharpness,
         {tr("All is sharp"), tr("A little blur, f/8"), tr("Some blur, f/2.8"), tr("Much blur, f/1.4")});
  sharpness->setToolTip(
      tr("What is in the middle of the picture is sharp; what is nearer or farther is blurred"));
  brightness->setToolTip(tr("In stops, as on a camera: each makes the picture twice as bright"));
  upright->setText(tr("Keep &vertical lines vertical"));
  upright->setToolTip(
      tr("As with an architect's shift lens: walls do not lean when the view looks up or down"));
  refill(lamps, {tr("As in the home"), tr("All on"), tr("All off")});
  views->setToolTip(tr("Every point of view that is ticked becomes a picture"));
  views->setAccessibleName(tr("Points of view"));
  turn->setToolTip(tr("Upright or across"));
  ownTime->setText(tr("At another &time"));
  ownTime->setToolTip(
      tr("Day and hour of these pictures, at the home's place; otherwise the point of view's"));
  time->setDisplayFormat(QLocale().dateFormat(QLocale::ShortFormat) + QStringLiteral(" HH:mm"));
  listViews();
}

void PictureForm::Impl::listViews() {
  std::map<qulonglong, bool> ticked;
  for (int i = 0; i < views->count(); ++i)
    ticked[views->item(i)->data(Qt::UserRole).toULongLong()] = views->item(i)->checkState() == Qt::Checked;
  const bool first = ticked.empty();
  const QSignalBlocker quiet(views);
  views->clear();
  const auto add = [&](const QString& name, const char* drawing, qulonglong id) {
    auto* item = new QListWidgetItem(icon(drawing), name, views);
    item->setData(Qt::UserRole, id);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    tick(item, ticked.contains(id) && ticked[id]);
  };
  if (live) add(tr("The live view, as it is now"), "view-picture", kLive);
  add(tr("From above"), "level", kAbove);
  int number = 0;
  for (const auto& [id, camera] : editor.home().cameras) {
    ++number;
    add(camera->name.empty() ? tr("Camera %1").arg(number) : toQt(camera->name), "camera", id.value);
  }
  if (first) tick(views->item(0), true);
  update();
}

void PictureForm::Impl::chooseSize(int index) {
  if (index < 0 || index >= int(pictureSizes().size())) return update();
  const PictureSize& chosen = pictureSizes()[std::size_t(index)];
  const QSignalBlocker quietWidth(width), quietHeight(height);
  proportion->setCurrentIndex(0);
  width->setValue(chosen.width);
  height->setValue(chosen.height);
  update();
}

void PictureForm::Impl::keepProportion(bool byWidth) {
  double ratio = pictureProportions()[std::size_t(std::max(0, proportion->currentIndex()))].ratio;
  if (ratio > 0) {
    const QSignalBlocker quietWidth(width), quietHeight(height);
    if (byWidth)
      height->setValue(int(std::lround(width->value() / ratio)));
    else
      width->setValue(int(std::lround(height->value() * ratio)));
  }
  update();
}

void PictureForm::Impl::update() {
  int index = int(pictureSizes().size());
  for (int i = 0; i < int(pictureSizes().size()); ++i)
    if (pictureSizes()[std::size_t(i)].width == width->value() &&
        pictureSizes()[std::size_t(i)].height == height->value())
      index = i;
  size->setCurrentIndex(index);
  const bool byTime = quality->currentIndex() == 3;
  seconds->setEnabled(byTime);
  const bool traced = look->currentIndex() != kClassic;
  brightness->setEnabled(traced);
  sharpness->setEnabled(traced);
  const QString why = form.problem();
  trouble->setText(why);
  trouble->setVisible(!why.isEmpty());
  const int count = int(form.wanted().size());
  begin->setEnabled(why.isEmpty());
  begin->setText(count > 1 ? tr("&Ray Trace %1 pictures").arg(count) : tr("&Ray Trace"));
  emit form.changed();
}

PictureForm::PictureForm(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(*this, editor)) {
  impl_->build();
  const CivilTime at = civilFromUtc(editor.home().site.time, zoneOf(editor.home()));
  impl_->time->setDateTime({QDate(at.year, at.month, at.day), QTime(at.hour, at.minute)});
  impl_->fill();
  impl_->subscription = editor.subscribe({.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document || change == Editor::Change::Home) impl_->listViews();
  }});
}

PictureForm::~PictureForm() { impl_->editor.unsubscribe(impl_->subscription); }

void PictureForm::setLiveCamera(std::function<Camera()> camera) {
  impl_->live = std::move(camera);
  impl_->views->clear();
  impl_->listViews();
}

std::vector<PictureForm::Wanted> PictureForm::wanted() const {
  const Impl& d = *impl_;
  PictureSettings all;
  all.width = d.width->value();
  all.height = d.height->value();
  all.classic = d.look->currentIndex() == kClassic;
  all.tone = all.classic ? PictureTone::Neutral : PictureTone(std::max(0, d.look->currentIndex()));
  all.brightness = all.classic ? 0 : d.brightness->value();
  all.aperture = all.classic ? 0 : kApertures[std::size_t(std::max(0, d.sharpness->currentIndex()))];
  all.upright = d.upright->isChecked();
  const int quality = d.quality->currentIndex();
  all.samples = quality >= 0 && quality < 3 ? kSamples[quality] : 0;
  if (all.classic) all.samples = std::min(all.samples, 16);  // no light to gather: only edges to smooth
  all.seconds = quality == 3 ? d.seconds->value() : 0;
  all.lamps = PictureLamps(std::max(0, d.lamps->currentIndex()));
  std::optional<std::int64_t> at;
  if (d.ownTime->isChecked()) {
    CivilTime civil;
    const QDate day = d.time->date();
    civil.year = day.year(), civil.month = day.month(), civil.day = day.day();
    civil.hour = d.time->time().hour(), civil.minute = d.time->time().minute();
    at = utcFromCivil(civil, zoneOf(d.editor.home()));
  }
  std::vector<Wanted> pictures;
  for (int i = 0; i < d.views->count(); ++i) {
    const QListWidgetItem& item = *d.views->item(i);
    if (item.checkState() != Qt::Checked) continue;
    Wanted wanted{fromQt(item.text()), all};
    const qulonglong id = item.data(Qt::UserRole).toULongLong();
    if (id == kLive) {
      wanted.settings.view = d.live();
      wanted.name = fromQt(tr("Live view"));
    } else if (id == kAbove) {
      wanted.settings.fromAbove = true;
    } else if (const Camera* camera = d.editor.home().cameras.find(CameraId{id})) {
      wanted.settings.view = *camera;
    } else {
      continue;
    }
    if (at) wanted.settings.view.time = at;
    pictures.push_back(std::move(wanted));
  }
  return pictures;
}

QString PictureForm::problem() const {
  if (wanted().empty()) return tr("Tick at least one point of view.");
  try {
    render::Film::requireSize(impl_->width->value(), impl_->height->value());
  } catch (const Error& error) {
    return toQt(error.what());
  }
  return {};
}

void PictureForm::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) impl_->fill();
}

}  // namespace idap
