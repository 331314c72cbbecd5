#include "catalog/opening_kind.h"

#include <algorithm>
#include <cctype>

namespace idap {

namespace {

constexpr double kStepOver = 0.2;    // m, highest sill one walks over
constexpr double kWalkHeight = 1.9;  // m, lowest opening one walks through

std::string lowered(const std::string& text) {
  std::string result = text;
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return result;
}

}  // namespace

OpeningKind openingKindOf(const std::string& catalogId, const std::string& name, double sill, double height,
                          bool hasLeaves) {
  const std::string words = lowered(catalogId) + ' ' + lowered(name);
  const auto says = [&](const char* word) { return words.find(word) != std::string::npos; };
  if (says("doorframe") || says("door frame")) return OpeningKind::Bare;
  const bool walkThrough = sill <= kStepOver && height >= kWalkHeight;
  if (says("window")) {
    const bool opens = hasLeaves || says("french") || says("slid");
    return walkThrough && opens && !says("fixed") ? OpeningKind::Door : OpeningKind::Window;
  }
  if (says("door") || says("gate")) return OpeningKind::Door;
  return walkThrough ? OpeningKind::Door : OpeningKind::Window;
}

}  // namespace idap
