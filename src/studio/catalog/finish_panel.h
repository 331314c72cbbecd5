// Beside the furniture: the catalog's finishes, to be dragged onto walls, floors and pieces in the live view
// and the plan, or given to what is selected.
#pragma once

#include <QWidget>

#include "editor/editor.h"

class QLabel;
class QLineEdit;

namespace idap {

class MaterialList;

class FinishPanel : public QWidget {
  Q_OBJECT
 public:
  explicit FinishPanel(Editor& editor, QWidget* parent = nullptr);
  ~FinishPanel() override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void giveToSelection(const std::string& material);

  Editor& editor_;
  int subscription_ = 0;
  QLineEdit* search_;
  MaterialList* list_;
  QLabel* hint_;
};

}  // namespace idap
