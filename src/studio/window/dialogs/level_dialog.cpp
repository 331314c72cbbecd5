#include "studio/window/dialogs/level_dialog.h"

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "model/edits/level_edits.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/texts.h"

namespace idap {

LevelDialog::LevelDialog(Editor& editor, QWidget* parent)
    : FormDialog("levelDialog", parent), editor_(editor), id_(editor.level()) {
  const LengthUnit unit = editor.settings().unit;
  const auto length = [&](const char* name, double value, double least, double most) {
    auto* field = new LengthField(this, unit);
    field->setObjectName(QLatin1String(name));
    field->setRange(least, most);
    field->setValue(value);
    return field;
  };
  if (const Level* level = editor.home().levels.find(id_)) {
    name_ = new QLineEdit(toQt(level->name), this);
    name_->setObjectName(QStringLiteral("name"));
    nameLabel_ = addRow(name_);
    elevationLabel_ = addRow(elevation_ = length("elevation", level->elevation, -1000, 1000));
    heightLabel_ = addRow(height_ = length("height", level->height, 0.1, 100));
    floorLabel_ = addRow(floor_ = length("floorThickness", level->floorThickness, 0, 10));
    visible_ = new QCheckBox(this);
    viewable_ = new QCheckBox(this);
    visible_->setObjectName(QStringLiteral("visible"));
    viewable_->setObjectName(QStringLiteral("viewable"));
    visible_->setChecked(level->visible);
    viewable_->setChecked(level->viewable);
    form()->addRow(visible_);
    form()->addRow(viewable_);
    name_->setFocus();
    name_->selectAll();
  } else {
    heightLabel_ = addRow(height_ = length("height", editor.home().wallHeight, 0.1, 100));
  }
  retranslate();
}

void LevelDialog::retranslate() {
  setWindowTitle(tr("Level"));
  heightLabel_->setText(tr("&Height of the rooms"));
  height_->setToolTip(tr("From the floor to the ceiling; new walls are this high"));
  if (!name_) return;
  nameLabel_->setText(tr("&Name"));
  elevationLabel_->setText(tr("&Elevation"));
  floorLabel_->setText(tr("&Floor thickness"));
  elevation_->setToolTip(tr("Of the top of its floor above the ground"));
  floor_->setToolTip(tr("Of the slab under this level"));
  visible_->setText(tr("&Visible"));
  visible_->setToolTip(tr("Seen in pictures and, faintly, under the level above"));
  viewable_->setText(tr("&In use"));
  viewable_->setToolTip(tr("Counts when the home is built; a level kept for later does not"));
}

bool LevelDialog::apply() {
  return editor_.apply(QT_TRANSLATE_NOOP("idap", "Change level"), [this](const Home& home) {
    const Level* before = home.levels.find(id_);
    if (!before || !name_) {
      Home changed = home;
      changed.wallHeight = height_->value();
      return changed;
    }
    Level level = *before;
    level.name = fromQt(name_->text());
    level.elevation = elevation_->value();
    level.height = height_->value();
    level.floorThickness = floor_->value();
    level.visible = visible_->isChecked();
    level.viewable = viewable_->isChecked();
    return setLevel(home, id_, level);
  });
}

}  // namespace idap
