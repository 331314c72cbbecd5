// One part of the property panel: rows of fields, each bound to what it reads from the selection and how it
// changes it. A new section is a class with a list of rows in its constructor and a line in the panel's
// table.
#pragma once

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

#include "model/finish.h"
#include "studio/properties/panel_link.h"
#include "studio/properties/selected.h"
#include "studio/widgets/section_box.h"

class QCheckBox;
class QPushButton;

namespace idap {

class ColorButton;
class LengthField;
class MaterialPicker;
class NumberField;
class SliderField;
class TextArea;
class TextField;
class ValueField;
struct FinishChoice;

// The texts of a row, all marked for translation.
struct RowText {
  const char* name = "";   // of the widget, for tests and pictures
  const char* label = "";  // before the field
  const char* edit = "";   // in the undo menu: "Change width"
  const char* tip = "";    // what it is, and what may be typed
  bool moves = false;      // dimensions and rooms follow
};

class Section : public SectionBox {
  Q_OBJECT
 public:
  // title marked for translation.
  Section(PanelLink& link, const char* name, const char* title, QWidget* parent);
  ~Section() override;

  void refresh(const Selected& selected);  // values only
  bool bare() const;                       // no row is there to show
  void retranslate();
  void commitTyping(bool keep);  // before another selection: applies what is half typed, or drops it
  QWidget* firstField() const;
  const std::vector<QWidget*>& fields() const { return fields_; }  // in the order of the keyboard

 protected:
  template <class V>
  using Read = std::function<Common<V>(const Selected&)>;
  template <class V>
  using Write = std::function<Home(const Home&, const Elements&, const V&)>;
  using Limits = std::function<std::pair<double, double>(const Selected&)>;
  // A row shows when there is something to show: Common::any.

  LengthField* addLength(const RowText& text, Read<double> read, Write<double> write, Limits limits = {});
  NumberField* addAngle(const RowText& text, Read<double> read, Write<double> write);  // degrees
  NumberField* addNumber(const RowText& text, const QString& unit, int decimals, Read<double> read,
                         Write<double> write, Limits limits = {});
  // A number that may be absent.
  NumberField* addOptionalNumber(const RowText& text, int decimals, Read<std::optional<double>> read,
                                 Write<std::optional<double>> write);
  SliderField* addSlider(const RowText& text, double min, double max, double step, const QString& unit,
                         Read<std::optional<double>> read, Write<double> write, const char* noneWords = "");
  QCheckBox* addCheck(const RowText& text, Read<bool> read, Write<bool> write);
  TextField* addText(const RowText& text, Read<std::string> read, Write<std::string> write);
  TextArea* addTextArea(const RowText& text, int lines, Read<std::string> read, Write<std::string> write);
  // options marked for translation; the value is the index.
  QComboBox* addChoice(const RowText& text, std::vector<const char*> options, Read<int> read,
                       Write<int> write);
  ColorButton* addColor(const RowText& text, const char* noneWords, Read<std::optional<Color>> read,
                        Write<std::optional<Color>> write);
  // plain: how a face without a finish looks.
  MaterialPicker* addFinish(const RowText& text, const char* plainWords, Read<Finish> read,
                            Write<Finish> write, std::optional<Color> plain = {});
  // Words that cannot be changed; the row hides when they are empty.
  QLabel* addInfo(const RowText& text, std::function<QString(const Selected&)> read);
  QPushButton* addButton(const RowText& text, std::function<bool(const Selected&)> shown,
                         std::function<void()> pressed);
  // A field of its own kind.
  void addRow(const RowText& text, QWidget* field);
  void setRowShown(QWidget* field, bool shown);
  // A row whose words are not known beforehand.
  QLabel* addLabelled(QWidget* field);
  void addField(QWidget* field);  // into the order of the keyboard
  void onRefresh(std::function<void(const Selected&)> update) { updates_.push_back(std::move(update)); }

  template <class V>
  void apply(const RowText& text, const Write<V>& write, const V& value) {
    link_.apply(
        text.edit, [&](const Home& home) { return write(home, elements_, value); }, text.moves);
  }
  template <class V>
  void preview(const RowText& text, const Write<V>& write, const V& value) {
    link_.preview(text.edit, [&](const Home& home) { return write(home, elements_, value); });
  }
  void choose(const RowText& text, const Write<Finish>& write, const FinishChoice& choice);

  bool eventFilter(QObject* watched, QEvent* event) override;

  PanelLink& link() const { return link_; }
  const Elements& elements() const { return elements_; }
  QFormLayout* form() const { return form_; }

 private:
  struct Row {
    RowText text;
    QWidget* field;
    QLabel* label;  // null: the field spans the row
  };
  void translate(const Row& row) const;
  void fit(const Row& row) const;  // words of a button to its width
  int labelWidth() const;
  void bind(ValueField* field, const RowText& text, const Read<double>& read, const Write<double>& write,
            const Limits& limits);

  PanelLink& link_;
  const char* title_;
  QFormLayout* form_;
  std::vector<Row> rows_;
  std::vector<QWidget*> fields_;
  std::vector<std::function<void(const Selected&)>> updates_;
  std::vector<std::function<void()>> translations_;
  Elements elements_;
};

}  // namespace idap
