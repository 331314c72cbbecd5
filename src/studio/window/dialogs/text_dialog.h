// The Text command: the home's name, its title on prints, and notes.
#pragma once

#include "editor/editor.h"
#include "studio/window/dialogs/form_dialog.h"

class QLineEdit;
class QPlainTextEdit;

namespace idap {

class TextDialog : public FormDialog {
  Q_OBJECT
 public:
  explicit TextDialog(Editor& editor, QWidget* parent = nullptr);

 protected:
  void retranslate() override;
  bool apply() override;

 private:
  Editor& editor_;
  QLineEdit *name_, *title_;
  QPlainTextEdit* notes_;
  QLabel *nameLabel_, *titleLabel_, *notesLabel_;
};

}  // namespace idap
