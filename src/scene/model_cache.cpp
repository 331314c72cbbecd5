#include "scene/model_cache.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "base/error.h"
#include "catalog/model_file.h"

namespace idap {

namespace {

constexpr std::uint64_t kBuildsKept = 32;  // that a model nobody asked for is held

}  // namespace

std::string ModelCache::keyOf(const Piece& piece) const {
  const ModelRef& ref = piece.model;
  if (!ref.asset.empty()) {
    const auto& r = ref.rotation;
    const auto file = home_->assets->find(ref.asset);
    const void* bytes = file == home_->assets->end() ? nullptr : file->second.get();
    return fmt::format("file {} {}\n{} {} {} {} {} {} {} {} {} {}", ref.asset, bytes, r[0].x, r[0].y, r[0].z,
                       r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z, ref.smoothed);
  }
  if (ref.catalogId.empty()) return {};
  std::string key =
      fmt::format("piece {}\n{} {} {}", ref.catalogId, piece.size.x, piece.size.y, piece.size.z);
  for (const auto& [name, value] : ref.parameters) key += fmt::format("\n{} {}", name, value);
  return key;
}

ModelCache::Entry ModelCache::load(const Piece& piece) const {
  const ModelRef& ref = piece.model;
  Entry entry;
  try {
    if (!ref.asset.empty()) {
      const auto file = home_->assets->find(ref.asset);
      if (file == home_->assets->end() || !file->second) {
        entry.problem = "its model file \"" + ref.asset + "\" is missing";
        return entry;
      }
      const std::string folder = ref.asset.substr(0, ref.asset.rfind('/') + 1);
      const SiblingFiles siblings = [&](const std::string& path) -> SharedBytes {
        const auto found = home_->assets->find(folder + path);
        return found == home_->assets->end() ? nullptr : found->second;
      };
      ModelFileOptions options;
      options.rotation = ref.rotation;
      options.smoothed = ref.smoothed;
      entry.model =
          std::make_shared<const SurfaceModel>(readModelFile(*file->second, ref.asset, siblings, options));
    } else if (!ref.catalogId.empty()) {
      entry.model = catalog_->model(ref.catalogId, piece.size, ref.parameters);
      if (!entry.model) entry.problem = "the catalog has no piece \"" + ref.catalogId + "\"";
    } else {
      entry.problem = "it names no model";
    }
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& e) {
    entry.problem = e.what();
  }
  if (entry.model && entry.model->mesh.empty()) {
    entry.problem = "its model has no faces";
    entry.model.reset();
  }
  if (entry.model) entry.mesh = std::shared_ptr<const Mesh>(entry.model, &entry.model->mesh);
  return entry;
}

void ModelCache::use(const Home& home, const Catalog& catalog) {
  if (catalog_ && catalog_ != &catalog) entries_.clear();
  home_ = &home;
  catalog_ = &catalog;
  ++build_;
  std::erase_if(entries_, [this](const auto& e) { return e.second.usedAt + kBuildsKept < build_; });
}

void ModelCache::prepare(const std::vector<const Piece*>& pieces, const Progress& progress) {
  std::vector<std::pair<Entry*, const Piece*>> missing;
  for (const Piece* piece : pieces) {
    const auto [at, added] = entries_.try_emplace(keyOf(*piece));
    at->second.usedAt = build_;
    if (!added) continue;
    const auto file = home_->assets->find(piece->model.asset);
    if (file != home_->assets->end()) at->second.file = file->second;
    missing.emplace_back(&at->second.entry, piece);
  }
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    *missing[i].first = load(*missing[i].second);
  });
  if (progress.cancelled()) {
    for (const auto& [entry, piece] : missing) entries_.erase(keyOf(*piece));
    throw Cancelled();
  }
}

const ModelCache::Entry& ModelCache::get(const Piece& piece) const { return entries_.at(keyOf(piece)).entry; }

}  // namespace idap
