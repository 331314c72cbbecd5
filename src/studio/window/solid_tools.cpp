#include "studio/window/solid_tools.h"

#include <QMenu>
#include <QToolBar>
#include <QToolButton>

#include "editor/tool.h"
#include "studio/window/window_actions.h"

namespace idap {

namespace {

void addTools(QMenu& to, const WindowActions& actions) {
  for (const ToolEntry& tool : tools())
    if (isSolidTool(*tool.info)) to.addAction(actions.get(std::string("tool-") + tool.info->id));
}

}  // namespace

bool isSolidTool(const ToolInfo& tool) { return std::string(tool.id).starts_with("solid-"); }

QMenu* addSolidMenu(QMenu& to, const WindowActions& actions) {
  QMenu* menu = to.addMenu(QString());
  menu->setObjectName(QStringLiteral("solidMenu"));
  addTools(*menu, actions);
  return menu;
}

void addSolidButton(QToolBar& to, const WindowActions& actions) {
  auto* button = new QToolButton(&to);
  button->setPopupMode(QToolButton::MenuButtonPopup);
  button->setAutoRaise(true);
  button->setIconSize(to.iconSize());
  // Of one width whichever tool it shows; what is plain by its picture needs no word.
  button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  auto* menu = new QMenu(button);
  addTools(*menu, actions);
  button->setMenu(menu);
  button->setDefaultAction(menu->actions().value(0));
  // By its key or from the menu bar too.
  for (QAction* action : menu->actions())
    QObject::connect(action, &QAction::toggled, button, [button, action](bool taken) {
      if (taken) button->setDefaultAction(action);
    });
  QObject::connect(&to, &QToolBar::iconSizeChanged, button, &QToolButton::setIconSize);
  to.addWidget(button)->setObjectName(QStringLiteral("solid"));  // the toolbar names its buttons after this
}

}  // namespace idap
