// A level's name, elevation, height and floor. A home without levels has its height of walls here.
#pragma once

#include "editor/editor.h"
#include "studio/window/dialogs/form_dialog.h"

class QCheckBox;
class QLineEdit;

namespace idap {

class LengthField;

class LevelDialog : public FormDialog {
  Q_OBJECT
 public:
  explicit LevelDialog(Editor& editor, QWidget* parent = nullptr);

 protected:
  void retranslate() override;
  bool apply() override;

 private:
  Editor& editor_;
  LevelId id_;
  QLineEdit* name_ = nullptr;
  LengthField *elevation_ = nullptr, *height_ = nullptr, *floor_ = nullptr;
  QCheckBox *visible_ = nullptr, *viewable_ = nullptr;
  QLabel *nameLabel_ = nullptr, *elevationLabel_ = nullptr, *heightLabel_ = nullptr, *floorLabel_ = nullptr;
};

}  // namespace idap
