// Pictures made by formulas of our own: wood, floors, stone, cloth and the like, which all tile; and
// "abstract" and "landscape", paintings to hang, which do not. The same recipe gives the same bytes on every
// run; a picture takes a few milliseconds to make.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "base/image8.h"
#include "geometry/vec.h"
#include "light/rgb.h"
#include "model/finish.h"

namespace idap {

struct TextureRecipe {
  std::string pattern;        // one of texturePatterns()
  int width = 512;            // pixels
  int height = 512;           // pixels
  Vec2 size{1, 1};            // m that one copy covers
  std::uint32_t seed = 1;     // another one: another board of the same wood
  std::vector<Color> colors;  // sRGB, what they mean depends on the pattern; usually from dark to light
  std::map<std::string, double> numbers;  // details of the pattern; missing ones take their defaults

  double number(const std::string& name, double fallback) const {
    const auto it = numbers.find(name);
    return it == numbers.end() ? fallback : it->second;
  }
};

struct ProceduralTexture {
  Image8 color;   // sRGB
  Image8 normal;  // tangent space, +Y up, linear; empty where the pattern has no relief
};

// Names that TextureRecipe::pattern may have.
std::vector<std::string> texturePatterns();

// Throws Error for an unknown pattern or a picture without pixels.
ProceduralTexture makeTexture(const TextureRecipe& recipe);

Rgb meanReflectance(const Image8& picture);  // linear
Bytes encodePpm(const Image8& picture);      // binary PPM (P6)

}  // namespace idap
