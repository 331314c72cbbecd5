// The lines that draw a model: edges where it folds, ends or changes its material, as far as nothing hides
// them.
#pragma once

#include "editor/symbol/depth_raster.h"
#include "editor/symbol/symbol.h"
#include "editor/symbol/welded_mesh.h"

namespace idap {

// The longest first. raster: of the same mesh.
std::vector<SymbolLine> seenLines(const WeldedMesh& mesh, const DepthRaster& raster);

}  // namespace idap
