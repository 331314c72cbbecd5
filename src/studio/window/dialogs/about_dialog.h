// What the program is, its licence, and whose work is in it.
#pragma once

#include <QDialog>

class QTextBrowser;

namespace idap {

class AboutDialog : public QDialog {
  Q_OBJECT
 public:
  explicit AboutDialog(QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  QTextBrowser* text_;
};

}  // namespace idap
