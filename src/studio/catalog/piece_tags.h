// Words that catalog pieces are tagged with and that help to choose among many, in the user's language.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "catalog/catalog.h"

namespace idap {

// The tags worth offering for these pieces: those that tell some from others, the most frequent first.
std::vector<std::string> usefulTags(const std::vector<CatalogPiecePtr>& pieces, std::size_t most);
QString tagName(const std::string& tag);
bool hasTag(const CatalogPiece& piece, const std::string& tag);

}  // namespace idap
