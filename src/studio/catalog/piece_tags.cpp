#include "studio/catalog/piece_tags.h"

#include <array>
#include <unordered_map>

#include "studio/widgets/texts.h"

namespace idap {

namespace {

// Those that are offered; others are found by searching.
constexpr std::array kOffered{
    QT_TRANSLATE_NOOP("idap", "modern"),     QT_TRANSLATE_NOOP("idap", "classic"),
    QT_TRANSLATE_NOOP("idap", "wood"),       QT_TRANSLATE_NOOP("idap", "glass"),
    QT_TRANSLATE_NOOP("idap", "bedroom"),    QT_TRANSLATE_NOOP("idap", "living"),
    QT_TRANSLATE_NOOP("idap", "dining"),     QT_TRANSLATE_NOOP("idap", "kitchen"),
    QT_TRANSLATE_NOOP("idap", "office"),     QT_TRANSLATE_NOOP("idap", "hall"),
    QT_TRANSLATE_NOOP("idap", "wall"),       QT_TRANSLATE_NOOP("idap", "mirror"),
    QT_TRANSLATE_NOOP("idap", "lamp"),       QT_TRANSLATE_NOOP("idap", "pot"),
    QT_TRANSLATE_NOOP("idap", "base"),       QT_TRANSLATE_NOOP("idap", "textile"),
    QT_TRANSLATE_NOOP("idap", "industrial"), QT_TRANSLATE_NOOP("idap", "scandinavian"),
    QT_TRANSLATE_NOOP("idap", "hanging"),    QT_TRANSLATE_NOOP("idap", "interior"),
    QT_TRANSLATE_NOOP("idap", "entrance"),   QT_TRANSLATE_NOOP("idap", "desk"),
    QT_TRANSLATE_NOOP("idap", "drawers"),    QT_TRANSLATE_NOOP("idap", "pendant"),
    QT_TRANSLATE_NOOP("idap", "ceiling"),    QT_TRANSLATE_NOOP("idap", "standing"),
    QT_TRANSLATE_NOOP("idap", "sconce"),     QT_TRANSLATE_NOOP("idap", "round"),
    QT_TRANSLATE_NOOP("idap", "steel"),      QT_TRANSLATE_NOOP("idap", "ceramic"),
    QT_TRANSLATE_NOOP("idap", "media"),      QT_TRANSLATE_NOOP("idap", "books"),
    QT_TRANSLATE_NOOP("idap", "storage"),    QT_TRANSLATE_NOOP("idap", "casement"),
    QT_TRANSLATE_NOOP("idap", "fixed"),      QT_TRANSLATE_NOOP("idap", "sliding"),
    QT_TRANSLATE_NOOP("idap", "art"),        QT_TRANSLATE_NOOP("idap", "coffee"),
    QT_TRANSLATE_NOOP("idap", "tall"),       QT_TRANSLATE_NOOP("idap", "small"),
    QT_TRANSLATE_NOOP("idap", "bar"),        QT_TRANSLATE_NOOP("idap", "armchair"),
    QT_TRANSLATE_NOOP("idap", "stool"),      QT_TRANSLATE_NOOP("idap", "retro"),
    QT_TRANSLATE_NOOP("idap", "succulent"),  QT_TRANSLATE_NOOP("idap", "flowers"),
    QT_TRANSLATE_NOOP("idap", "sink"),       QT_TRANSLATE_NOOP("idap", "oven"),
    QT_TRANSLATE_NOOP("idap", "leather"),    QT_TRANSLATE_NOOP("idap", "fabric"),
    QT_TRANSLATE_NOOP("idap", "velvet"),     QT_TRANSLATE_NOOP("idap", "spot"),
    QT_TRANSLATE_NOOP("idap", "bath"),       QT_TRANSLATE_NOOP("idap", "shower"),
    QT_TRANSLATE_NOOP("idap", "children"),   QT_TRANSLATE_NOOP("idap", "music"),
    QT_TRANSLATE_NOOP("idap", "computer"),
};

}  // namespace

std::vector<std::string> usefulTags(const std::vector<CatalogPiecePtr>& pieces, std::size_t most) {
  std::unordered_map<std::string, std::size_t> counts;
  for (const CatalogPiecePtr& piece : pieces)
    for (const std::string& tag : piece->tags) ++counts[tag];
  std::vector<std::pair<std::size_t, std::string>> useful;
  for (const char* tag : kOffered)
    if (const auto found = counts.find(tag);
        found != counts.end() && found->second >= 2 && found->second < pieces.size())
      useful.emplace_back(found->second, tag);
  std::stable_sort(useful.begin(), useful.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> tags;
  for (const auto& [count, tag] : useful)
    if (tags.size() < most) tags.push_back(tag);
  return tags;
}

QString tagName(const std::string& tag) { return translated(tag.c_str()); }

bool hasTag(const CatalogPiece& piece, const std::string& tag) {
  return std::find(piece.tags.begin(), piece.tags.end(), tag) != piece.tags.end();
}

}  // namespace idap
