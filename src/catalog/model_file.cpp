#include "catalog/model_file.h"

#include <algorithm>
#include <cctype>
#include <iterator>

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
  const std::string model = modelInArchive(archive->entries());
  if (model.empty()) throw ParseError(name, "", "the archive holds no model");
  const std::size_t slash = model.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : model.substr(0, slash + 1);
  const SiblingFiles inside = [archive, folder](const std::string& path) -> SharedBytes {
    if (!archive->contains(folder + path)) return nullptr;
    return std::make_shared<const Bytes>(archive->read(folder + path));
  };
  const Bytes content = archive->read(model);
  if (looksLikeZip(content)) throw ParseError(name, model, "an archive in an archive");
  return readModelFile(content, model, inside, options);
}

}  // namespace

std::string modelFileKind(const Bytes& bytes, const std::string& name) {
  if (looksLikeZip(bytes)) return "zip";
  if (std::string kind = sniffed(bytes); !kind.empty()) return kind;
  std::string extension = extensionOf(name);
  const bool known =
      std::find(std::begin(kExtensions), std::end(kExtensions), extension) != std::end(kExtensions);
  return known ? extension : std::string();
}

std::string modelInArchive(const std::vector<std::string>& entries) {
  std::string best;
  auto rank = std::ptrdiff_t(std::size(kExtensions));
  for (const std::string& entry : entries) {
    const auto place =
        std::find(std::begin(kExtensions), std::end(kExtensions), extensionOf(entry)) - kExtensions;
    if (place >= rank) continue;
    rank = place;
    best = entry;
  }
  return best;
}

SurfaceModel readModelFile(const Bytes& bytes, const std::string& name, const SiblingFiles& siblings,
                           const ModelFileOptions& options) {
  const std::string kind = modelFileKind(bytes, name);
  if (kind.empty())
    throw ParseError(name, "", "not a model of a known kind (OBJ, 3DS, DAE, STL, glTF, or a ZIP of one)");
  if (kind == "zip") return readArchived(bytes, name, options);
  PolygonModel polygons = kind == "obj" ? parseObj(asText(bytes), name, siblings, options.progress)
                                        : readWithAssimp(bytes, name, kind, siblings, options.progress);
  SurfaceModel model = surfaceModelOf(std::move(polygons), options.rotation, options.smoothed);
  if (model.mesh.empty()) throw ParseError(name, "", "the model has no faces");
  return model;
}

}  // namespace idap
