// The built-in pieces: what share/catalog/*.json says of each, and the building of their models.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "catalog/parametric/registry.h"

namespace idap::parametric {

struct SlotMaterial {
  std::string material;
  std::optional<Color> color;
};

struct BuiltinPiece {
  CatalogPiecePtr piece;
  Generator generator = nullptr;
  Parameters parameters;
  std::map<std::string, SlotMaterial> slots;
};

struct BuiltinCatalog {
  std::vector<Catalog::Category> categories;  // in the order they are shown, with their counts
  std::map<std::string, std::map<std::string, std::string>> categoryNames;  // id -> language -> name
  std::vector<BuiltinPiece> pieces;
  std::map<std::string, std::size_t, std::less<>> byId;

  const BuiltinPiece* find(std::string_view id) const;
};

// Read once, from what is embedded in the program. Throws ParseError where that is wrong.
const BuiltinCatalog& builtinCatalog();

// Pieces of one file's text, added to a catalog. Throws ParseError with the file and the piece's id.
void readPieces(std::string_view text, const std::string& file, BuiltinCatalog& into);

// The parameters of a model: the piece's own, with these values kept within their bounds put over them.
Parameters withChanges(const BuiltinPiece& piece, const std::map<std::string, double>& changes);

// Built at that size, kept within the piece's smallest and largest. A size that is not positive or finite is
// the default one.
SurfaceModel buildModel(const BuiltinPiece& piece, Vec3 size,
                        const std::map<std::string, double>& changes = {});

}  // namespace idap::parametric
