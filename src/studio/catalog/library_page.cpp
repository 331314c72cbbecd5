#include "studio/catalog/import_pages.h"
#include "studio/widgets/texts.h"

namespace idap {

LibraryPage::LibraryPage(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("importLibrary"));
  title_ = new QLabel;
  QFont large = title_->font();
  large.setPointSizeF(large.pointSizeF() * 1.3);
  large.setBold(true);
  title_->setFont(large);
  title_->setWordWrap(true);
  title_->setTextFormat(Qt::PlainText);
  about_ = new QLabel;
  about_->setObjectName(QStringLiteral("importLibraryAbout"));
  about_->setWordWrap(true);
  about_->setTextFormat(Qt::RichText);
  about_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  replaces_ = new QLabel;
  replaces_->setObjectName(QStringLiteral("importLibraryReplaces"));
  replaces_->setWordWrap(true);
  replaces_->setFrameShape(QFrame::StyledPanel);
  replaces_->setMargin(8);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(title_);
  layout->addWidget(about_, 1);
  layout->addWidget(replaces_);
}

void LibraryPage::show(const LibraryPreview& preview, const QString& fileName, bool replaces) {
  preview_ = preview;
  fileName_ = fileName;
  replacing_ = replaces;
  retranslate();
}

void LibraryPage::retranslate() {
  title_->setText(toQt(preview_.name));
  QStringList lines;
  if (!preview_.description.empty()) lines << toQt(preview_.description).left(600).toHtmlEscaped();
  lines << tr("Pieces: %1").arg(preview_.pieces);
  if (!preview_.names.empty()) {
    QStringList names;
    for (const std::string& name : preview_.names) names << toQt(name).toHtmlEscaped();
    if (preview_.pieces > preview_.names.size()) names << QStringLiteral("…");
    lines << names.join(QStringLiteral(", "));
  }
  if (!preview_.license.empty())
    lines << tr("Licence: %1").arg(toQt(preview_.license).left(400).toHtmlEscaped());
  if (!preview_.faults.empty())
    lines << tr("%1 more cannot be used: %2")
                 .arg(preview_.faults.size())
                 .arg(toQt(preview_.faults.front()).toHtmlEscaped());
  about_->setText(lines.join(QStringLiteral("<br><br>")));
  replaces_->setText(tr("You have a library %1 already. It will be replaced by this one.").arg(fileName_));
  replaces_->setVisible(replacing_);
}

}  // namespace idap
