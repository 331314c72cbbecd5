// Loads the models that a home's pieces use, each once and in parallel, and shares their meshes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/progress.h"
#include "catalog/catalog.h"
#include "model/home.h"

namespace idap {

class ModelCache {
 public:
  ModelCache(const Home& home, const Catalog& catalog) : home_(home), catalog_(catalog) {}

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

  const Home& home_;
  const Catalog& catalog_;
  std::map<std::string, Entry> entries_;
};

}  // namespace idap
