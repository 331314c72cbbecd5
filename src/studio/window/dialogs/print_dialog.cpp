#include "studio/window/dialogs/print_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QPageSize>
#include <QPrintDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QPushButton>
#include <QToolButton>

#include "base/error.h"
#include "studio/print/print_output.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr SheetKind kSheets[] = {SheetKind::Plan,           SheetKind::Front,         SheetKind::Side,
                                 SheetKind::WallElevations, SheetKind::FurnitureList, SheetKind::Pictures};
constexpr int kScales[] = {0, 20, 25, 50, 75, 100, 150, 200};  // one to so many; 0: fits
constexpr QPageSize::PageSizeId kPapers[] = {QPageSize::A4,    QPageSize::A3,     QPageSize::A2,
                                             QPageSize::A1,    QPageSize::A0,     QPageSize::Letter,
                                             QPageSize::Legal, QPageSize::Tabloid};

}  // namespace

PrintDialog::PrintDialog(Editor& editor, QWidget* parent)
    : QDialog(parent),
      editor_(editor),
      printer_(std::make_unique<QPrinter>(QPrinter::HighResolution)),
      sheets_(new QListWidget(this)),
      scale_(new QComboBox(this)),
      paper_(new QComboBox(this)),
      orientation_(new QComboBox(this)),
      title_(new QCheckBox(this)),
      allLevels_(new QCheckBox(this)),
      sheetsLabel_(new QLabel(this)),
      scaleLabel_(new QLabel(this)),
      paperLabel_(new QLabel(this)),
      orientationLabel_(new QLabel(this)),
      fits_(new QLabel(this)),
      preview_(new QPrintPreviewWidget(printer_.get(), this)),
      print_(new QPushButton(this)),
      pdf_(new QPushButton(this)),
      svg_(new QPushButton(this)),
      close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("printDialog"));
  sheets_->setObjectName(QStringLiteral("sheets"));
  scale_->setObjectName(QStringLiteral("scale"));
  paper_->setObjectName(QStringLiteral("paper"));
  orientation_->setObjectName(QStringLiteral("orientation"));
  title_->setObjectName(QStringLiteral("titleBlock"));
  allLevels_->setObjectName(QStringLiteral("allLevels"));
  fits_->setObjectName(QStringLiteral("fits"));
  print_->setObjectName(QStringLiteral("toPrinter"));
  pdf_->setObjectName(QStringLiteral("toPdf"));
  svg_->setObjectName(QStringLiteral("toSvg"));
  for (const SheetKind kind : kSheets) {
    auto* item = new QListWidgetItem(sheets_);
    item->setData(Qt::UserRole, int(kind));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(kind == SheetKind::Plan ? Qt::Checked : Qt::Unchecked);
  }
  sheets_->setFixedHeight(int(std::size(kSheets)) * (fontMetrics().height() + 7) + 8);
  for (const int scale : kScales) scale_->addItem(QStringLiteral("1:%1").arg(scale), scale);
  for (const auto id : kPapers) paper_->addItem(QPageSize::name(id), int(id));
  orientation_->addItems({QString(), QString()});
  orientation_->setCurrentIndex(1);
  title_->setChecked(true);
  allLevels_->setVisible(editor.home().levels.size() > 1);
  fits_->setWordWrap(true);

  auto* form = new QFormLayout;
  const std::pair<QLabel*, QWidget*> rows[] = {
      {scaleLabel_, scale_}, {paperLabel_, paper_}, {orientationLabel_, orientation_}};
  sheetsLabel_->setBuddy(sheets_);
  form->addRow(sheetsLabel_);
  form->addRow(sheets_);
  form->addRow(allLevels_);
  for (const auto& [label, field] : rows) {
    label->setBuddy(field);
    form->addRow(label, field);
  }
  form->addRow(title_);
  form->addRow(fits_);
  auto* turning = new QHBoxLayout;
  const auto turner = [&](const char* drawing, const char* name, int by) {
    auto* button = toolButton(drawing, name, this);
    turning->addWidget(button);
    connect(button, &QToolButton::clicked, this,
            [this, by] { preview_->setCurrentPage(preview_->currentPage() + by); });
    return button;
  };
  turning->addStretch();
  turner("up", "previousPage", -1)->setToolTip(tr("The page before"));
  turner("down", "nextPage", 1)->setToolTip(tr("The next page"));
  turning->addStretch();
  auto* right = new QVBoxLayout;
  right->addWidget(preview_, 1);
  right->addLayout(turning);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addStretch();
  for (QPushButton* button : {print_, pdf_, svg_, close_}) left->addWidget(button);
  auto* all = new QHBoxLayout(this);
  all->addLayout(left);
  all->addLayout(right, 1);
  const int em = fontMetrics().height();
  resize(58 * em, 38 * em);
  preview_->setZoomMode(QPrintPreviewWidget::FitInView);
  print_->setDefault(true);

  connect(preview_, &QPrintPreviewWidget::paintRequested, this,
          [this](QPrinter* printer) { printTo(*printer, pages_); });
  for (QComboBox* box : {scale_, paper_, orientation_})
    connect(box, &QComboBox::currentIndexChanged, this, &PrintDialog::refresh);
  for (QCheckBox* box : {title_, allLevels_}) connect(box, &QCheckBox::toggled, this, &PrintDialog::refresh);
  connect(sheets_, &QListWidget::itemChanged, this, &PrintDialog::refresh);
  connect(print_, &QPushButton::clicked, this, &PrintDialog::print);
  connect(pdf_, &QPushButton::clicked, this, [this] { chooseFile(true); });
  connect(svg_, &QPushButton::clicked, this, [this] { chooseFile(false); });
  connect(close_, &QPushButton::clicked, this, &QDialog::reject);
  retranslate();
  refresh();
}

