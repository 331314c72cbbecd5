#include "catalog/library/own_models.h"

#include <fmt/format.h>

#include <algorithm>

#include "catalog/library/own_library.h"

namespace idap {

namespace {

bool isOwn(const ModelRef& model) { return model.asset.empty() && model.catalogId.starts_with("own/"); }

}  // namespace

bool usesOwnFurniture(const Home& home) {
  const auto own = [](const auto& entry) { return isOwn(entry.second->model); };
  return std::any_of(home.furniture.begin(), home.furniture.end(), own) ||
         std::any_of(home.openings.begin(), home.openings.end(), own);
}

Home withOwnModels(const Home& home, const OwnLibrary& library) {
  Home whole = home;
  auto assets = std::make_shared<Assets>(*home.assets);
  const auto bring = [&](auto& table) {
    const auto before = table;  // shares its elements
    for (const auto& [id, piece] : before) {
      if (!isOwn(piece->model)) continue;
      const OwnLibrary::Model model = library.modelOf(piece->model.catalogId);
      if (model.main.empty()) continue;
      // The same piece changed since in the library keeps its older files under another name.
      std::string folder;
      for (int n = 1;; ++n) {
        folder = n == 1 ? fmt::format("models/{}/", piece->model.catalogId)
                        : fmt::format("models/{}-{}/", piece->model.catalogId, n);
        const bool other = std::any_of(model.files.begin(), model.files.end(), [&](const auto& file) {
          const auto there = assets->find(fmt::format("{}{}", folder, file.first));
          return there != assets->end() && there->second && *there->second != *file.second;
        });
        if (!other) break;
      }
      for (const auto& [name, bytes] : model.files) (*assets)[fmt::format("{}{}", folder, name)] = bytes;
      auto changed = *piece;
      changed.model.asset = fmt::format("{}{}", folder, model.main);
      table.set(id, changed);
    }
  };
  bring(whole.furniture);
  bring(whole.openings);
  whole.assets = std::move(assets);
  return whole;
}

}  // namespace idap
