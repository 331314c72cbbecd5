#include "studio/lists/message_list.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QScrollBar>
#include <QTime>
#include <QToolButton>
#include <deque>

#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

namespace {

constexpr std::size_t kKept = 500;

struct Message {
  Text text;
  Editor::Severity severity;
  QTime time;
  int times = 1;
};

QIcon iconOf(Editor::Severity severity, const QWidget& widget) {
  const char* name = severity == Editor::Severity::Note      ? "note"
                     : severity == Editor::Severity::Warning ? "warning"
                                                             : "error";
  const QIcon own = icon(name);
  if (!own.isNull()) return own;
  return widget.style()->standardIcon(severity == Editor::Severity::Note ? QStyle::SP_MessageBoxInformation
                                      : severity == Editor::Severity::Warning
                                          ? QStyle::SP_MessageBoxWarning
                                          : QStyle::SP_MessageBoxCritical);
}

}  // namespace

struct MessageList::Impl : public QObject {
  MessageList* self;
  Editor& editor;
  std::deque<Message> messages;
  QListWidget* list = nullptr;
  QToolButton* copy = nullptr;
  QToolButton* clear = nullptr;
  int subscription = 0;
  int unseen = 0;

  Impl(MessageList* owner, Editor& e) : self(owner), editor(e) {}

  QString line(const Message& message) const {
    QString text = translated(message.text);
    if (message.times > 1) text += QStringLiteral(" (×%1)").arg(message.times);
    return text;
  }
  QString withTime(const Message& message) const {
    return QLocale().toString(message.time, QStringLiteral("HH:mm:ss")) + QStringLiteral("   ") +
           line(message);
  }

  void show(QListWidgetItem& item, const Message& message) const {
    item.setText(withTime(message));
    item.setIcon(iconOf(message.severity, *self));
    const QString kind = message.severity == Editor::Severity::Note      ? MessageList::tr("Note")
                         : message.severity == Editor::Severity::Warning ? MessageList::tr("Warning")
                                                                         : MessageList::tr("Error");
    item.setData(Qt::AccessibleTextRole, kind + QStringLiteral(": ") + line(message));
    item.setToolTip(line(message));
  }

  void take(const Text& text, Editor::Severity severity) {
    const bool atEnd = list->verticalScrollBar()->value() == list->verticalScrollBar()->maximum();
    if (!messages.empty() && messages.back().text == text && messages.back().severity == severity) {
      ++messages.back().times;
      messages.back().time = QTime::currentTime();
      show(*list->item(list->count() - 1), messages.back());
    } else {
      messages.push_back({text, severity, QTime::currentTime()});
      auto* item = new QListWidgetItem(list);
      show(*item, messages.back());
      if (messages.size() > kKept) {
        messages.pop_front();
        delete list->takeItem(0);
      }
    }
    if (atEnd) list->scrollToBottom();
    copy->setEnabled(true);
    clear->setEnabled(true);
    if (severity != Editor::Severity::Note && !self->isVisible()) emit self->unseen(++unseen);
  }

  // What is selected, or all.
  void copyToClipboard() {
    QStringList lines;
    const bool all = list->selectedItems().isEmpty();
    for (int i = 0; i < list->count(); ++i)
      if (all || list->item(i)->isSelected()) lines << withTime(messages[static_cast<std::size_t>(i)]);
    QGuiApplication::clipboard()->setText(lines.join(u'\n'));
  }

  // Before the window's own Copy.
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress) return false;
    if (!static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) return false;
    if (event->type() == QEvent::KeyPress) copyToClipboard();
    event->accept();
    return true;
  }

  void clearAll() {
    messages.clear();
    list->clear();
    copy->setEnabled(false);
    clear->setEnabled(false);
  }

  void retranslate() {
    copy->setText(MessageList::tr("Copy"));
    copy->setToolTip(MessageList::tr("Copy the selected messages, or all of them, as text"));
    clear->setText(MessageList::tr("Clear"));
    clear->setToolTip(MessageList::tr("Empty this list"));
    list->setAccessibleName(MessageList::tr("Messages"));
    for (int i = 0; i < list->count(); ++i) show(*list->item(i), messages[static_cast<std::size_t>(i)]);
  }
};

MessageList::MessageList(Editor& editor, QWidget* parent)
    : QWidget(parent), impl_(std::make_unique<Impl>(this, editor)) {
  setObjectName(QStringLiteral("messageList"));
  Impl& impl = *impl_;
  impl.list = new QListWidget;
  impl.list->setObjectName(QStringLiteral("messages"));
  impl.list->setWordWrap(true);
  impl.list->setSelectionMode(QAbstractItemView::ExtendedSelection);
  impl.list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  impl.list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  impl.list->setResizeMode(QListView::Adjust);
  impl.copy = new QToolButton;
  impl.copy->setObjectName(QStringLiteral("messagesCopy"));
  impl.copy->setEnabled(false);
  impl.clear = new QToolButton;
  impl.clear->setObjectName(QStringLiteral("messagesClear"));
  impl.clear->setEnabled(false);
  impl.list->installEventFilter(impl_.get());
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(4, 2, 4, 4);
  bottom->addStretch(1);
  bottom->addWidget(impl.copy);
  bottom->addWidget(impl.clear);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(impl.list, 1);
  layout->addLayout(bottom);
  connect(impl.copy, &QToolButton::clicked, impl_.get(), [this] { impl_->copyToClipboard(); });
  connect(impl.clear, &QToolButton::clicked, impl_.get(), [this] { impl_->clearAll(); });
  impl.retranslate();
  impl.subscription = editor.subscribe(
      {.said = [this](const Text& text, Editor::Severity severity) { impl_->take(text, severity); }});
}

MessageList::~MessageList() { impl_->editor.unsubscribe(impl_->subscription); }

void MessageList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  impl_->list->scrollToBottom();
  if (impl_->unseen == 0) return;
  impl_->unseen = 0;
  emit unseen(0);
}

void MessageList::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) impl_->retranslate();
}

}  // namespace idap
