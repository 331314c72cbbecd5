// What can be chosen of a parametric piece (doors, shelves, …), and the hole that a staircase needs.
#include <QCheckBox>

#include "model/edits/piece_edits.h"
#include "studio/properties/calm_choice.h"
#include "studio/properties/part_names.h"
#include "studio/properties/sections.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/number_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr const char* kWholeFootprint = "M0,0 v1 h1 v-1 z";

using Kind = PieceParameter::Kind;

class ParametersSection : public Section {
 public:
  ParametersSection(PanelLink& panelLink, QWidget* parent)
      : Section(panelLink, "parametersSection", QT_TRANSLATE_NOOP("idap", "Parameters"), parent) {
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
  // One field of each kind, of which one is there.
  struct Row {
    QLabel* label;
    NumberField* number;
    LengthField* length;
    QComboBox* choice;
    QCheckBox* check;
    PieceParameter parameter;
    std::string options;  // what the choice was filled with
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
      setRowShown(rows_[i].number->parentWidget(), i < shown.size());
      if (i < shown.size()) showParameter(rows_[i], shown[i], s);
    }
  }

  static QWidget* fieldOf(const Row& row) {
    switch (row.parameter.kind) {
      case Kind::Switch:
        return row.check;
      case Kind::Choice:
        return row.choice;
      case Kind::Length:
        return row.length;
      default:
        return row.number;
    }
  }

  void showParameter(Row& row, const PieceParameter& parameter, const Selected& s) {
    row.parameter = parameter;
    const QString name = parameterName(parameter);
    if (row.label->text() != name) row.label->setText(name);
    QWidget* shown = fieldOf(row);
    for (QWidget* field : std::initializer_list<QWidget*>{row.number, row.length, row.choice, row.check}) {
      field->setVisible(field == shown);
      if (field != shown) field->setObjectName(QString());
    }
    shown->setObjectName(QStringLiteral("parameter-") + toQt(parameter.name));
    shown->setAccessibleName(name);
    const auto common = s.ofPieces([&](const Piece& p) {
      const auto found = p.model.parameters.find(parameter.name);
      const double value = found == p.model.parameters.end() ? parameter.value : found->second;
      return std::clamp(value, parameter.min, parameter.max);
    });
    if (parameter.kind == Kind::Switch) {
      row.check->setTristate(common.mixed);
      row.check->setCheckState(common.mixed        ? Qt::PartiallyChecked
                               : common.value != 0 ? Qt::Checked
                                                   : Qt::Unchecked);
    } else if (parameter.kind == Kind::Choice) {
      fillChoice(row);
      row.choice->setPlaceholderText(common.mixed ? Section::tr("Several values") : QString());
      row.choice->setCurrentIndex(common.mixed ? -1 : static_cast<int>(std::lround(common.value)));
    } else {
      showNumber(row, common.mixed, common.value, s.settings.unit);
    }
  }

  static void fillChoice(Row& row) {
    QStringList labels;
    for (const PieceParameter::Option& option : row.parameter.choices)
      labels << translated(option.label.c_str());
    const std::string all = fromQt(labels.join(QLatin1Char('\n')));
    if (all == row.options) return;
    row.options = all;
    row.choice->clear();
    row.choice->addItems(labels);
  }

  static void showNumber(Row& row, bool mixed, double value, LengthUnit unit) {
    const PieceParameter& parameter = row.parameter;
    const bool share = parameter.kind == Kind::Share;
    const double scale = share ? 100 : 1;
    row.length->setUnit(unit);
    row.number->setDecimals(parameter.whole || share ? 0 : 1);
    row.number->setUnit(share                           ? QStringLiteral(" %")
                        : parameter.kind == Kind::Angle ? QStringLiteral("°")
                                                        : QString());
    const bool length = parameter.kind == Kind::Length;
    ValueField* field = length ? static_cast<ValueField*>(row.length) : row.number;
    field->setRange(scale * parameter.min, scale * parameter.max);
    field->setToolTip(
        length ? Section::tr("%1 to %2").arg(lengthText(parameter.min, unit), lengthText(parameter.max, unit))
               : Section::tr("%1 to %2").arg(field->minimum()).arg(field->maximum()));
    if (mixed)
      field->setMixed();
    else
      field->setValue(scale * value);
  }

  void addParameterRow() {
    auto* holder = new QWidget(body());
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    Row row{nullptr,
            new NumberField(holder),
            new LengthField(holder),
            new CalmChoice(holder),
            new QCheckBox(holder),
            {},
            {}};
    for (QWidget* field : std::initializer_list<QWidget*>{row.number, row.length, row.choice, row.check}) {
      column->addWidget(field);
      addField(field);
    }
    row.label = addLabelled(holder);
    const std::size_t index = rows_.size();
    const auto write = [this, index](const Home& home, const Elements& e, double value) {
      const PieceParameter parameter = rows_[index].parameter;
      const double stored = parameter.kind == Kind::Share ? value / 100 : value;
      return changePieces(home, e, [&](Piece& p) { p.model.parameters[parameter.name] = stored; });
    };
    const RowText text{.edit = QT_TRANSLATE_NOOP("idap", "Change parameters")};
    for (ValueField* field : {static_cast<ValueField*>(row.number), static_cast<ValueField*>(row.length)}) {
      connect(field, &ValueField::valueChanged, this,
              [this, text, write](double value) { apply<double>(text, write, value); });
      connect(field, &ValueField::valueStepping, this,
              [this, text, write](double value) { preview<double>(text, write, value); });
    }
    connect(row.choice, &QComboBox::activated, this,
            [this, text, write](int chosen) { apply<double>(text, write, chosen); });
    connect(row.check, &QCheckBox::clicked, this, [this, text, write, check = row.check] {
      check->setTristate(false);
      apply<double>(text, write, check->isChecked() ? 1 : 0);
    });
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
