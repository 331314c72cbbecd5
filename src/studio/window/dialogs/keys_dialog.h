// Every key of the program and what it does: made from the actions and the tools, so that it is always true.
#pragma once

#include <QDialog>

class QTreeWidget;
class QLineEdit;

namespace idap {

class WindowActions;

class KeysDialog : public QDialog {
  Q_OBJECT
 public:
  explicit KeysDialog(const WindowActions& actions, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void filter();

  const WindowActions& actions_;
  QLineEdit* search_;
  QTreeWidget* list_;
};

}  // namespace idap
