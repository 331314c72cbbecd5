// Light and dark.
#pragma once

#include "studio/window/preferences.h"

namespace idap {

// Every widget of the application gets the palette. System: as the desktop says, where it says anything.
void applyTheme(Preferences::Theme theme);

}  // namespace idap
