// Where the home stands, which way it faces, and when it is seen: what the sun goes by.
#pragma once

#include "editor/editor.h"
#include "studio/window/dialogs/form_dialog.h"

class QCheckBox;
class QComboBox;
class QDateTimeEdit;

namespace idap {

class NumberField;
class CompassFace;

class SiteDialog : public FormDialog {
  Q_OBJECT
 public:
  explicit SiteDialog(Editor& editor, QWidget* parent = nullptr);

 protected:
  void retranslate() override;
  bool apply() override;

 private:
  void chooseCity(int index);
  void findCity();  // the one whose place the numbers name
  void showTime(std::int64_t time);
  std::int64_t time() const;  // ms since 1970

  Editor& editor_;
  QComboBox *city_, *zone_;
  NumberField *latitude_, *longitude_, *north_;
  QDateTimeEdit* time_;
  QCheckBox* shown_;
  CompassFace* face_;
  QLabel *cityLabel_, *latitudeLabel_, *longitudeLabel_, *zoneLabel_, *northLabel_, *timeLabel_;
  bool filling_ = false;
};

}  // namespace idap
