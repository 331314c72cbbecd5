#include "studio/window/hint_line.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QTextDocumentFragment>
#include <QTimer>

#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

HintLine::HintLine(Editor& editor, QWidget* parent)
    : QWidget(parent),
      editor_(editor),
      icon_(new QLabel(this)),
      words_(new QLabel(this)),
      soon_(new QTimer(this)) {
  setObjectName(QStringLiteral("hintLine"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(icon_);
  layout->addWidget(words_, 1);
  words_->setObjectName(QStringLiteral("hint"));
  words_->setTextFormat(Qt::RichText);
  words_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  soon_->setSingleShot(true);
  soon_->setInterval(40);
  connect(soon_, &QTimer::timeout, this, &HintLine::show);
  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Tool || change == Editor::Change::Document) return show();
    if (!soon_->isActive()) soon_->start();
  };
  subscription_ = editor_.subscribe(std::move(listener));
  show();
}

HintLine::~HintLine() { editor_.unsubscribe(subscription_); }

QString HintLine::text() const { return QTextDocumentFragment::fromHtml(words_->text()).toPlainText(); }

void HintLine::show() {
  const Tool& tool = editor_.tool();
  const Home& home = editor_.home();
  QString hint = translated(tool.hint());
  // Who has never furnished a room is told where to begin.
  const bool bare = home.furniture.empty() && home.openings.empty();
  if (bare && editor_.selecting() && empty(editor_.selection()))
    hint = tr(
        "Furnish the room: drag furniture from the catalog on the left into a plane, or choose it there and "
        "press Enter.");
  QString html = QStringLiteral("<b>") + translated(tool.info().name).toHtmlEscaped() +
                 QStringLiteral("</b>&nbsp;&nbsp; ") + hint.toHtmlEscaped();
  for (const ToolKey& key : tool.info().keys)
    html += QStringLiteral(" &nbsp;&nbsp;·&nbsp; <b>") + translated(key.keys).toHtmlEscaped() +
            QStringLiteral("</b>&nbsp;") + translated(key.what).toHtmlEscaped();
  if (html == words_->text()) return;
  words_->setText(html);
  words_->setToolTip(html);
  const int side = fontMetrics().height();
  const QIcon picture = icon(tool.info().id);
  icon_->setPixmap(picture.isNull() ? QPixmap() : picture.pixmap(QSize(side, side), devicePixelRatioF()));
}

void HintLine::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
    words_->clear();
    show();
  }
  QWidget::changeEvent(event);
}

}  // namespace idap
