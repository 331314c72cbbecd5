// The solid tools in the window: a submenu of Draw, and one button of the toolbar that opens into the five.
#pragma once

class QMenu;
class QToolBar;

namespace idap {

class WindowActions;
struct ToolInfo;

bool isSolidTool(const ToolInfo& tool);

// The caller gives the menu its title.
QMenu* addSolidMenu(QMenu& to, const WindowActions& actions);
// Takes the tool that was in hand last; the arrow beside it opens the others.
void addSolidButton(QToolBar& to, const WindowActions& actions);

}  // namespace idap
