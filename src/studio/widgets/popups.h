// Placing popups of our own.
#pragma once

#include <QWidget>

namespace idap {

// Shows a popup under a widget, or above it where there is more room, wholly on the screen.
void showBeside(QWidget& popup, const QWidget& widget);

}  // namespace idap
