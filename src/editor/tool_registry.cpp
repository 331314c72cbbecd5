#include "editor/tool.h"
#include "editor/tools/tool_list.h"

namespace idap {

const std::vector<ToolEntry>& tools() {
  static const std::vector<ToolEntry> all{
      selectTool(),        wallTool(),        roomTool(),           doorTool(),
      windowTool(),        openingTool(),     dimensionTool(),      labelTool(),
      polylineTool(),      cameraTool(),      eraserTool(),         solidBoxTool(),
      solidCylinderTool(), solidSphereTool(), solidExtrusionTool(), solidTurnedTool(),
  };
  return all;
}

}  // namespace idap