PrintDialog::~PrintDialog() { delete preview_; }  // before the printer that it shows

PrintJob PrintDialog::job() const {
  PrintJob job;
  job.page = printer_->pageLayout();
  job.page.setUnits(QPageLayout::Millimeter);
  job.sheets.clear();
  for (int i = 0; i < sheets_->count(); ++i)
    if (sheets_->item(i)->checkState() == Qt::Checked)
      job.sheets.push_back(SheetKind(sheets_->item(i)->data(Qt::UserRole).toInt()));
  const int scale = scale_->currentData().toInt();
  job.scale = scale > 0 ? 1.0 / scale : 0;
  job.titleBlock = title_->isChecked();
  job.allLevels = allLevels_->isChecked();
  return job;
}

QByteArray PrintDialog::choices() const {
  return QJsonDocument(QJsonObject{{"scale", scale_->currentData().toInt()},
                                   {"paper", paper_->currentData().toInt()},
                                   {"landscape", orientation_->currentIndex() == 1},
                                   {"titleBlock", title_->isChecked()}})
      .toJson(QJsonDocument::Compact);
}

void PrintDialog::setChoices(const QByteArray& choices) {
  const QJsonObject kept = QJsonDocument::fromJson(choices).object();
  {
    const QSignalBlocker quiet[] = {QSignalBlocker(scale_), QSignalBlocker(paper_),
                                    QSignalBlocker(orientation_), QSignalBlocker(title_)};
    for (const auto& [box, key] : {std::pair(scale_, "scale"), std::pair(paper_, "paper")})
      if (const int at = box->findData(kept.value(QLatin1String(key)).toInt(-1)); at >= 0)
        box->setCurrentIndex(at);
    orientation_->setCurrentIndex(kept.value(QLatin1String("landscape")).toBool(true) ? 1 : 0);
    title_->setChecked(kept.value(QLatin1String("titleBlock")).toBool(true));
  }
  refresh();
}

void PrintDialog::setUpPage() {
  printer_->setPageSize(QPageSize(QPageSize::PageSizeId(paper_->currentData().toInt())));
  printer_->setPageOrientation(orientation_->currentIndex() == 1 ? QPageLayout::Landscape
                                                                 : QPageLayout::Portrait);
  printer_->setPageMargins(QMarginsF(10, 10, 10, 10), QPageLayout::Millimeter);
  printer_->setDocName(toQt(editor_.home().title.empty() ? editor_.home().name : editor_.home().title));
  printer_->setCreator(QStringLiteral("IDAP"));
}

