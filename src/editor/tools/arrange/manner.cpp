#include "editor/tools/arrange/manner.h"

#include <algorithm>
#include <cctype>

namespace idap {

namespace {

// Lower case, everything but letters a blank, one before and after: " bed double ".
std::string wordsOf(const std::string& text) {
  std::string words = " ";
  bool small = false;  // the letter before was one: doubleBed is two words
  for (const char c : text) {
    const auto letter = static_cast<unsigned char>(c);
    const bool capital = std::isupper(letter) != 0;
    if ((!std::isalpha(letter) || (capital && small)) && words.back() != ' ') words += ' ';
    if (std::isalpha(letter)) words += static_cast<char>(std::tolower(letter));
    small = std::islower(letter) != 0;
  }
  if (words.back() != ' ') words += ' ';
  return words;
}

Manner mannerFrom(const std::string& words, Vec3 size, double elevation, bool ceiling, bool lamp) {
  if (ceiling) return Manner::Ceiling;
  if (says(words, "curtain blind drape")) return Manner::AtWindow;
  if (size.z < 0.06 && size.x > 0.6 && size.y > 0.4) return Manner::Floor;
  if (elevation > 0.05) return Manner::OnWall;
  if (lamp) return size.z < 0.85 ? Manner::OnTop : Manner::Corner;
  if (says(words, "rug carpet")) return Manner::Floor;
  if (says(words, "nightstand bedside night") && size.x < 0.8) return Manner::BesideBed;
  if (says(words, "bed cot crib") && size.y > 1) return Manner::Bed;
  const bool small = size.x <= 0.7 && size.y <= 0.6 && size.z <= 0.8;
  if (small && says(words,
                    "vase laptop monitor computer microwave radio bowl candle book plant cushion "
                    "succulent cactus herb tulip daisies toaster kettle clock"))
    return Manner::OnTop;
  if (says(words, "tv television") && !says(words, "bench cabinet stand")) return Manner::OnTop;
  if (says(words, "tv media") && size.z < 0.8) return Manner::Screen;
  if (says(words, "plant ficus palm tree")) return size.z < 0.6 ? Manner::OnTop : Manner::Corner;
  if (says(words, "sofa couch armchair loveseat")) return Manner::Sofa;
  if (says(words, "chair stool")) return Manner::Seat;
  if (says(words, "pouf ottoman footstool")) return Manner::LowTable;
  if (says(words, "coffee") && size.z < 0.6) return Manner::LowTable;
  if (says(words, "desk vanity dressing") && size.y < 1.2) return Manner::Desk;
  if (says(words, "table island") && !says(words, "console side")) return Manner::Table;
  return Manner::Storage;
}

}  // namespace

std::string wordsOf(const CatalogPiece& piece) {
  std::string text = piece.id + ' ' + piece.name + ' ' + piece.category;
  for (const std::string& tag : piece.tags) text += ' ' + tag;
  return wordsOf(text);
}

std::string wordsOf(const Furniture& piece) { return wordsOf(piece.model.catalogId + ' ' + piece.name); }

bool says(const std::string& words, const char* wanted) {
  const std::string list = wanted;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t to = std::min(list.find(' ', from), list.size());
    const std::string word = list.substr(from, to - from);
    // A word may be written in one with another: nightstand, bookcase, armchairs.
    if (words.find(' ' + word + ' ') != std::string::npos ||
        words.find(' ' + word + "s ") != std::string::npos)
      return true;
    from = to + 1;
  }
  return false;
}

Manner mannerOf(const CatalogPiece& piece) {
  return mannerFrom(wordsOf(piece), piece.size, piece.elevation, piece.ceilingMounted,
                    piece.kind == PieceKind::Lamp);
}

Manner mannerOf(const Furniture& piece) {
  return mannerFrom(wordsOf(piece), piece.size, piece.position.z, false, piece.lamp.has_value());
}

double topOf(const Furniture& piece, Manner manner, const std::string& words) {
  if (!piece.visible || piece.pitch != 0 || piece.roll != 0) return 0;
  switch (manner) {
    case Manner::BesideBed:
    case Manner::Screen:
    case Manner::Desk:
    case Manner::Storage:
    case Manner::Table:
    case Manner::LowTable:
      break;
    default:
      return 0;
  }
  if (says(words, "toilet bidet shower bathtub washbasin basin sink hob mirror pouf ottoman stair")) return 0;
  const double top = piece.dropOnTopHeight.value_or(piece.size.z);
  return piece.position.z + top > 0.25 && piece.position.z + top < 1.3 ? top : 0;
}

}  // namespace idap
