// The place tool for doors, windows and bare openings.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "editor/editor.h"

namespace idap {

struct OpeningToPlace {
  const ToolInfo* info;
  const char* editName;  // marked for translation
  // Asked when the tool is taken in hand; none where the catalog has no such piece.
  std::function<std::optional<Opening>(const Editor&)> make;
  bool once = false;
};

std::unique_ptr<Tool> makePlaceOpeningTool(OpeningToPlace what);

}  // namespace idap
