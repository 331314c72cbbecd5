// Moves elements that are held already, from a press to the release: for views that find out by themselves
// what the pointer holds.
#pragma once

#include <memory>

#include "editor/selection.h"
#include "editor/tool.h"

namespace idap {

// lead: the one under the pointer, which snaps for all. The press comes next.
std::unique_ptr<Tool> makeHeldMoveTool(Elements elements, AnyId lead);

}  // namespace idap
