// What a furniture library's tables say: its pieces, and where in the archive their models and icons are.
#pragma once

#include <string>
#include <vector>

#include "base/zip.h"
#include "catalog/catalog.h"

namespace idap {

struct LibraryIndex {
  struct Entry {
    CatalogPiece piece;
    std::string model, icon;  // entries of the archive; empty: none
  };
  std::string id, name, description, version, license, provider;
  std::vector<Entry> entries;
};

// fileName names the library in its pieces and in errors. Pieces without a size or a model are left out.
// Throws ParseError when the archive has no table.
LibraryIndex readLibraryIndex(const ZipReader& archive, const std::string& fileName);

}  // namespace idap
