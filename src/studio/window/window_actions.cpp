#include "studio/window/window_actions.h"

#include <QKeySequence>
#include <QWidget>

#include "editor/commands/command.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

WindowActions::WindowActions(Editor& editor, QWidget* window)
    : QObject(window), editor_(editor), window_(window) {
  for (const ToolEntry& tool : tools()) {
    const ToolInfo& info = *tool.info;
    const std::string id = info.id;
    QAction* action = make({info.id, info.name, info.tip, info.shortcut}, "tool-" + id);
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, id] {
      editor_.takeTool(id);
      refresh();  // a click on the tool in hand would take the mark off
    });
    entry(action).ofHome = true;
    checkBy(action, [this, id] { return editor_.tool().info().id == id; });
  }
  for (const Command& command : commands()) {
    QAction* action = make({command.id, command.name, command.tip, command.shortcut}, command.id);
    entry(action).ofHome = true;
    if (command.enabled) enableBy(action, [this, &command] { return command.enabled(editor_); });
    if (command.checked) {
      action->setCheckable(true);
      checkBy(action, [this, &command] { return command.checked(editor_); });
    }
    connect(action, &QAction::triggered, this, [this, &command] {
      // What has changed since the last refresh counts too.
      if (!command.enabled || command.enabled(editor_)) command.run(editor_);
      refresh();
    });
  }
}

QAction* WindowActions::make(const ActionText& text, const std::string& id) {
  auto* action = new QAction(this);
  action->setObjectName(toQt(id));
  action->setShortcutContext(Qt::WindowShortcut);
  QList<QKeySequence> keys;
  for (const QString& key :
       QString::fromLatin1(text.shortcut).split(QStringLiteral("; "), Qt::SkipEmptyParts))
    keys.append(QKeySequence(key, QKeySequence::PortableText));
  action->setShortcuts(keys);
  window_->addAction(action);
  entries_.push_back({action, text, {}, {}});
  actions_[id] = action;
  return action;
}

QAction* WindowActions::add(const ActionText& text, std::function<void()> run) {
  QAction* action = make(text, text.id);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  return action;
}

QAction* WindowActions::addSwitch(const ActionText& text, std::function<void(bool)> run) {
  QAction* action = make(text, text.id);
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [run = std::move(run)](bool on) { run(on); });
  return action;
}

WindowActions::Entry& WindowActions::entry(QAction* action) {
  return *std::find_if(entries_.begin(), entries_.end(),
                       [action](const Entry& e) { return e.action == action; });
}

void WindowActions::enableBy(QAction* action, std::function<bool()> enabled) {
  entry(action).enabled = std::move(enabled);
}

void WindowActions::checkBy(QAction* action, std::function<bool()> checked) {
  entry(action).checked = std::move(checked);
}

void WindowActions::restWithoutHome(QAction* action) { entry(action).ofHome = true; }

QAction* WindowActions::get(const std::string& id) const {
  const auto found = actions_.find(id);
  return found == actions_.end() ? nullptr : found->second;
}

void WindowActions::refresh() {
  for (const Entry& entry : entries_) {
    entry.action->setEnabled((homeOpen_ || !entry.ofHome) && (!entry.enabled || entry.enabled()));
    if (entry.checked) entry.action->setChecked(entry.checked());
  }
}

void WindowActions::setHomeOpen(bool open) {
  homeOpen_ = open;
  refresh();
}

void WindowActions::retranslate() {
  for (const Entry& entry : entries_) {
    QAction* action = entry.action;
    const QString name = translated(entry.text.name);
    action->setText(name);
    action->setIconText(*entry.text.word ? translated(entry.text.word) : withoutKey(name));
    action->setIcon(icon(entry.text.id));
    const QString plain = withoutKey(name);
    QString tip = QStringLiteral("<b>") + plain.toHtmlEscaped() + QStringLiteral("</b>");
    if (!action->shortcut().isEmpty())
      tip += QStringLiteral(" (") + action->shortcut().toString(QKeySequence::NativeText).toHtmlEscaped() +
             QStringLiteral(")");
    if (*entry.text.tip) tip += QStringLiteral("<br>") + translated(entry.text.tip).toHtmlEscaped();
    action->setToolTip(tip);
    action->setStatusTip(translated(entry.text.tip));
  }
}

}  // namespace idap
