#include "studio/window/dialogs/print_dialog.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPageSize>
#include <QPrintDialog>
#include <QPrintPreviewWidget>
#include <QPrinter>
#include <QPushButton>

#include "base/error.h"
#include "base/file.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr int kScales[] = {0, 20, 25, 50, 75, 100, 150, 200};  // one to so many; 0: fits
constexpr QPageSize::PageSizeId kPapers[] = {QPageSize::A4,    QPageSize::A3,     QPageSize::A2,
                                             QPageSize::A1,    QPageSize::A0,     QPageSize::Letter,
                                             QPageSize::Legal, QPageSize::Tabloid};

}  // namespace

PrintDialog::PrintDialog(Editor& editor, QWidget* parent)
    : QDialog(parent),
      editor_(editor),
      printer_(std::make_unique<QPrinter>(QPrinter::HighResolution)),
      plane_(new QComboBox(this)),
      scale_(new QComboBox(this)),
      paper_(new QComboBox(this)),
      orientation_(new QComboBox(this)),
      title_(new QCheckBox(this)),
      planeLabel_(new QLabel(this)),
      scaleLabel_(new QLabel(this)),
      paperLabel_(new QLabel(this)),
      orientationLabel_(new QLabel(this)),
      fits_(new QLabel(this)),
      preview_(new QPrintPreviewWidget(printer_.get(), this)),
      print_(new QPushButton(this)),
      pdf_(new QPushButton(this)),
      close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("printDialog"));
  plane_->setObjectName(QStringLiteral("plane"));
  scale_->setObjectName(QStringLiteral("scale"));
  paper_->setObjectName(QStringLiteral("paper"));
  orientation_->setObjectName(QStringLiteral("orientation"));
  title_->setObjectName(QStringLiteral("titleBlock"));
  print_->setObjectName(QStringLiteral("toPrinter"));
  pdf_->setObjectName(QStringLiteral("toPdf"));
  plane_->addItems({QStringLiteral("X-Y"), QStringLiteral("X-Z"), QStringLiteral("Y-Z")});
  for (const int scale : kScales) scale_->addItem(QStringLiteral("1:%1").arg(scale), scale);
  for (const auto id : kPapers) paper_->addItem(QPageSize::name(id), int(id));
  orientation_->addItems({QString(), QString()});
  orientation_->setCurrentIndex(1);
  title_->setChecked(true);
  fits_->setWordWrap(true);

  auto* form = new QFormLayout;
  const std::pair<QLabel*, QWidget*> rows[] = {
      {planeLabel_, plane_}, {scaleLabel_, scale_}, {paperLabel_, paper_}, {orientationLabel_, orientation_}};
  for (const auto& [label, field] : rows) {
    label->setBuddy(field);
    form->addRow(label, field);
  }
  form->addRow(title_);
  form->addRow(fits_);
  auto* left = new QVBoxLayout;
  left->addLayout(form);
  left->addStretch();
  for (QPushButton* button : {print_, pdf_, close_}) left->addWidget(button);
  auto* all = new QHBoxLayout(this);
  all->addLayout(left);
  all->addWidget(preview_, 1);
  const int em = fontMetrics().height();
  resize(52 * em, 34 * em);
  preview_->setZoomMode(QPrintPreviewWidget::FitInView);
  print_->setDefault(true);

  connect(preview_, &QPrintPreviewWidget::paintRequested, this,
          [this](QPrinter* printer) { printPlan(*printer, editor_, settings()); });
  for (QComboBox* box : {plane_, scale_, paper_, orientation_})
    connect(box, &QComboBox::currentIndexChanged, this, &PrintDialog::refresh);
  connect(title_, &QCheckBox::toggled, this, &PrintDialog::refresh);
  connect(print_, &QPushButton::clicked, this, &PrintDialog::print);
  connect(pdf_, &QPushButton::clicked, this, &PrintDialog::choosePdf);
  connect(close_, &QPushButton::clicked, this, &QDialog::reject);
  retranslate();
  refresh();
}

PrintDialog::~PrintDialog() { delete preview_; }  // before the printer that it shows

PrintSettings PrintDialog::settings() const {
  PrintSettings settings;
  settings.plane = kPlanes[std::size_t(std::max(0, plane_->currentIndex()))];
  const int scale = scale_->currentData().toInt();
  settings.scale = scale > 0 ? 1.0 / scale : 0;
  settings.titleBlock = title_->isChecked();
  return settings;
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
  const PrintSettings chosen = settings();
  const QSizeF page = printer_->pageLayout().paintRect(QPageLayout::Millimeter).size();
  const double fitting = fittingScale(editor_, chosen.plane, page, chosen.titleBlock);
  if (chosen.scale == 0)
    fits_->setText(tr("It is printed at 1:%1.").arg(qRound(1 / fitting)));
  else if (chosen.scale > fitting * 1.0001)
    fits_->setText(tr("It does not fit on this page at that scale; 1:%1 does.").arg(qRound(1 / fitting)));
  else
    fits_->clear();
  preview_->updatePreview();
}

void PrintDialog::retranslate() {
  setWindowTitle(tr("Print"));
  planeLabel_->setText(tr("P&lane"));
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
  close_->setText(tr("Close"));
  refresh();
}

void PrintDialog::print() {
  setUpPage();
  auto* dialog = new QPrintDialog(printer_.get(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this] {
    printPlan(*printer_, editor_, settings());
    accept();
  });
  dialog->open();
}

void PrintDialog::choosePdf() {
  auto* dialog = new QFileDialog(this, tr("Save as PDF"), QString(), QStringLiteral("PDF (*.pdf)"));
  dialog->setObjectName(QStringLiteral("pdfDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  const auto& file = editor_.document().file();
  dialog->selectFile((file.empty() ? tr("plan") : toQt(file.stem().string())) + QStringLiteral(".pdf"));
  connect(dialog, &QFileDialog::fileSelected, this, &PrintDialog::writePdf);
  dialog->open();
}

void PrintDialog::writePdf(const QString& file) {
  try {
    requireWritable(fromQt(file));
  } catch (const Error& error) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("Print"), tr("The PDF cannot be written."),
                                QMessageBox::Ok, this);
    box->setInformativeText(toQt(error.what()));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
    return;
  }
  setUpPage();
  QPrinter paper(QPrinter::HighResolution);
  paper.setOutputFormat(QPrinter::PdfFormat);
  paper.setOutputFileName(file);
  paper.setPageLayout(printer_->pageLayout());
  paper.setDocName(printer_->docName());
  paper.setCreator(printer_->creator());
  printPlan(paper, editor_, settings());
  editor_.say({QT_TRANSLATE_NOOP("idap", "Printed the plan into %1"), {fromQt(file)}});
  accept();
}

void PrintDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace idap
