// What a face is made of, in the catalog's terms: what the scene builder turns into a renderer's surface.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/bytes.h"
#include "model/finish.h"

namespace idap {

// A picture laid over a face, with its encoded bytes (PNG, JPEG, …). Equal bytes are shared, so that the
// pointer identifies the picture.
struct MaterialTexture {
  SharedBytes bytes;
  std::string name;  // file name, for messages
  Vec2 size{0, 0};   // m one copy covers; 0: the mesh's texture coordinates are used as they are
  Vec2 offset{};
  double angle = 0;
};

struct Material {
  std::string name;
  Color color{0.8f, 0.8f, 0.8f};
  double metalness = 0;
  double roughness = 0.5;
  double ior = 1.5;
  double transmission = 0;  // clear
  bool thin = true;         // a sheet (window glass) rather than a solid (a glass ball)
  double translucency = 0;  // diffuse light that leaves on the other side (lampshades, curtains, leaves)
  double opacity = 1;
  Vec3 emission{};                         // cd/m2, linear RGB
  std::optional<MaterialTexture> texture;  // multiplies color
  std::optional<MaterialTexture> normalMap;
  // Its lightness multiplies opacity; placed as texture is.
  std::optional<MaterialTexture> opacityMap;
};

// The catalog's named materials, in the order they are shown ("oak", "walnut", "chrome", "glass",
// "white-lacquer", …). Null when unknown.
const Material* findMaterial(const std::string& id);
std::vector<std::string> materialIds();
std::string materialName(const std::string& id, std::string_view language);  // falls back to English
// "wood", "lacquer", "paint", "metal", "glass", "fabric", "floor", "stone", "ceramic", "plastic", "plant",
// "light", "art".
std::string materialGroup(const std::string& id);

}  // namespace idap
