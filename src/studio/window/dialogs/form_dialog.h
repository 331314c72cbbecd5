// What the small dialogs share: rows of labelled fields over OK and Cancel, nothing done before OK.
#pragma once

#include <QDialog>

class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace idap {

class FormDialog : public QDialog {
  Q_OBJECT
 public:
  void accept() override;

 protected:
  FormDialog(const char* name, QWidget* parent);

  QLabel* addRow(QWidget* field);  // its label, which retranslate() words
  void addWide(QWidget* field, int stretch = 0);
  QFormLayout* form() const { return form_; }
  QDialogButtonBox* buttons() const { return buttons_; }

  virtual void retranslate() = 0;  // called by the subclass's constructor and at every change of language
  virtual bool apply() = 0;        // false: something cannot be, and the dialog stays

  void changeEvent(QEvent* event) override;

 private:
  QVBoxLayout* all_;
  QFormLayout* form_;
  QDialogButtonBox* buttons_;
  int wide_ = 0;
};

}  // namespace idap
