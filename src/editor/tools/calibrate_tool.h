// Putting a scanned plan to its true size and place under the drawing.
#pragma once

#include <memory>

#include "editor/tool.h"
#include "model/ids.h"

namespace idap {

// Two points on the picture, then the true length between them: sets its scale, the first point stays.
std::unique_ptr<Tool> makeCalibrateTool(LevelId level);

// Drags the picture.
std::unique_ptr<Tool> makeMoveBackgroundTool(LevelId level);

}  // namespace idap
