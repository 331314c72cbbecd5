#include "studio/properties/section.h"

#include <QCheckBox>
#include <QPushButton>
#include <QWheelEvent>

#include "studio/properties/calm_choice.h"
#include "studio/widgets/color_button.h"
#include "studio/widgets/length_field.h"
#include "studio/widgets/material_picker.h"
#include "studio/widgets/slider_field.h"
#include "studio/widgets/text_field.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

// Rows without a tip or a label have nothing to translate.
QString words(const char* english) { return *english ? translated(english) : QString(); }

template <class Field, class V>
void showIn(Field* field, bool mixed, const V& value) {
  if (mixed)
    field->setMixed();
  else
    field->setValue(value);
}

}  // namespace

Section::Section(PanelLink& link, const char* name, const char* title, QWidget* parent)
    : SectionBox(translated(title), QString::fromLatin1(name), parent),
      link_(link),
      title_(title),
      form_(new QFormLayout(body())) {
  setObjectName(QString::fromLatin1(name));
  form_->setContentsMargins(6, 2, 4, 6);
  form_->setVerticalSpacing(4);
  form_->setHorizontalSpacing(6);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form_->setRowWrapPolicy(QFormLayout::DontWrapRows);
  // Words take two fifths of whatever width there is, so that the fields of all sections line up.
  body()->installEventFilter(this);
}

Section::~Section() = default;

void Section::refresh(const Selected& selected) {
  elements_ = selected.elements;
  for (const auto& update : updates_) update(selected);
}

void Section::translate(const Row& row) const {
  const QString label = words(row.text.label), tip = words(row.text.tip);
  if (row.label) {
    row.label->setText(label);
    row.label->setToolTip(tip.isEmpty() ? label : label + QStringLiteral(": ") + tip);
  }
  row.field->setToolTip(tip);
  row.field->setAccessibleName(label);
  fit(row);
}

void Section::fit(const Row& row) const {
  auto* button = row.label ? nullptr : qobject_cast<QAbstractButton*>(row.field);
  if (!button) return;
  const QString label = words(row.text.label), tip = words(row.text.tip);
  const int room = body()->width() - fontMetrics().height() * (qobject_cast<QCheckBox*>(button) ? 5 : 4) / 2;
  const QString shown = fontMetrics().elidedText(label, Qt::ElideRight, std::max(room, 1));
  button->setText(shown);
  // What is cut off stands in the tooltip.
  button->setToolTip(shown == label ? tip : tip.isEmpty() ? label : label + QStringLiteral(": ") + tip);
}

void Section::retranslate() {
  setTitle(translated(title_));
  for (const Row& row : rows_) translate(row);
  for (const auto& translation : translations_) translation();
}

bool Section::bare() const {
  for (int i = 0; i < form_->rowCount(); ++i)
    if (form_->isRowVisible(i)) return false;
  return true;
}

void Section::commitTyping(bool keep) {
  for (QWidget* field : fields_) {
    if (auto* value = qobject_cast<ValueField*>(field)) {
      if (value->typing() && keep) value->commit();
      value->reset();
    } else if (auto* text = qobject_cast<TextField*>(field)) {
      if (keep) text->commit();
      text->reset();
    } else if (auto* area = qobject_cast<TextArea*>(field)) {
      if (keep) area->commit();
      area->reset();
    }
  }
}

QWidget* Section::firstField() const {
  for (QWidget* field : fields_)
    if (field->isVisible() && field->isEnabled() && field->focusPolicy() != Qt::NoFocus) return field;
  return nullptr;
}

void Section::addRow(const RowText& text, QWidget* field) {
  field->setObjectName(QString::fromLatin1(text.name));
  Row row{text, field, nullptr};
  if (qobject_cast<QCheckBox*>(field) || qobject_cast<QPushButton*>(field)) {
    form_->addRow(field);
  } else {
    row.label = addLabelled(field);
  }
  rows_.push_back(row);
  addField(field);
  translate(row);
}

QLabel* Section::addLabelled(QWidget* field) {
  auto* label = new QLabel(body());
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setBuddy(field);
  label->setFixedWidth(labelWidth());
  form_->addRow(label, field);
  return label;
}

void Section::addField(QWidget* field) {
  fields_.push_back(field->focusProxy() ? field->focusProxy() : field);
}

int Section::labelWidth() const {
  return std::max(fontMetrics().averageCharWidth() * 8, body()->width() * 2 / 5);
}

