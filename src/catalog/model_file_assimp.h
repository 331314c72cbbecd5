// 3DS, Collada, STL and glTF by way of the Asset Import Library, which sees no file but the model and its
// siblings.
#pragma once

#include <string>

#include "catalog/model_file.h"
#include "catalog/model_file_mesh.h"

namespace idap {

// extension ("3ds", "dae", "stl", "gltf", "glb") chooses the reader. Throws ParseError.
PolygonModel readWithAssimp(const Bytes& bytes, const std::string& name, const std::string& extension,
                            const SiblingFiles& siblings, const Progress* progress = nullptr);

}  // namespace idap