void PrintDialog::refresh() {
  setUpPage();
  QApplication::setOverrideCursor(Qt::WaitCursor);
  pages_ = layOut(printSource(editor_), job());
  QApplication::restoreOverrideCursor();
  const int count = int(pages_.size());
  const bool anyTicked = !job().sheets.empty();
  QString words = count == 0
                      ? anyTicked ? tr("There is nothing of that to print yet.") : tr("Tick what to print.")
                  : count == 1 ? tr("One page.")
                               : tr("%1 pages.").arg(count);
  if (count > 0 && scale_->currentData().toInt() == 0 && pages_.front().scale > 0)
    words += QLatin1Char(' ') + tr("It is printed at %1.").arg(scaleText(pages_.front().scale));
  fits_->setText(words);
  for (QPushButton* button : {print_, pdf_, svg_}) button->setEnabled(count > 0);
  preview_->updatePreview();
}

void PrintDialog::retranslate() {
  setWindowTitle(tr("Print"));
  sheetsLabel_->setText(tr("S&heets"));
  {
    const QSignalBlocker quiet(sheets_);
    for (int i = 0; i < sheets_->count(); ++i) sheets_->item(i)->setText(translated(sheetName(kSheets[i])));
  }
  allLevels_->setText(tr("Plans of all &levels"));
  scaleLabel_->setText(tr("&Scale"));
  paperLabel_->setText(tr("P&aper"));
  orientationLabel_->setText(tr("&Orientation"));
  scale_->setItemText(0, tr("As large as fits"));
  orientation_->setItemText(0, tr("Portrait"));
  orientation_->setItemText(1, tr("Landscape"));
  title_->setText(tr("&Title, notes, scale and date"));
  title_->setToolTip(tr("Along the lower edge; title and notes are those of the Text command"));
  print_->setText(tr("&Print…"));
  pdf_->setText(tr("Save as P&DF…"));
  svg_->setText(tr("Save as S&VG…"));
  close_->setText(tr("Close"));
  refresh();
}

void PrintDialog::print() {
  setUpPage();
  auto* dialog = new QPrintDialog(printer_.get(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this] {
    printTo(*printer_, pages_);
    accept();
  });
  dialog->open();
}

void PrintDialog::chooseFile(bool pdf) {
  auto* dialog = new QFileDialog(this, pdf ? tr("Save as PDF") : tr("Save as SVG"), QString(),
                                 pdf ? QStringLiteral("PDF (*.pdf)") : QStringLiteral("SVG (*.svg)"));
  dialog->setObjectName(pdf ? QStringLiteral("pdfDialog") : QStringLiteral("svgDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString suffix = pdf ? QStringLiteral("pdf") : QStringLiteral("svg");
  dialog->setDefaultSuffix(suffix);
  const auto& file = editor_.document().file();
  dialog->selectFile((file.empty() ? tr("plan") : toQt(file.stem().string())) + QLatin1Char('.') + suffix);
  connect(dialog, &QFileDialog::fileSelected, this, [this, pdf](const QString& name) { write(name, pdf); });
  dialog->open();
}

void PrintDialog::writePdf(const QString& file) { write(file, true); }
void PrintDialog::writeSvg(const QString& file) { write(file, false); }

void PrintDialog::write(const QString& file, bool pdf) {
  try {
    if (pdf)
      idap::writePdf(fromQt(file), pages_, job().page, printer_->docName());
    else
      idap::writeSvg(fromQt(file), pages_, job().page, printer_->docName());
  } catch (const Error& error) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Print"),
                                pdf ? tr("The PDF cannot be written.") : tr("The SVG cannot be written."),
                                QMessageBox::Ok, this);
    box->setInformativeText(toQt(error.what()));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
    return;
  }
  editor_.say({QT_TRANSLATE_NOOP("idap", "Printed the plan into %1"), {fromQt(file)}});
  accept();
}

void PrintDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace idap
