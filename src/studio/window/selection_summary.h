// What is selected, in a few words for the status bar.
#pragma once

#include <QString>

#include "editor/editor.h"

namespace idap {

QString selectionSummary(const Editor& editor);

}  // namespace idap
