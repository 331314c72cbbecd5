// The program's icons by name: share/icons/NAME.svg, drawn in the colour of the theme's text, sharp at any
// scale.
#pragma once

#include <QIcon>

class QToolButton;
class QWidget;

namespace idap {

// An empty icon for an unknown name. Line art: every stroke of currentColor takes the palette's text colour,
// so that one drawing serves light and dark.
QIcon icon(const char* name);

// A flat button with that icon, as views have along their edge.
QToolButton* toolButton(const char* iconName, const char* objectName, QWidget* parent);

}  // namespace idap
