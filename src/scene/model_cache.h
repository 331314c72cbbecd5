// Loads the models that a home's pieces use, each once and in parallel, and shares their meshes.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "catalog/catalog.h"
#include "model/home.h"

namespace idap {

class ModelCache {
 public:
  ModelCache() = default;
  ModelCache(const Home& home, const Catalog& catalog) { use(home, catalog); }

  // Another state of the home from now on; both must live while the cache is asked. Models that nobody asked
  // for lately go.
  void use(const Home& home, const Catalog& catalog);

  struct Entry {
    SurfaceModelPtr model;             // null when it could not be had
    std::shared_ptr<const Mesh> mesh;  // the model's
    std::string problem;
  };

  void prepare(const std::vector<const Piece*>& pieces, const Progress& progress);
  const Entry& get(const Piece& piece) const;  // a prepared one

 private:
  std::string keyOf(const Piece& piece) const;
  Entry load(const Piece& piece) const;

  struct Kept {
    Entry entry;
    SharedBytes file;  // held, so that no other file takes its place in memory: its address is in the key
    std::uint64_t usedAt = 0;
  };
  const Home* home_ = nullptr;
  const Catalog* catalog_ = nullptr;
  std::map<std::string, Kept> entries_;
  std::uint64_t build_ = 0;
};

}  // namespace idap
