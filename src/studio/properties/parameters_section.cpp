// What can be chosen of a parametric piece (doors, shelves, …), and the hole that a staircase needs.
#include <QCheckBox>
#include <QPushButton>

#include "model/edits/piece_edits.h"
#include "studio/properties/part_names.h"
#include "studio/properties/sections.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/number_field.h"

namespace idap {

namespace {

constexpr const char* kWholeFootprint = "M0,0 v1 h1 v-1 z";

// Its numbers are lengths where they are not counted and look like metres; the catalog says no more.
bool isLength(const PieceParameter& parameter) {
  static const std::set<std::string> kShares{"books", "open"};
  return !parameter.whole && parameter.max <= 3 && !kShares.contains(parameter.name);
}
bool isShare(const PieceParameter& parameter) {
  return !parameter.whole && !isLength(parameter) && parameter.max <= 1;
}

class ParametersSection : public Section {
 public:
  ParametersSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "parametersSection", QT_TRANSLATE_NOOP("idap", "Construction"), parent) {
    addCheck(
        {"stairsCutOut", QT_TRANSLATE_NOOP("idap", "Cuts the floor above"),
         QT_TRANSLATE_NOOP("idap", "Change stair opening"),
         QT_TRANSLATE_NOOP("idap", "Makes the hole in the floor above that one climbs through.")},
        [this](const Selected& s) {
          Common<bool> common;
          for (const FurnitureId id : s.all.furniture)
            if (const Furniture* piece = s.home.furniture.find(id); piece && isStaircase(*piece, s.home))
              common.add(!piece->staircaseCutOut.empty());
          return common;
        },
        [this](const Home& home, const Elements& e, bool on) {
          return changeFurniture(home, e, [&](Furniture& piece) {
            if (!isStaircase(piece, home)) return;
            const PieceFacts* facts = link().facts(piece, home);
            const std::string usual = facts && facts->piece && !facts->piece->staircaseCutOut.empty()
                                          ? facts->piece->staircaseCutOut
                                          : kWholeFootprint;
            piece.staircaseCutOut = on ? usual : std::string();
          });
        });
    onRefresh([this](const Selected& s) { showParameters(s); });
  }

 private:
  struct Row {
    QLabel* label;
    NumberField* number;
    LengthField* length;
    PieceParameter parameter;
  };

  bool isStaircase(const Furniture& piece, const Home& home) {
    if (!piece.staircaseCutOut.empty()) return true;
    const PieceFacts* facts = link().facts(piece, home);
    return facts && facts->piece && facts->piece->kind == PieceKind::Staircase;
  }

  // Those of the one catalog piece that is selected, once or several times.
  std::vector<PieceParameter> parameters(const Selected& s) {
    const auto model = s.ofPieces([](const Piece& p) { return p.model.catalogId + "\n" + p.model.asset; });
    if (!model.any || model.mixed) return {};
    const PieceFacts* facts = link().facts(*s.pieces().front(), s.home);
    return facts && facts->piece ? facts->piece->parameters : std::vector<PieceParameter>();
  }

  void showParameters(const Selected& s) {
    const std::vector<PieceParameter> shown = parameters(s);
    while (rows_.size() < shown.size()) addParameterRow();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      Row& row = rows_[i];
      const bool here = i < shown.size(), asLength = here && isLength(shown[i]);
      setRowShown(row.number->parentWidget(), here);
      if (!here) continue;
      row.parameter = shown[i];
      const QString name = parameterName(shown[i].name);
      if (row.label->text() != name) row.label->setText(name);
      row.number->setVisible(!asLength);
      row.length->setVisible(asLength);
      row.length->setUnit(s.settings.unit);
      const double scale = isShare(shown[i]) ? 100 : 1;
      row.number->setDecimals(shown[i].whole ? 0 : 1);
      row.number->setUnit(isShare(shown[i]) ? QStringLiteral(" %") : QString());
      ValueField* field = asLength ? static_cast<ValueField*>(row.length) : row.number;
      field->setObjectName(QStringLiteral("parameter-") + QString::fromStdString(shown[i].name));
      field->setAccessibleName(name);
      field->setRange(scale * shown[i].min, scale * shown[i].max);
      const auto common = s.ofPieces([&](const Piece& p) {
        const auto found = p.model.parameters.find(shown[i].name);
        return scale * (found == p.model.parameters.end() ? shown[i].value : found->second);
      });
      field->setToolTip(asLength ? QString()
                                 : Section::tr("%1 to %2").arg(field->minimum()).arg(field->maximum()));
      if (common.mixed)
        field->setMixed();
      else
        field->setValue(common.value);
    }
  }

  void addParameterRow() {
    auto* holder = new QWidget(body());
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    Row row{nullptr, new NumberField(holder), new LengthField(holder), {}};
    column->addWidget(row.number);
    column->addWidget(row.length);
    row.label = addLabelled(holder);
    addField(row.number);
    addField(row.length);
    const std::size_t index = rows_.size();
    const auto write = [this, index](const Home& home, const Elements& e, double value) {
      const PieceParameter parameter = rows_[index].parameter;
      const double stored = isShare(parameter) ? value / 100 : value;
      return changePieces(home, e, [&](Piece& p) { p.model.parameters[parameter.name] = stored; });
    };
    const RowText text{.edit = QT_TRANSLATE_NOOP("idap", "Change construction")};
    for (ValueField* field : {static_cast<ValueField*>(row.number), static_cast<ValueField*>(row.length)}) {
      connect(field, &ValueField::valueChanged, this,
              [this, text, write](double value) { apply<double>(text, write, value); });
      connect(field, &ValueField::valueStepping, this,
              [this, text, write](double value) { preview<double>(text, write, value); });
    }
    rows_.push_back(row);
  }

  std::vector<Row> rows_;
};

}  // namespace

SectionEntry parametersSection() {
  return {[](const Selected& s) { return s.kind == ElementKind::Piece; },
          [](PanelLink& link, QWidget* parent) -> Section* { return new ParametersSection(link, parent); }};
}

}  // namespace idap
