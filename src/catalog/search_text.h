// Finding catalog pieces by words.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "catalog/catalog.h"

namespace idap {

// UTF-8 text in lower case, Latin letters without their accents, so that "FAUTEUIL crème" is found as
// "creme". Other scripts stay as they are.
std::string foldedText(std::string_view text);

// The words of a query, folded.
std::vector<std::string> searchWords(std::string_view query);

// What of a piece can be found, folded, with its weight: kept by those who search at every key.
using SearchFields = std::vector<std::pair<int, std::string>>;
SearchFields searchFields(const CatalogPiece& piece);

// 0 unless every word is found somewhere; more where the name holds it than where a tag or a translation
// does.
int searchScore(const SearchFields& fields, const std::vector<std::string>& words);
int searchScore(const CatalogPiece& piece, const std::vector<std::string>& words);

}  // namespace idap
