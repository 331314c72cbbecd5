#include "studio/catalog/part_finishes.h"

#include <QFormLayout>
#include <QLabel>
#include <algorithm>

#include "studio/properties/part_names.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::size_t kMostRows = 200;  // some models have a material for every screw

}  // namespace

PartFinishes::PartFinishes(QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("importParts"));
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setMinimumHeight(5 * fontMetrics().height());
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void PartFinishes::show(const ModelImport& model, const EditorSettings& settings) {
  chosen_.clear();
  pictures_.clear();
  parts_.clear();
  auto* rows = new QWidget;
  auto* form = new QFormLayout(rows);
  form->setContentsMargins(0, 0, 0, 0);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  for (const ModelImport::Part& part : model.parts) {
    const auto same = [&](const ModelImport::Part& other) { return other.name == part.name; };
    if (parts_.size() >= kMostRows || std::any_of(parts_.begin(), parts_.end(), same)) continue;
    parts_.push_back(part);
    const QString name = part.name.empty() ? tr("Part %1").arg(parts_.size()) : partName(part.name);
    auto* picker = new MaterialPicker;
    picker->setObjectName(QStringLiteral("importPart-") + toQt(part.name));
    picker->setAccessibleName(name);
    picker->setPlain(part.pictured ? tr("Picture of the file") : tr("As in the file"), part.color);
    picker->setLanguage(settings.language);
    picker->setUnit(settings.unit);
    picker->setToolTip(tr("Material, colour or picture of this part."));
    auto* label = new QLabel(fontMetrics().elidedText(name, Qt::ElideRight, 12 * fontMetrics().height()));
    label->setToolTip(name);
    label->setTextFormat(Qt::PlainText);
    label->setBuddy(picker);
    form->addRow(label, picker);
    connect(picker, &MaterialPicker::finishChosen, this,
            [this, picker, slot = part.name](const FinishChoice& choice) {
              if (choice.finish.empty())
                chosen_.erase(slot);
              else
                chosen_[slot] = choice.finish;
              if (choice.asset) pictures_[choice.assetName] = choice.asset;
              picker->setFinish(choice.finish, std::make_shared<const Assets>(pictures_));
              emit changed();
            });
  }
  setWidget(rows);
}

SlotFinishes PartFinishes::finishes() const {
  SlotFinishes finishes = chosen_;
  if (!keep_)
    for (const ModelImport::Part& part : parts_)
      if (part.pictured && !finishes.contains(part.name)) finishes[part.name] = plain(part.color);
  return finishes;
}

void PartFinishes::setKeepsPictures(bool keep) {
  keep_ = keep;
  emit changed();
}

bool PartFinishes::pictured() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const auto& part) { return part.pictured; });
}

}  // namespace idap
