#include "studio/window/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>

#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"
#include "studio/window/language.h"

namespace idap {

namespace {

struct Pattern {
  const char* id;
  const char* name;
};
// As Sweet Home 3D names them in its files.
constexpr Pattern kPatterns[] = {
    {"", QT_TRANSLATE_NOOP("idap::PreferencesDialog", "Solid")},
    {"hatchUp", QT_TRANSLATE_NOOP("idap::PreferencesDialog", "Hatched upwards")},
    {"hatchDown", QT_TRANSLATE_NOOP("idap::PreferencesDialog", "Hatched downwards")},
    {"crossHatch", QT_TRANSLATE_NOOP("idap::PreferencesDialog", "Cross-hatched")}};

}  // namespace

PreferencesDialog::PreferencesDialog(Preferences& preferences, QWidget* parent)
    : FormDialog("preferencesDialog", parent), preferences_(preferences) {
  const EditorSettings& settings = preferences.editor();
  const auto combo = [this](const char* name) {
    auto* box = new QComboBox(this);
    box->setObjectName(QLatin1String(name));
    return box;
  };
  const auto check = [this](const char* name, bool on) {
    auto* box = new QCheckBox(this);
    box->setObjectName(QLatin1String(name));
    box->setChecked(on);
    return box;
  };
  languageLabel_ = addRow(language_ = combo("language"));
  unitLabel_ = addRow(unit_ = combo("unit"));
  themeLabel_ = addRow(theme_ = combo("theme"));
  for (const Language& language : languages())
    language_->addItem(QString::fromUtf8(language.name), QLatin1String(language.code));
  language_->setCurrentIndex(language_->findData(preferences.language()));
  for (const LengthUnit unit :
       {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre, LengthUnit::FeetInches})
    unit_->addItem(QString(), int(unit));
  unit_->setCurrentIndex(unit_->findData(int(settings.unit)));
  for (int i = 0; i < 3; ++i) theme_->addItem(QString());
  theme_->setCurrentIndex(int(preferences.theme()));

  drawing_ = new QGroupBox(this);
  auto* drawing = new QVBoxLayout(drawing_);
  drawing->addWidget(snapping_ = check("snapping", settings.snapping));
  drawing->addWidget(gridSnapping_ = check("gridSnapping", settings.gridSnapping));
  drawing->addWidget(grid_ = check("gridShown", settings.gridShown));
  drawing->addWidget(rulers_ = check("rulersShown", settings.rulersShown));
  drawing->addWidget(below_ = check("levelBelow", settings.levelBelowShown));
  drawing->addWidget(areas_ = check("roomAreas", settings.roomAreas));
  addWide(drawing_);

  walls_ = new QGroupBox(this);
  auto* walls = new QFormLayout(walls_);
  thickness_ = new LengthField(walls_, settings.unit);
  thickness_->setObjectName(QStringLiteral("wallThickness"));
  thickness_->setRange(0.01, 2);
  thickness_->setValue(settings.wallThickness);
  height_ = new LengthField(walls_, settings.unit);
  height_->setObjectName(QStringLiteral("wallHeight"));
  height_->setRange(0.1, 50);
  height_->setOptional(true);
  if (settings.wallHeight > 0)
    height_->setValue(settings.wallHeight);
  else
    height_->setNone();
  pattern_ = combo("wallPattern");
  for (const Pattern& pattern : kPatterns) pattern_->addItem(QString(), QLatin1String(pattern.id));
  pattern_->setCurrentIndex(std::max(0, pattern_->findData(toQt(settings.wallPattern))));
  walls->addRow(thicknessLabel_ = new QLabel(walls_), thickness_);
  walls->addRow(heightLabel_ = new QLabel(walls_), height_);
  walls->addRow(patternLabel_ = new QLabel(walls_), pattern_);
  thicknessLabel_->setBuddy(thickness_);
  heightLabel_->setBuddy(height_);
  patternLabel_->setBuddy(pattern_);
  addWide(walls_);
  connect(unit_, &QComboBox::currentIndexChanged, this, [this] {
    const auto unit = LengthUnit(unit_->currentData().toInt());
    thickness_->setUnit(unit);
    height_->setUnit(unit);
  });
  retranslate();
}

void PreferencesDialog::retranslate() {
  setWindowTitle(tr("Preferences"));
  languageLabel_->setText(tr("&Language"));
  unitLabel_->setText(tr("&Unit of length"));
  themeLabel_->setText(tr("&Theme"));
  unit_->setItemText(0, tr("Metres"));
  unit_->setItemText(1, tr("Centimetres"));
  unit_->setItemText(2, tr("Millimetres"));
  unit_->setItemText(3, tr("Feet and inches"));
  theme_->setItemText(0, tr("As the desktop"));
  theme_->setItemText(1, tr("Light"));
  theme_->setItemText(2, tr("Dark"));
  unit_->setToolTip(tr("Lengths are shown in it; any unit can be typed"));
  drawing_->setTitle(tr("Drawing"));
  snapping_->setText(tr("&Snap to ends, lines, walls and pieces"));
  snapping_->setToolTip(tr("The Alt key turns it off while it is held"));
  gridSnapping_->setText(tr("Snap to the gr&id"));
  grid_->setText(tr("Show the &grid"));
  rulers_->setText(tr("Show the &rulers"));
  below_->setText(tr("Show the level &below faintly"));
  areas_->setText(tr("Walls that &close make a room"));
  walls_->setTitle(tr("New walls"));
  thicknessLabel_->setText(tr("Th&ickness"));
  heightLabel_->setText(tr("&Height"));
  height_->setPlaceholderText(tr("that of the home"));
  height_->setToolTip(tr("Empty: the height of the level, or of the home"));
  patternLabel_->setText(tr("&Pattern"));
  for (int i = 0; i < pattern_->count(); ++i) pattern_->setItemText(i, tr(kPatterns[i].name));
}

bool PreferencesDialog::apply() {
  EditorSettings settings = preferences_.editor();
  settings.language = fromQt(language_->currentData().toString());
  settings.unit = LengthUnit(unit_->currentData().toInt());
  settings.snapping = snapping_->isChecked();
  settings.gridSnapping = gridSnapping_->isChecked();
  settings.gridShown = grid_->isChecked();
  settings.rulersShown = rulers_->isChecked();
  settings.levelBelowShown = below_->isChecked();
  settings.roomAreas = areas_->isChecked();
  settings.wallThickness = thickness_->value();
  settings.wallHeight = height_->none() ? 0 : height_->value();
  settings.wallPattern = fromQt(pattern_->currentData().toString());
  preferences_.setTheme(Preferences::Theme(theme_->currentIndex()));
  preferences_.setEditor(settings);
  return true;
}

}  // namespace idap
