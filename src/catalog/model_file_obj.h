// The OBJ reader: polygons, texture coordinates, normals, smoothing groups and materials of a Wavefront OBJ
// file.
#pragma once

#include <string>
#include <string_view>

#include "catalog/model_file.h"
#include "catalog/model_file_mesh.h"

namespace idap {

// True where the first statements are those of an OBJ file.
bool looksLikeObj(std::string_view text);

// Groups without an "s" statement are smooth, as Java 3D's loader has it. Lines, points and curves are
// skipped. Throws ParseError with the line of a statement that cannot be read.
PolygonModel parseObj(std::string_view text, const std::string& name, const SiblingFiles& siblings,
                      const Progress* progress = nullptr);

}  // namespace idap
