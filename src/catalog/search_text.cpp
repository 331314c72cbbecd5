#include "catalog/search_text.h"

#include <algorithm>
#include <cstdint>

namespace idap {
namespace {

// Letters U+00C0 to U+00FF without accent, in lower case; '?' keeps the letter.
constexpr std::string_view kLatin1 = "aaaaaa?ceeeeiiii?nooooo?ouuuuy??aaaaaa?ceeeeiiii?nooooo?ouuuuy?y";

constexpr int kCategoryWeight = 4;
constexpr int kWordBegins = 3;  // of wordScore
constexpr int kOfItsKind = 5;   // who looks for a door means one rather than a cabinet with doors

int wordScore(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  if (at == std::string::npos) return 0;
  const auto boundary = [&](std::size_t i) {
    return i == 0 || i >= text.size() || text[i] == ' ' || text[i] == '-';
  };
  // A whole word, the beginning of one, or anywhere.
  for (auto i = at; i != std::string::npos; i = text.find(word, i + 1))
    if (i == 0 || boundary(i - 1)) return boundary(i + word.size()) ? 4 : 3;
  return 2;
}

}  // namespace

std::string foldedText(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<std::uint8_t>(text[i]);
    if (c >= 'A' && c <= 'Z') {
      out += static_cast<char>(c + 32);
    } else if (c == 0xC3 && i + 1 < text.size()) {
      const auto low = static_cast<std::uint8_t>(text[i + 1]);
      const std::size_t letter = low & 0x3Fu;
      if (kLatin1[letter] != '?') {
        out += kLatin1[letter];
      } else {
        out += text[i];
        // AE, ETH, slashed O and thorn have their small letters 32 on; the signs * and / stay.
        out += static_cast<char>(letter < 32 && letter != 0x17 && letter != 0x1F ? low + 32 : low);
      }
      ++i;
    } else {
      out += text[i];
    }
  }
  return out;
}

std::vector<std::string> searchWords(std::string_view query) {
  std::vector<std::string> words;
  const std::string text = foldedText(query);
  for (std::size_t i = 0; i < text.size();) {
    const auto start = text.find_first_not_of(" \t\n,", i);
    if (start == std::string::npos) break;
    const auto end = std::min(text.find_first_of(" \t\n,", start), text.size());
    words.push_back(text.substr(start, end - start));
    i = end;
  }
  return words;
}

SearchFields searchFields(const CatalogPiece& piece) {
  SearchFields fields{{10, foldedText(piece.name)},
                      {kCategoryWeight, foldedText(piece.category)},
                      {2, foldedText(piece.creator)},
                      {2, foldedText(piece.id)}};
  for (const std::string& tag : piece.tags) fields.emplace_back(6, foldedText(tag));
  for (const auto& [language, texts] : piece.translations)
    for (const auto& [key, text] : texts)
      fields.emplace_back(key == "name" ? 9 : kCategoryWeight, foldedText(text));
  return fields;
}

int searchScore(const CatalogPiece& piece, const std::vector<std::string>& words) {
  return searchScore(searchFields(piece), words);
}

int searchScore(const SearchFields& fields, const std::vector<std::string>& words) {
  int total = 0;
  for (const std::string& word : words) {
    int best = 0, category = 0;
    for (const auto& [weight, text] : fields) {
      const int score = wordScore(text, word);
      best = std::max(best, weight * score);
      if (weight == kCategoryWeight && score >= kWordBegins) category = kOfItsKind;
    }
    if (best == 0) return 0;
    total += best + category;
  }
  return total;
}

}  // namespace idap
