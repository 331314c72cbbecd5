#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMimeData>
#include <QProgressBar>

#include "studio/catalog/import_pages.h"

namespace idap {

ImportStart::ImportStart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("importStart"));
  setAcceptDrops(true);
  words_ = new QLabel;
  words_->setWordWrap(true);
  words_->setAlignment(Qt::AlignCenter);
  problem_ = new QLabel;
  problem_->setObjectName(QStringLiteral("importProblem"));
  problem_->setWordWrap(true);
  problem_->setAlignment(Qt::AlignCenter);
  problem_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  problem_->setFrameShape(QFrame::StyledPanel);
  problem_->setMargin(8);
  problem_->hide();
  choose_ = new QPushButton;
  choose_->setObjectName(QStringLiteral("importChoose"));
  busy_ = new QProgressBar;
  busy_->setRange(0, 0);
  cancel_ = new QPushButton;
  cancel_->setObjectName(QStringLiteral("importStop"));
  auto* layout = new QVBoxLayout(this);
  layout->addStretch(1);
  layout->addWidget(words_);
  layout->addSpacing(12);
  layout->addWidget(choose_, 0, Qt::AlignHCenter);
  layout->addWidget(busy_);
  layout->addWidget(cancel_, 0, Qt::AlignHCenter);
  layout->addSpacing(12);
  layout->addWidget(problem_);
  layout->addStretch(2);
  connect(choose_, &QPushButton::clicked, this, [this] { ask(); });
  connect(cancel_, &QPushButton::clicked, this, &ImportStart::cancelled);
  setBusy({});
  retranslate();
}

void ImportStart::retranslate() {
  words_->setText(tr(
      "Drop a file here, or choose one.\n\nA furniture library (SH3F) becomes part of the catalog. A model "
      "(OBJ, 3DS, DAE, glTF, STL, or a ZIP with one of these) becomes a piece of this home."));
  choose_->setText(tr("Choose a file…"));
  choose_->setToolTip(tr("Look for a furniture library or a model on this computer"));
  cancel_->setText(tr("Stop"));
}

void ImportStart::setBusy(const QString& what) {
  const bool busy = !what.isEmpty();
  busy_->setFormat(what);
  busy_->setRange(0, 0);  // how long it takes is not known at first
  busy_->setVisible(busy);
  cancel_->setVisible(busy);
  choose_->setVisible(!busy);
  if (busy) problem_->hide();
}

void ImportStart::setProgress(double fraction) {
  if (fraction <= 0) return;
  busy_->setRange(0, 100);
  busy_->setValue(static_cast<int>(100 * fraction));
}

void ImportStart::setProblem(const QString& words) {
  problem_->setText(words);
  problem_->setVisible(!words.isEmpty());
}

void ImportStart::ask() {
  auto* dialog = new QFileDialog(this, tr("Import furniture"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters(
      {tr("Furniture") + QStringLiteral(" (*.sh3f *.obj *.3ds *.dae *.gltf *.glb *.stl *.zip)"),
       tr("All files") + QStringLiteral(" (*)")});
  connect(dialog, &QFileDialog::fileSelected, this, &ImportStart::fileChosen);
  dialog->open();
}

void ImportStart::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile() && choose_->isVisibleTo(this))
    event->acceptProposedAction();
}

void ImportStart::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.size() == 1 && urls.front().isLocalFile()) emit fileChosen(urls.front().toLocalFile());
}

}  // namespace idap