bool Section::eventFilter(QObject* watched, QEvent* event) {
  // Rows that come while the section is hidden know no width yet: they get theirs when it is laid out.
  const QEvent::Type type = event->type();
  if (watched == body() &&
      (type == QEvent::Resize || type == QEvent::LayoutRequest || type == QEvent::Show)) {
    if (type == QEvent::Resize)
      for (const Row& row : rows_) fit(row);
    for (int i = 0; i < form_->rowCount(); ++i)
      if (const QLayoutItem* label = form_->itemAt(i, QFormLayout::LabelRole); label && label->widget())
        label->widget()->setFixedWidth(labelWidth());
  }
  return SectionBox::eventFilter(watched, event);
}

void Section::setRowShown(QWidget* field, bool shown) {
  if (form_->isRowVisible(field) != shown) form_->setRowVisible(field, shown);
}

void Section::bind(ValueField* field, const RowText& text, const Read<double>& read,
                   const Write<double>& write, const Limits& limits) {
  addRow(text, field);
  connect(field, &ValueField::valueChanged, this,
          [this, text, write](double value) { apply(text, write, value); });
  connect(field, &ValueField::valueStepping, this,
          [this, text, write](double value) { preview(text, write, value); });
  onRefresh([this, field, read, limits](const Selected& selected) {
    const Common<double> common = read(selected);
    setRowShown(field, common.any);
    if (!common.any) return;
    if (limits) {
      const auto [low, high] = limits(selected);
      field->setRange(low, high);
    }
    showIn(field, common.mixed, common.value);
  });
}

LengthField* Section::addLength(const RowText& text, Read<double> read, Write<double> write, Limits limits) {
  auto* field = new LengthField(body(), link_.editor().settings().unit);
  bind(field, text, read, write, limits);
  onRefresh([field](const Selected& selected) { field->setUnit(selected.settings.unit); });
  return field;
}

NumberField* Section::addAngle(const RowText& text, Read<double> read, Write<double> write) {
  auto* field = new AngleField(body());
  field->setRange(-3600, 3600);
  bind(field, text, read, write, {});
  return field;
}

NumberField* Section::addNumber(const RowText& text, const QString& unit, int decimals, Read<double> read,
                                Write<double> write, Limits limits) {
  auto* field = new NumberField(body(), unit, decimals);
  bind(field, text, read, write, limits);
  return field;
}

NumberField* Section::addOptionalNumber(const RowText& text, int decimals, Read<std::optional<double>> read,
                                        Write<std::optional<double>> write) {
  auto* field = new NumberField(body(), {}, decimals);
  field->setOptional(true);
  addRow(text, field);
  connect(field, &ValueField::valueChanged, this,
          [this, text, write](double value) { apply(text, write, std::optional(value)); });
  connect(field, &ValueField::cleared, this,
          [this, text, write] { apply(text, write, std::optional<double>()); });
  onRefresh([this, field, read](const Selected& selected) {
    const auto common = read(selected);
    setRowShown(field, common.any);
    if (common.mixed)
      field->setMixed();
    else if (common.value)
      field->setValue(*common.value);
    else
      field->setNone();
  });
  return field;
}

SliderField* Section::addSlider(const RowText& text, double min, double max, double step, const QString& unit,
                                Read<std::optional<double>> read, Write<double> write,
                                const char* noneWords) {
  auto* field = new SliderField(min, max, step, unit, 0, body());
  addRow(text, field);
  connect(field, &SliderField::valueChanging, this,
          [this, text, write](double value) { preview(text, write, value); });
  connect(field, &SliderField::valueChanged, this,
          [this, text, write](double value) { apply(text, write, value); });
  onRefresh([this, field, read, noneWords](const Selected& selected) {
    const auto common = read(selected);
    setRowShown(field, common.any);
    if (!common.any) return;
    if (common.mixed)
      field->setMixed();
    else if (common.value)
      field->setValue(*common.value);
    else
      field->setNone(words(noneWords));
  });
  return field;
}

QCheckBox* Section::addCheck(const RowText& text, Read<bool> read, Write<bool> write) {
  auto* box = new QCheckBox(body());
  // May be narrower than its words, like every field of the panel.
  box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  addRow(text, box);
  connect(box, &QCheckBox::clicked, this, [this, box, text, write] {
    // Of several that differ, the first click switches all on.
    box->setTristate(false);
    apply(text, write, box->isChecked());
  });
  onRefresh([this, box, read](const Selected& selected) {
    const Common<bool> common = read(selected);
    setRowShown(box, common.any);
    box->setTristate(common.mixed);
    box->setCheckState(common.mixed ? Qt::PartiallyChecked : common.value ? Qt::Checked : Qt::Unchecked);
  });
  return box;
}

TextField* Section::addText(const RowText& text, Read<std::string> read, Write<std::string> write) {
  auto* field = new TextField(body());
  addRow(text, field);
  connect(field, &TextField::valueChanged, this,
          [this, text, write](const QString& value) { apply(text, write, fromQt(value)); });
  onRefresh([this, field, read](const Selected& selected) {
    const Common<std::string> common = read(selected);
    setRowShown(field, common.any);
    showIn(field, common.mixed, toQt(common.value));
  });
  return field;
}

