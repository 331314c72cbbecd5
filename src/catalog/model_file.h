// Reading model files (OBJ with MTL, 3DS, DAE, STL, glTF, or a ZIP holding one) into a SurfaceModel.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/progress.h"
#include "catalog/surface_model.h"

namespace idap {

// Finds a file beside the model (a material library, a texture) by its relative path; null when there is
// none.
using SiblingFiles = std::function<SharedBytes(const std::string& relativePath)>;

struct ModelFileOptions {
  std::array<Vec3, 3> rotation{Vec3{1, 0, 0}, Vec3{0, 1, 0},
                               Vec3{0, 0, 1}};  // applied before fitting, in Z-up object space
  bool smoothed = true;  // vertex normals where the file has none and its smoothing groups ask for them
  const Progress* progress = nullptr;  // told how far reading is; asked whether to stop: Cancelled is thrown
};

// name tells the format when the bytes do not. The result is Z up with a unit box (SurfaceModel::unitBox).
// Throws ParseError with name and line or element; a missing material library or texture is not an error.
SurfaceModel readModelFile(const Bytes& bytes, const std::string& name, const SiblingFiles& siblings,
                           const ModelFileOptions& options = {});

// The format by content first, by the name's extension second: "obj", "3ds", "dae", "stl", "gltf", "glb",
// "zip"; empty when it is no model file.
std::string modelFileKind(const Bytes& bytes, const std::string& name);

// Of the entries of an archive, the one that is the model; empty when none is.
std::string modelInArchive(const std::vector<std::string>& entries);

}  // namespace idap
