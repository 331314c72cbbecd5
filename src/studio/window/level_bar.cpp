#include "studio/window/level_bar.h"

#include <QBoxLayout>
#include <QEvent>
#include <QTabBar>
#include <QToolButton>

#include "editor/commands/command.h"
#include "model/diff.h"
#include "model/edits/level_edits.h"
#include "studio/widgets/icons.h"
#include "studio/widgets/texts.h"

namespace idap {

LevelBar::LevelBar(Editor& editor, QWidget* parent)
    : QWidget(parent), editor_(editor), tabs_(new QTabBar(this)), add_(new QToolButton(this)) {
  setObjectName(QStringLiteral("levelBar"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(tabs_);
  layout->addWidget(add_);
  layout->addStretch();
  tabs_->setObjectName(QStringLiteral("levels"));
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  tabs_->setFocusPolicy(Qt::TabFocus);
  add_->setObjectName(QStringLiteral("addLevel"));
  add_->setAutoRaise(true);
  add_->setText(QStringLiteral("+"));
  if (const QIcon plus = icon("level-add"); !plus.isNull()) add_->setIcon(plus);

  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    if (!filling_ && index >= 0 && std::size_t(index) < levels_.size())
      editor_.setLevel(levels_[std::size_t(index)]);
  });
  connect(tabs_, &QTabBar::tabBarDoubleClicked, this, [this](int index) {
    if (index >= 0) emit propertiesRequested();
  });
  connect(add_, &QToolButton::clicked, this, [this] {
    if (const Command* command = findCommand("add-level")) command->run(editor_);
  });
  Editor::Listener listener;
  listener.changed = [this](Editor::Change change) {
    if (change == Editor::Change::Document || change == Editor::Change::Level) fill();
  };
  listener.homeChanged = [this](const Home& before, const Home& after) {
    if (!diff(before, after).levels.empty()) fill();
  };
  subscription_ = editor_.subscribe(std::move(listener));
  retranslate();
}

LevelBar::~LevelBar() { editor_.unsubscribe(subscription_); }

void LevelBar::fill() {
  std::vector<LevelId> levels = levelsInOrder(editor_.home());
  std::vector<std::string> names;
  for (const LevelId id : levels) names.push_back(editor_.home().levels.find(id)->name);
  filling_ = true;
  if (levels.empty()) {
    levels = {LevelId{}};
    names = {fromQt(tr("Ground floor"))};
  }
  if (levels != levels_ || names != names_) {
    while (tabs_->count() > int(levels.size())) tabs_->removeTab(tabs_->count() - 1);
    while (tabs_->count() < int(levels.size())) tabs_->addTab(QString());
    for (std::size_t i = 0; i < levels.size(); ++i) {
      QString text = toQt(names[i]);
      tabs_->setTabText(int(i), text.replace(QLatin1Char('&'), QStringLiteral("&&")));
      tabs_->setTabToolTip(int(i), tr("Draw on this level; a double click changes its name and heights"));
    }
    levels_ = std::move(levels);
    names_ = std::move(names);
  }
  for (std::size_t i = 0; i < levels_.size(); ++i)
    if (levels_[i] == editor_.level()) tabs_->setCurrentIndex(int(i));
  filling_ = false;
}

void LevelBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

void LevelBar::retranslate() {
  add_->setToolTip(tr("Add a level above this one"));
  add_->setAccessibleName(tr("Add level"));
  levels_.clear();
  fill();
}

}  // namespace idap
