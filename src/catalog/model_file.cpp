#include "catalog/model_file.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>

#include "base/error.h"
#include "base/zip.h"
#include "catalog/model_file_assimp.h"
#include "catalog/model_file_mesh.h"
#include "catalog/model_file_obj.h"

namespace idap {

namespace {

// In the order in which an archive's entries are preferred.
constexpr std::string_view kExtensions[] = {"obj", "dae", "3ds", "glb", "gltf", "stl"};

std::string extensionOf(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || name.find('/', dot) != std::string::npos) return {};
  std::string extension = name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool isBinaryStl(const Bytes& bytes) {
  if (bytes.size() < 84) return false;
  const auto byte = [&](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
  const std::size_t triangles = byte(80) | byte(81) << 8 | byte(82) << 16 | byte(83) << 24;
  return bytes.size() == 84 + 50 * triangles;
}

// The format by its content; empty when none is recognized.
std::string sniffed(const Bytes& bytes) {
  const std::string_view text = asText(bytes);
  const std::string_view head = text.substr(0, 4096);
  if (head.starts_with("glTF")) return "glb";
  if (head.starts_with("MM") && bytes.size() > 6) return "3ds";
  if (head.find("<COLLADA") != std::string_view::npos) return "dae";
  const std::size_t first = head.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first != std::string_view::npos && head[first] == '{') return "gltf";
  if (isBinaryStl(bytes) || (head.starts_with("solid") && text.find("facet") != std::string_view::npos))
    return "stl";
  return looksLikeObj(text) ? "obj" : "";
}

SurfaceModel readArchived(const Bytes& bytes, const std::string& name, const ModelFileOptions& options) {
  const auto archive = std::make_shared<const ZipReader>(std::make_shared<const Bytes>(bytes), name);
  const std::string* best = nullptr;
  auto rank = std::size(kExtensions);
  for (const std::string& entry : archive->entries()) {
    const auto found = std::find(std::begin(kExtensions), std::end(kExtensions), extensionOf(entry));
    const auto place = std::size_t(std::distance(std::begin(kExtensions), found));
    if (place < rank) {
      rank = place;
      best = &entry;
    }
  }
  if (!best) throw ParseError(name, "", "the archive holds no model");
  const std::size_t slash = best->rfind('/');
  const std::string folder = slash == std::string::npos ? "" : best->substr(0, slash + 1);
  const SiblingFiles inside = [archive, folder](const std::string& path) -> SharedBytes {
    if (!archive->contains(folder + path)) return nullptr;
    return std::make_shared<const Bytes>(archive->read(folder + path));
  };
  return readModelFile(archive->read(*best), *best, inside, options);
}

}  // namespace

SurfaceModel readModelFile(const Bytes& bytes, const std::string& name, const SiblingFiles& siblings,
                           const ModelFileOptions& options) {
  if (looksLikeZip(bytes)) return readArchived(bytes, name, options);
  std::string format = sniffed(bytes);
  if (format.empty()) format = extensionOf(name);
  PolygonModel polygons;
  if (format == "obj") {
    polygons = parseObj(asText(bytes), name, siblings);
  } else if (std::find(std::begin(kExtensions), std::end(kExtensions), format) != std::end(kExtensions)) {
    polygons = readWithAssimp(bytes, name, format, siblings);
  } else {
    throw ParseError(name, "", "not a model of a known kind (OBJ, 3DS, DAE, STL, glTF, or a ZIP of one)");
  }
  SurfaceModel model = surfaceModelOf(std::move(polygons), options.rotation, options.smoothed);
  if (model.mesh.empty()) throw ParseError(name, "", "the model has no faces");
  return model;
}

}  // namespace idap
