// How the user likes to work: units, language, theme, drawing.
#pragma once

#include "studio/window/dialogs/form_dialog.h"
#include "studio/window/preferences.h"

class QCheckBox;
class QComboBox;
class QGroupBox;

namespace idap {

class LengthField;

class PreferencesDialog : public FormDialog {
  Q_OBJECT
 public:
  explicit PreferencesDialog(Preferences& preferences, QWidget* parent = nullptr);

 protected:
  void retranslate() override;
  bool apply() override;

 private:
  Preferences& preferences_;
  QComboBox *language_, *unit_, *theme_, *pattern_;
  QGroupBox *drawing_, *walls_;
  QCheckBox *snapping_, *gridSnapping_, *grid_, *rulers_, *below_, *areas_;
  LengthField *thickness_, *height_;
  QLabel *languageLabel_, *unitLabel_, *themeLabel_, *thicknessLabel_, *heightLabel_, *patternLabel_;
};

}  // namespace idap
