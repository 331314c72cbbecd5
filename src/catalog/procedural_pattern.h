// What the pattern makers share: a canvas of colours and heights, and ramps of colours.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "catalog/procedural_texture.h"

namespace idap::pattern {

// A colour between the ramp's colours, 0 the first and 1 the last, mixed in sRGB so that steps look even.
class Ramp {
 public:
  explicit Ramp(const std::vector<Color>& colors);
  const std::array<std::uint8_t, 3>& operator()(float tone) const {
    const float t = tone < 0 ? 0 : tone > 1 ? 1 : tone;
    return steps_[static_cast<std::size_t>(t * 511.0f + 0.5f)];
  }

 private:
  std::array<std::array<std::uint8_t, 3>, 512> steps_;
};

struct Texel {
  std::array<std::uint8_t, 3> color;
  float height = 0;  // m, for the normal map
};

// Calls at(u, v) for every pixel, u to the right and v up, in tiles, several rows at a time on several
// threads; makes a normal map of the heights when relief is set.
ProceduralTexture paint(const TextureRecipe& recipe, bool relief,
                        const std::function<Texel(float, float)>& at);

// The recipe's colours, or these where it gives none.
std::vector<Color> colorsOr(const TextureRecipe& recipe, std::vector<Color> fallback);

using Maker = ProceduralTexture (*)(const TextureRecipe&);

ProceduralTexture wood(const TextureRecipe&);         // a veneer; grain runs along u
ProceduralTexture planks(const TextureRecipe&);       // boards along u, staggered
ProceduralTexture herringbone(const TextureRecipe&);  // blocks at 45 degrees
ProceduralTexture marble(const TextureRecipe&);
ProceduralTexture granite(const TextureRecipe&);
ProceduralTexture terrazzo(const TextureRecipe&);
ProceduralTexture concrete(const TextureRecipe&);
ProceduralTexture tiles(const TextureRecipe&);
ProceduralTexture brick(const TextureRecipe&);
ProceduralTexture cork(const TextureRecipe&);
ProceduralTexture weave(const TextureRecipe&);
ProceduralTexture carpet(const TextureRecipe&);
ProceduralTexture leather(const TextureRecipe&);
ProceduralTexture rattan(const TextureRecipe&);
ProceduralTexture brushed(const TextureRecipe&);
// Pictures to hang, which do not repeat.
ProceduralTexture abstractArt(const TextureRecipe&);
ProceduralTexture landscape(const TextureRecipe&);

}  // namespace idap::pattern
