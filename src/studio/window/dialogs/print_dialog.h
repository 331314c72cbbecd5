// The Print command: plans, elevations, lists and pictures to scale, on paper or into PDF and SVG files, with
// the pages shown before they are printed.
#pragma once

#include <QDialog>
#include <memory>

#include "editor/editor.h"
#include "studio/print/print_job.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QPrintPreviewWidget;
class QPrinter;
class QPushButton;

namespace idap {

class PrintDialog : public QDialog {
  Q_OBJECT
 public:
  explicit PrintDialog(Editor& editor, QWidget* parent = nullptr);
  ~PrintDialog() override;

  // Scale, paper, orientation and title block, to be taken up again the next time; unknown or damaged choices
  // leave what there is.
  QByteArray choices() const;
  void setChoices(const QByteArray& choices);

  PrintJob job() const;
  void writePdf(const QString& file);
  void writeSvg(const QString& file);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void setUpPage();
  void refresh();
  void retranslate();
  void print();
  void chooseFile(bool pdf);
  void write(const QString& file, bool pdf);

  Editor& editor_;
  std::unique_ptr<QPrinter> printer_;
  QListWidget* sheets_;
  QComboBox *scale_, *paper_, *orientation_;
  QCheckBox *title_, *allLevels_;
  QLabel *sheetsLabel_, *scaleLabel_, *paperLabel_, *orientationLabel_, *fits_;
  QPrintPreviewWidget* preview_;
  QPushButton *print_, *pdf_, *svg_, *close_;
  std::vector<PrintPage> pages_;
};

}  // namespace idap
