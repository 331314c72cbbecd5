#include "studio/window/hint_line.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QTextDocument>
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
  hint = QStringLiteral("<b>") + translated(tool.info().name).toHtmlEscaped() +
         QStringLiteral("</b>&nbsp;&nbsp; ") + hint.toHtmlEscaped();
  QStringList keys;
  for (const ToolKey& key : tool.info().keys)
    keys << QStringLiteral(" &nbsp;&nbsp;·&nbsp; <b>") + translated(key.keys).toHtmlEscaped() +
                QStringLiteral("</b>&nbsp;") + translated(key.what).toHtmlEscaped();
  if (hint == hint_ && keys == keys_) return;
  hint_ = hint;
  keys_ = keys;
  const int side = fontMetrics().height();
  const QIcon picture = icon(tool.info().id);
  icon_->setPixmap(picture.isNull() ? QPixmap() : picture.pixmap(QSize(side, side), devicePixelRatioF()));
  fit();
}

void HintLine::fit() {
  QTextDocument document;
  document.setDefaultFont(font());
  document.setDocumentMargin(0);
  const auto width = [&document](const QString& html) {
    document.setHtml(html);
    return document.idealWidth();
  };
  const QString more = QStringLiteral(" &nbsp;…");
  QString shown = hint_;
  for (qsizetype i = 0; i < keys_.size(); ++i) {
    const QString next = shown + keys_[i];
    if (width(i + 1 < keys_.size() ? next + more : next) > words_->width()) {
      shown += more;
      break;
    }
    shown = next;
  }
  words_->setText(shown);
  words_->setToolTip(hint_ + keys_.join(QString()));
  document.setHtml(shown);
  // Letters of some scripts stand higher than those of the interface's font.
  words_->setMinimumHeight(int(document.size().height()) + 1);
}

void HintLine::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  layout()->activate();
  fit();
}

void HintLine::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
    hint_.clear();
    show();
  }
  QWidget::changeEvent(event);
}

}  // namespace idap
