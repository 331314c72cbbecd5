#include "editor/symbol/piece_model.h"

#include "catalog/model_file.h"

namespace idap {

SurfaceModelPtr pieceModel(const Piece& piece, const Assets& assets, const Catalog& catalog) {
  const ModelRef& ref = piece.model;
  if (ref.asset.empty())
    return ref.catalogId.empty() ? nullptr : catalog.model(ref.catalogId, piece.size, ref.parameters);
  const auto file = assets.find(ref.asset);
  if (file == assets.end() || !file->second) return nullptr;
  const std::string folder = ref.asset.substr(0, ref.asset.rfind('/') + 1);
  const SiblingFiles siblings = [&](const std::string& path) -> SharedBytes {
    const auto found = assets.find(folder + path);
    return found == assets.end() ? nullptr : found->second;
  };
  ModelFileOptions options;
  options.rotation = ref.rotation;
  options.smoothed = false;  // plans want faces, not normals
  return std::make_shared<const SurfaceModel>(readModelFile(*file->second, ref.asset, siblings, options));
}

}  // namespace idap
