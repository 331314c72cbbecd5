// The entries of the tool registry, one a file of this folder.
#pragma once

#include "editor/tool.h"

namespace idap {

ToolEntry selectTool();
ToolEntry wallTool();
ToolEntry roomTool();
ToolEntry doorTool();     // places the catalog's plainest door
ToolEntry windowTool();   // and window
ToolEntry openingTool();  // a passage with nothing in it
ToolEntry dimensionTool();
ToolEntry labelTool();
ToolEntry polylineTool();
ToolEntry solidBoxTool();
ToolEntry solidCylinderTool();
ToolEntry solidSphereTool();
ToolEntry solidExtrusionTool();
ToolEntry solidTurnedTool();
ToolEntry cameraTool();
ToolEntry eraserTool();

}  // namespace idap
