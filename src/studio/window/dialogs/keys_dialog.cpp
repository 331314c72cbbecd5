#include "studio/window/dialogs/keys_dialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>

#include "editor/tool.h"
#include "studio/widgets/texts.h"
#include "studio/window/window_actions.h"

namespace idap {

KeysDialog::KeysDialog(const WindowActions& actions, QWidget* parent)
    : QDialog(parent), actions_(actions), search_(new QLineEdit(this)), list_(new QTreeWidget(this)) {
  setObjectName(QStringLiteral("keysDialog"));
  search_->setObjectName(QStringLiteral("search"));
  search_->setClearButtonEnabled(true);
  list_->setObjectName(QStringLiteral("keyList"));
  list_->setColumnCount(2);
  list_->setRootIsDecorated(false);
  list_->setAlternatingRowColors(true);
  list_->setSelectionMode(QAbstractItemView::NoSelection);
  list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(search_, &QLineEdit::textChanged, this, &KeysDialog::filter);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(search_);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  const int em = fontMetrics().height();
  resize(44 * em, 32 * em);
  fill();
}

void KeysDialog::fill() {
  setWindowTitle(tr("Keys"));
  search_->setPlaceholderText(tr("Search"));
  list_->clear();
  list_->setHeaderLabels({tr("Keys"), tr("What they do")});
  const auto heading = [this](const QString& text) {
    auto* item = new QTreeWidgetItem(list_, {text});
    QFont bold = list_->font();
    bold.setBold(true);
    item->setFont(0, bold);
    item->setFirstColumnSpanned(true);
    item->setData(0, Qt::UserRole, true);
    return item;
  };
  const auto key = [this](const QString& keys, const QString& what) {
    new QTreeWidgetItem(list_, {QStringLiteral("   ") + keys, what});
  };
  heading(tr("Everywhere"));
  std::vector<std::pair<QString, const QAction*>> named;
  for (const auto& [id, action] : actions_.all())
    if (!action->shortcut().isEmpty()) named.emplace_back(withoutKey(action->text()), action);
  std::sort(named.begin(), named.end(),
            [](const auto& a, const auto& b) { return a.first.localeAwareCompare(b.first) < 0; });
  for (auto& [name, action] : named) {
    QStringList keys;
    for (const QKeySequence& sequence : action->shortcuts())
      keys << sequence.toString(QKeySequence::NativeText);
    const QString text = withoutKey(action->text()).remove(QStringLiteral("…"));
    const QString tip = action->statusTip();
    key(keys.join(QStringLiteral(", ")), tip.isEmpty() ? text : text + QStringLiteral(": ") + tip);
  }
  for (const ToolEntry& tool : tools()) {
    if (tool.info->keys.empty()) continue;
    heading(translated(tool.info->name));
    for (const ToolKey& one : tool.info->keys) key(translated(one.keys), translated(one.what));
  }
  filter();
}

void KeysDialog::filter() {
  const QString words = search_->text().trimmed();
  QTreeWidgetItem* heading = nullptr;
  bool any = false;
  const auto finish = [&] {
    if (heading) heading->setHidden(!any);
  };
  for (int i = 0; i < list_->topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    if (item->data(0, Qt::UserRole).toBool()) {
      finish();
      heading = item;
      any = false;
      continue;
    }
    const bool match = words.isEmpty() || item->text(0).contains(words, Qt::CaseInsensitive) ||
                       item->text(1).contains(words, Qt::CaseInsensitive);
    item->setHidden(!match);
    any = any || match;
  }
  finish();
}

void KeysDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) fill();
  QDialog::changeEvent(event);
}

}  // namespace idap
