#include "studio/window/dialogs/about_dialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QTextBrowser>

namespace idap {

namespace {

struct Library {
  const char *name, *licence;
};
constexpr Library kLibraries[] = {
    {"Qt", "LGPL-3.0"},       {"Embree", "Apache-2.0"},        {"oneTBB", "Apache-2.0"},
    {"oneDNN", "Apache-2.0"}, {"OpenImageIO", "BSD-3-Clause"}, {"assimp", "BSD-3-Clause"},
    {"GEOS", "LGPL-2.1"},     {"libzip", "BSD-3-Clause"},      {"pugixml", "MIT"},
    {"nlohmann/json", "MIT"}, {"libnova", "LGPL-2.0"},         {"CCTZ", "Apache-2.0"},
    {"fmt, spdlog", "MIT"}};

}  // namespace

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent), text_(new QTextBrowser(this)) {
  setObjectName(QStringLiteral("aboutDialog"));
  text_->setOpenExternalLinks(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(text_, 1);
  layout->addWidget(buttons);
  const int em = fontMetrics().height();
  resize(34 * em, 30 * em);
  fill();
}

void AboutDialog::fill() {
  setWindowTitle(tr("About IDAP"));
  const auto paragraph = [](const QString& text) {
    return QStringLiteral("<p>") + text + QStringLiteral("</p>");
  };
  QString html = QStringLiteral("<h2>IDAP " IDAP_VERSION "</h2>");
  html +=
      paragraph(tr("Draw or open a home, furnish it, and see it as it would really look. It carries on a DOS "
                   "program of 1993, the Interior Design Assisting Program.")
                    .toHtmlEscaped());
  html += paragraph(
      tr("Free software under the GNU General Public License, version 3 or later: you may use, study, "
         "share and change it. It comes without any warranty.")
          .toHtmlEscaped());
  html += QStringLiteral("<h3>") + tr("Libraries").toHtmlEscaped() +
          QStringLiteral("</h3><table cellspacing='2'>");
  for (const Library& library : kLibraries)
    html += QStringLiteral("<tr><td>%1&nbsp;&nbsp;&nbsp;</td><td>%2</td></tr>")
                .arg(QLatin1String(library.name), QLatin1String(library.licence));
  html +=
      QStringLiteral("</table><h3>") + tr("Furniture and weights").toHtmlEscaped() + QStringLiteral("</h3>");
  html += paragraph(
      tr("Furniture libraries name the creator and the licence of each piece in the catalog's tooltips. "
         "Denoising uses the weights of Intel Open Image Denoise (Apache-2.0), where they are installed.")
          .toHtmlEscaped());
  text_->setHtml(html);
}

void AboutDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) fill();
  QDialog::changeEvent(event);
}

}  // namespace idap
