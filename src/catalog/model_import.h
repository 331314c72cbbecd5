// A model file on its way into a home: read with all that lies beside it, checked, measured.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/progress.h"
#include "catalog/surface_model.h"

namespace idap {

struct ModelImport {
  std::map<std::string, SharedBytes> files;  // the model and what it uses, by relative path
  std::string main;                          // which of them is the model
  std::string kind;                          // "obj", "3ds", "dae", "stl", "gltf", "glb"
  std::string name;                          // a proposal for the piece, from the file's name
  bool zUp = false;                          // the file's z is its up: STL, 3DS, DAE that says so
  std::size_t triangles = 0;
  Vec3 fileSize;  // in the file's own unit, stood up as the file has it
  struct Part {   // a material slot
    std::string name;
    Color color;
    bool pictured = false;  // a picture lies on it
  };
  std::vector<Part> parts;
};

// A file of catalog/model_file.h, or a ZIP with one. Throws IoError and ParseError with what is wrong, and
// Cancelled.
ModelImport readModelImport(const std::filesystem::path& file, const Progress& progress = {});

// How many metres the file's unit probably is, so that the piece comes out in a size that furniture has.
double likelyUnit(const ModelImport& model);

// Which of the file's axes points up.
enum class UpAxis { Y, Z, X, MinusY, MinusZ, MinusX };
UpAxis likelyUp(const ModelImport& model);

// ModelRef::rotation for an axis of the file that is up and quarter turns (counter-clockwise, seen from
// above) on top. zUp: as ModelImport::zUp; such files have been stood up by their reader.
std::array<Vec3, 3> importRotation(UpAxis up, int quarterTurns, bool zUp = false);
// ModelImport::fileSize after that rotation.
Vec3 rotatedSize(Vec3 size, const std::array<Vec3, 3>& rotation);

// A path for the model's folder among the assets that none there begins with: "models/chair-2/".
std::string freeAssetFolder(const std::map<std::string, SharedBytes>& assets, const std::string& name);

}  // namespace idap
