// How a piece looks: as a whole, part by part of its model, how shiny.
#include "catalog/material.h"
#include "model/edits/piece_edits.h"
#include "studio/properties/part_names.h"
#include "studio/properties/sections.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

class FinishSection : public Section {
 public:
  FinishSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "finishSection", QT_TRANSLATE_NOOP("idap", "Finish"), parent) {
    addFinish(
        {"pieceFinish", QT_TRANSLATE_NOOP("idap", "All of it"), QT_TRANSLATE_NOOP("idap", "Change finish"),
         QT_TRANSLATE_NOOP("idap", "Material, colour or picture of the whole piece.")},
        QT_TRANSLATE_NOOP("idap", "As it comes"),
        [](const Selected& s) { return s.ofPieces([](const Piece& p) { return p.finish; }); },
        [](const Home& home, const Elements& e, const Finish& finish) {
          return changePieces(home, e, [&](Piece& p) { p.finish = finish; });
        });
    addSlider(
        {"pieceShine", QT_TRANSLATE_NOOP("idap", "Shininess"), QT_TRANSLATE_NOOP("idap", "Change shininess"),
         QT_TRANSLATE_NOOP("idap", "From matt to a mirror, of the whole piece.")},
        0, 100, 1, QStringLiteral(" %"),
        [](const Selected& s) {
          return s.ofPieces([](const Piece& p) {
            return p.finish.roughness ? std::optional(100 * (1 - *p.finish.roughness))
                                      : std::optional<double>();
          });
        },
        [](const Home& home, const Elements& e, double percent) {
          return changePieces(home, e, [&](Piece& p) { p.finish.roughness = 1 - percent / 100; });
        },
        QT_TRANSLATE_NOOP("idap", "usual"));
    waiting_ = new QLabel(body());
    waiting_->setWordWrap(true);
    form()->addRow(waiting_);
    onRefresh([this](const Selected& s) { showSlots(s); });
  }

 private:
  struct SlotRow {
    QLabel* label;
    MaterialPicker* picker;
    std::string slot;
  };

  void showSlots(const Selected& s) {
    // Parts are those of one model; of several models they would mean nothing.
    const auto model = s.ofPieces([](const Piece& p) { return p.model.catalogId + "\n" + p.model.asset; });
    const std::vector<const Piece*> pieces = s.pieces();
    const PieceFacts* facts = nullptr;
    QString words;
    if (model.any && !model.mixed) {
      facts = link().facts(*pieces.front(), s.home);
      if (!facts)
        words = Section::tr("Reading the parts of the model…");
      else if (!facts->problem.empty())
        words = Section::tr("The model cannot be read: %1").arg(toQt(facts->problem));
    }
    setRowShown(waiting_, !words.isEmpty());
    waiting_->setText(words);
    const std::size_t shown = facts && facts->parts.size() > 0 ? facts->parts.size() : 0;
    while (rows_.size() < shown) addSlotRow();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      SlotRow& row = rows_[i];
      setRowShown(row.picker, i < shown);
      if (i < shown) showSlot(row, facts->parts[i], s);
    }
  }

  void showSlot(SlotRow& row, const PieceFacts::Slot& slot, const Selected& s) {
    row.slot = slot.name;
    const QString name = partName(slot.name);
    if (row.label->text() != name) row.label->setText(name);
    row.label->setToolTip(name);
    row.picker->setAccessibleName(name);
    row.picker->setObjectName(QStringLiteral("slot-") + toQt(slot.name));
    QString words = Section::tr("As it comes");
    if (!slot.material.empty()) {
      words = toQt(materialName(slot.material, s.settings.language));
      if (slot.color) words = Section::tr("%1, tinted").arg(words);
    }
    row.picker->setPlain(words, slot.color, slot.material);
    row.picker->setLanguage(s.settings.language);
    row.picker->setUnit(s.settings.unit);
    const auto common = s.ofPieces([&](const Piece& p) {
      const auto found = p.slotFinishes.find(slot.name);
      return found == p.slotFinishes.end() ? Finish{} : found->second;
    });
    if (common.mixed)
      row.picker->setMixed();
    else
      row.picker->setFinish(common.value, s.home.assets);
  }

  void addSlotRow() {
    auto* picker = new MaterialPicker(body());
    picker->setToolTip(Section::tr("Material, colour or picture of this part."));
    QLabel* label = addLabelled(picker);
    addField(picker);
    const std::size_t index = rows_.size();
    rows_.push_back({label, picker, {}});
    connect(picker, &MaterialPicker::finishChosen, this, [this, index](const FinishChoice& choice) {
      const std::string slot = rows_[index].slot;
      choose(
          {.edit = QT_TRANSLATE_NOOP("idap", "Change finish")},
          [slot](const Home& home, const Elements& e, const Finish& finish) {
            return changePieces(home, e, [&](Piece& p) {
              if (finish.empty())
                p.slotFinishes.erase(slot);
              else
                p.slotFinishes[slot] = finish;
            });
          },
          choice);
    });
  }

  QLabel* waiting_;
  std::vector<SlotRow> rows_;
};

}  // namespace

SectionEntry finishSection() {
  return {[](const Selected& s) {
            return (s.kind == ElementKind::Piece || s.kind == ElementKind::Group) &&
                   s.ofPieces([](const Piece& p) { return p.visible; }).any;
          },
          [](PanelLink& link, QWidget* parent) -> Section* { return new FinishSection(link, parent); }};
}

}  // namespace idap