TextArea* Section::addTextArea(const RowText& text, int lines, Read<std::string> read,
                               Write<std::string> write) {
  auto* field = new TextArea(body());
  field->setLines(lines);
  addRow(text, field);
  connect(field, &TextArea::valueChanged, this,
          [this, text, write](const QString& value) { apply(text, write, fromQt(value)); });
  onRefresh([this, field, read](const Selected& selected) {
    const Common<std::string> common = read(selected);
    setRowShown(field, common.any);
    showIn(field, common.mixed, toQt(common.value));
  });
  return field;
}

QComboBox* Section::addChoice(const RowText& text, std::vector<const char*> options, Read<int> read,
                              Write<int> write) {
  auto* choice = new CalmChoice(body());
  for (const char* option : options) choice->addItem(translated(option));
  addRow(text, choice);
  translations_.push_back([choice, options] {
    for (std::size_t i = 0; i < options.size(); ++i)
      choice->setItemText(static_cast<int>(i), translated(options[i]));
  });
  connect(choice, &QComboBox::activated, this, [this, text, write](int index) { apply(text, write, index); });
  onRefresh([this, choice, read](const Selected& selected) {
    const Common<int> common = read(selected);
    setRowShown(choice, common.any);
    choice->setPlaceholderText(common.mixed ? TextField::tr("Several values") : QString());
    const int index = common.mixed ? -1 : common.value;
    if (choice->currentIndex() != index) choice->setCurrentIndex(index);
  });
  return choice;
}

ColorButton* Section::addColor(const RowText& text, const char* noneWords, Read<std::optional<Color>> read,
                               Write<std::optional<Color>> write) {
  auto* button = new ColorButton(body());
  const auto name = [button, noneWords] {
    if (*noneWords) button->setOptional(true, translated(noneWords));
  };
  name();
  translations_.push_back(name);
  addRow(text, button);
  connect(button, &ColorButton::colorChanging, this,
          [this, text, write](const Color& color) { preview(text, write, std::optional(color)); });
  connect(button, &ColorButton::colorAbandoned, this, [this] { link_.abandon(); });
  connect(button, &ColorButton::colorChanged, this,
          [this, text, write](const std::optional<Color>& color) { apply(text, write, color); });
  onRefresh([this, button, read](const Selected& selected) {
    const auto common = read(selected);
    setRowShown(button, common.any);
    if (common.mixed)
      button->setMixed();
    else if (!link_.live())
      button->setColor(common.value);
  });
  return button;
}

void Section::choose(const RowText& text, const Write<Finish>& write, const FinishChoice& choice) {
  link_.apply(text.edit,
              [&](const Home& home) { return write(withAsset(home, choice), elements_, choice.finish); });
}

MaterialPicker* Section::addFinish(const RowText& text, const char* plainWords, Read<Finish> read,
                                   Write<Finish> write, std::optional<Color> plain) {
  auto* picker = new MaterialPicker(body());
  const auto name = [picker, plainWords, plain] { picker->setPlain(translated(plainWords), plain); };
  name();
  translations_.push_back(name);
  addRow(text, picker);
  connect(picker, &MaterialPicker::finishChosen, this,
          [this, text, write](const FinishChoice& choice) { choose(text, write, choice); });
  onRefresh([this, picker, read](const Selected& selected) {
    const Common<Finish> common = read(selected);
    setRowShown(picker, common.any);
    picker->setLanguage(selected.settings.language);
    picker->setUnit(selected.settings.unit);
    if (common.mixed)
      picker->setMixed();
    else
      picker->setFinish(common.value, selected.home.assets);
  });
  return picker;
}

QLabel* Section::addInfo(const RowText& text, std::function<QString(const Selected&)> read) {
  auto* label = new QLabel(body());
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  label->setMinimumWidth(1);
  addRow(text, label);
  fields_.pop_back();  // the keyboard passes it
  onRefresh([this, label, read](const Selected& selected) {
    const QString shown = read(selected);
    setRowShown(label, !shown.isEmpty());
    if (label->text() != shown) label->setText(shown);
  });
  return label;
}

QPushButton* Section::addButton(const RowText& text, std::function<bool(const Selected&)> shown,
                                std::function<void()> pressed) {
  auto* button = new QPushButton(body());
  button->setAutoDefault(false);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  addRow(text, button);
  connect(button, &QPushButton::clicked, this, [pressed] { pressed(); });
  onRefresh([this, button, shown](const Selected& selected) { setRowShown(button, shown(selected)); });
  return button;
}

}  // namespace idap
