// A furniture library file (SH3F): a ZIP with a table of pieces, their models and icons. The table is read
// once and kept in the user's cache; models and icons are read when asked for. Thread-safe.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "catalog/catalog.h"
#include "catalog/surface_model.h"

namespace idap {

class FurnitureLibrary {
 public:
  // Reads the table of pieces, from the cache where the file's path, size and time are those of the last
  // time. Throws IoError, ParseError.
  static std::shared_ptr<FurnitureLibrary> open(
      const std::filesystem::path& file, const std::filesystem::path& cacheFolder = defaultCacheFolder());
  static std::filesystem::path defaultCacheFolder();  // in userCacheFolder()
  ~FurnitureLibrary();

  const std::filesystem::path& file() const;
  const std::string& name() const;  // as the library calls itself
  const std::string& description() const;
  const std::string& license() const;
  bool cameFromCache() const;

  const std::vector<CatalogPiecePtr>& pieces() const;  // in the order of the file
  CatalogPiecePtr find(const std::string& id) const;   // null when unknown

  // The piece's model with a unit box, shared while anybody holds it. Null for a piece of another library.
  // ParseError when the model is missing or damaged.
  SurfaceModelPtr model(const CatalogPiece& piece) const;
  // The picture beside the piece's name (PNG, JPEG, …). Null when there is none.
  SharedBytes icon(const CatalogPiece& piece) const;

 private:
  struct Impl;
  explicit FurnitureLibrary(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace idap
