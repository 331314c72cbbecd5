// The Print command: a plane to scale, on paper or into a PDF, with the page shown before it is printed.
#pragma once

#include <QDialog>
#include <memory>

#include "editor/editor.h"
#include "studio/plan/print_plan.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPrintPreviewWidget;
class QPrinter;
class QPushButton;

namespace idap {

class PrintDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PrintDialog(Editor& editor, QWidget* parent = nullptr);
  ~PrintDialog() override;

  void writePdf(const QString& file);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  PrintSettings settings() const;
  void setUpPage();
  void refresh();
  void retranslate();
  void print();
  void choosePdf();

  Editor& editor_;
  std::unique_ptr<QPrinter> printer_;
  QComboBox *plane_, *scale_, *paper_, *orientation_;
  QCheckBox* title_;
  QLabel *planeLabel_, *scaleLabel_, *paperLabel_, *orientationLabel_, *fits_;
  QPrintPreviewWidget* preview_;
  QPushButton *print_, *pdf_, *close_;
};

}  // namespace idap
