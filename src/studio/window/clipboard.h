// Elements on the system's clipboard, as an .idap file of only these: so that they pass between windows and
// programs.
#pragma once

#include "editor/editor.h"

class QMimeData;

namespace idap {

void copySelection(Editor& editor);
void cutSelection(Editor& editor);

bool canPaste();
enum class PasteAs {
  Beside,  // a little off the original, so that it is seen
  InPlace,
  IntoGroup  // of the one group that is selected
};
void paste(Editor& editor, PasteAs how);
void pasteStyle(Editor& editor);  // of the first copied element, onto what is selected

}  // namespace idap
