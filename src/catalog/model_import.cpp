#include "catalog/model_import.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/file.h"
#include "base/utf8.h"
#include "base/zip.h"
#include "catalog/model_file.h"
#include "geometry/transform.h"

namespace idap {

namespace {

constexpr std::size_t kMaxFileBytes = std::size_t{512} << 20;
constexpr ZipLimits kZipLimits{
    .maxEntries = 20'000, .maxEntryBytes = kMaxFileBytes, .maxTotalBytes = std::size_t{1} << 30};

// A path below the model's folder, and nothing else.
bool staysInside(const std::string& path) {
  if (path.empty() || path.find('\\') != std::string::npos || path.find(':') != std::string::npos)
    return false;
  const std::filesystem::path p(path);
  return p.is_relative() && std::none_of(p.begin(), p.end(), [](const auto& part) { return part == ".."; });
}

void readArchive(const SharedBytes& bytes, const std::string& name, ModelImport& into,
                 const Progress& progress) {
  const ZipReader archive(bytes, name, kZipLimits);
  into.main = modelInArchive(archive.entries());
  if (into.main.empty()) throw ParseError(name, "", "the archive holds no model (OBJ, 3DS, DAE, STL, glTF)");
  const std::string folder = into.main.substr(0, into.main.rfind('/') + 1);
  for (const std::string& entry : archive.entries()) {
    progress.check();
    if (!entry.starts_with(folder)) continue;
    into.files.emplace(entry.substr(folder.size()), std::make_shared<const Bytes>(archive.read(entry)));
  }
  into.main = into.main.substr(folder.size());
}

bool saysZUp(const Bytes& collada) {
  constexpr std::size_t kHead = 65536;  // it stands in the first element
  return asText(collada).substr(0, kHead).find("Z_UP") != std::string_view::npos;
}

std::string properName(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name = toValidUtf8(name);
  if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 32);
  return name;
}

}  // namespace

ModelImport readModelImport(const std::filesystem::path& file, const Progress& progress) {
  ModelImport import;
  const std::string fileName = file.filename().string();
  import.name = properName(file.stem().string());
  const auto bytes = std::make_shared<const Bytes>(readFile(file, kMaxFileBytes));
  progress.check();
  if (modelFileKind(*bytes, fileName) == "zip") {
    readArchive(bytes, fileName, import, progress);
  } else {
    import.main = fileName;
    import.files.emplace(fileName, bytes);
  }
  const SharedBytes model = import.files.at(import.main);
  import.kind = modelFileKind(*model, import.main);
  const std::filesystem::path folder = file.parent_path();
  const bool onDisk = import.files.size() == 1 && import.main == fileName;
  const SiblingFiles siblings = [&](const std::string& path) -> SharedBytes {
    progress.check();
    if (const auto found = import.files.find(path); found != import.files.end()) return found->second;
    if (!onDisk || !staysInside(path)) return nullptr;
    std::error_code failed;
    if (!std::filesystem::is_regular_file(folder / path, failed)) return nullptr;
    try {
      auto content = std::make_shared<const Bytes>(readFile(folder / path, kMaxFileBytes));
      import.files.emplace(path, content);
      return content;
    } catch (const IoError&) {
      return nullptr;
    }
  };
  const SurfaceModel surface = readModelFile(*model, import.main, siblings, {.progress = &progress});
  import.triangles = surface.mesh.triangles.size();
  import.fileSize = surface.fileSize;
  import.zUp = import.kind == "stl" || import.kind == "3ds" || (import.kind == "dae" && saysZUp(*model));
  for (const SurfaceModel::Slot& slot : surface.slots)
    import.parts.push_back({slot.name, slot.material.color, slot.material.texture.has_value()});
  return import;
}

double likelyUnit(const ModelImport& model) {
  const double longest = std::max({model.fileSize.x, model.fileSize.y, model.fileSize.z});
  // glTF says metres; printers' files are in millimetres.
  if (model.kind == "gltf" || model.kind == "glb") return 1;
  if (model.kind == "stl" && longest > 10) return 0.001;
  if (longest <= 6) return 1;
  return longest <= 600 ? 0.01 : 0.001;
}

UpAxis likelyUp(const ModelImport& model) { return model.zUp ? UpAxis::Z : UpAxis::Y; }

namespace {

// What is up in a file with z up, as the axis that would be up in one with y up: x, y, z have become x, -z,
// y.
UpAxis asInYUp(UpAxis up) {
  switch (up) {
    case UpAxis::Y:
      return UpAxis::MinusZ;
    case UpAxis::MinusY:
      return UpAxis::Z;
    case UpAxis::Z:
      return UpAxis::Y;
    case UpAxis::MinusZ:
      return UpAxis::MinusY;
    default:
      return up;
  }
}

}  // namespace

std::array<Vec3, 3> importRotation(UpAxis up, int quarterTurns, bool zUp) {
  if (zUp) up = asInYUp(up);
  constexpr double kQuarter = kPi / 2;
  Transform upright;
  switch (up) {
    case UpAxis::Y:
      break;
    case UpAxis::Z:
      upright = Transform::rotationX(-kQuarter);
      break;
    case UpAxis::X:
      upright = Transform::rotationY(-kQuarter);
      break;
    case UpAxis::MinusY:
      upright = Transform::rotationX(2 * kQuarter);
      break;
    case UpAxis::MinusZ:
      upright = Transform::rotationX(kQuarter);
      break;
    case UpAxis::MinusX:
      upright = Transform::rotationY(kQuarter);
      break;
  }
  const Transform all = Transform::rotationZ(kQuarter * quarterTurns) * upright;
  const auto exact = [](Vec3 v) { return Vec3{std::round(v.x), std::round(v.y), std::round(v.z)}; };
  return {exact(all.x), exact(all.y), exact(all.z)};
}

Vec3 rotatedSize(Vec3 size, const std::array<Vec3, 3>& rotation) {
  // fileSize is that of the model turned Z up already.
  Vec3 turned;
  for (int axis = 0; axis < 3; ++axis)
    for (int k = 0; k < 3; ++k)
      turned[k] += std::abs(rotation[static_cast<std::size_t>(axis)][k]) * size[axis];
  return turned;
}

std::string freeAssetFolder(const std::map<std::string, SharedBytes>& assets, const std::string& name) {
  std::string safe;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (c >= 'A' && c <= 'Z')
      safe += static_cast<char>(c + 32);
    else if (plain)
      safe += c;
    else if (!safe.empty() && safe.back() != '-')
      safe += '-';
  }
  while (!safe.empty() && safe.back() == '-') safe.pop_back();
  if (safe.empty()) safe = "model";
  for (int number = 1;; ++number) {
    std::string folder = "models/";
    folder += safe;
    if (number > 1) folder.append("-").append(std::to_string(number));
    folder += '/';
    const auto at = assets.lower_bound(folder);
    if (at == assets.end() || !at->first.starts_with(folder)) return folder;
  }
}

}  // namespace idap
