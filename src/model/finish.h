// How a face looks: which material of the catalog, and what differs from it. Empty members keep what is
// there.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "geometry/vec.h"

namespace idap {

// A colour as people pick it: sRGB-encoded, 0..1.
struct Color {
  float r = 1, g = 1, b = 1;
  friend bool operator==(const Color&, const Color&) = default;
};

// A picture laid over a face. asset names an entry of Home::assets or "catalog:ID" a texture of the catalog.
struct TextureRef {
  std::string asset;
  Vec2 size{1, 1};         // m that one copy of the picture covers
  Vec2 offset{};           // m
  double angle = 0;        // radians
  bool fitToArea = false;  // one copy over the whole face instead
  friend bool operator==(const TextureRef&, const TextureRef&) = default;
};

struct Finish {
  std::string material;  // id of a catalog material ("oak", "chrome", "glass"); empty: the face's own
  std::optional<Color> color;
  std::optional<TextureRef> texture;
  std::optional<double> roughness;     // 0 mirror .. 1 matt
  std::optional<double> metalness;     // 0..1
  std::optional<double> transmission;  // 0 opaque .. 1 clear glass

  bool empty() const { return *this == Finish{}; }
  friend bool operator==(const Finish&, const Finish&) = default;
};

inline Finish plain(Color color) {
  Finish finish;
  finish.color = color;
  return finish;
}

using SlotFinishes = std::map<std::string, Finish>;  // by the name of a model's material slot

}  // namespace idap
