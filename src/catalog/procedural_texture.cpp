#include "catalog/procedural_texture.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>

#include "base/error.h"
#include "catalog/procedural_pattern.h"

namespace idap {

namespace pattern {

namespace {

struct Entry {
  const char* name;
  Maker make;
};

constexpr std::array kMakers{
    Entry{"wood", wood},
    Entry{"planks", planks},
    Entry{"herringbone", herringbone},
    Entry{"marble", marble},
    Entry{"granite", granite},
    Entry{"terrazzo", terrazzo},
    Entry{"concrete", concrete},
    Entry{"tiles", tiles},
    Entry{"brick", brick},
    Entry{"cork", cork},
    Entry{"weave", weave},
    Entry{"carpet", carpet},
    Entry{"leather", leather},
    Entry{"rattan", rattan},
    Entry{"brushed", brushed},
    Entry{"abstract", abstractArt},
    Entry{"landscape", landscape},
};

std::uint8_t toByte(float v) { return static_cast<std::uint8_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f); }

Image8 normalsOf(const std::vector<float>& heights, int width, int height, Vec2 size) {
  Image8 normals(width, height);
  const float perU = static_cast<float>(width / (2 * size.x)),
              perV = static_cast<float>(height / (2 * size.y));
  const auto at = [&](int x, int y) {
    return heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)];
  };
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 32), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      const int above = y == 0 ? height - 1 : y - 1, below = y + 1 == height ? 0 : y + 1;
      for (int x = 0; x < width; ++x) {
        const int left = x == 0 ? width - 1 : x - 1, right = x + 1 == width ? 0 : x + 1;
        const float dx = (at(right, y) - at(left, y)) * perU;
        const float dy = (at(x, above) - at(x, below)) * perV;
        const float scale = 1.0f / std::sqrt(dx * dx + dy * dy + 1.0f);
        std::uint8_t* const out = normals.pixel(x, y);
        out[0] = toByte(0.5f - 0.5f * dx * scale);
        out[1] = toByte(0.5f - 0.5f * dy * scale);
        out[2] = toByte(0.5f + 0.5f * scale);
      }
    }
  });
  return normals;
}

}  // namespace

Ramp::Ramp(const std::vector<Color>& colors) {
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const float t = static_cast<float>(i) / 511.0f * static_cast<float>(colors.size() - 1);
    const std::size_t from = std::min(static_cast<std::size_t>(t), colors.size() - 1);
    const std::size_t to = std::min(from + 1, colors.size() - 1);
    const float f = t - static_cast<float>(from);
    const Color a = colors[from], b = colors[to];
    steps_[i] = {toByte(a.r + f * (b.r - a.r)), toByte(a.g + f * (b.g - a.g)), toByte(a.b + f * (b.b - a.b))};
  }
}

ProceduralTexture paint(const TextureRecipe& recipe, bool relief,
                        const std::function<Texel(float, float)>& at) {
  ProceduralTexture result;
  const int width = recipe.width, height = recipe.height;
  result.color = Image8(width, height);
  std::vector<float> heights;
  if (relief) heights.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 16), [&](const tbb::blocked_range<int>& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y) {
      const float v = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      std::uint8_t* out = result.color.pixel(0, y);
      for (int x = 0; x < width; ++x, out += 3) {
        const Texel texel = at((static_cast<float>(x) + 0.5f) / static_cast<float>(width), v);
        std::copy(texel.color.begin(), texel.color.end(), out);
        if (relief)
          heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)] = texel.height;
      }
    }
  });
  if (relief) result.normal = normalsOf(heights, width, height, recipe.size);
  return result;
}

std::vector<Color> colorsOr(const TextureRecipe& recipe, std::vector<Color> fallback) {
  return recipe.colors.empty() ? std::move(fallback) : recipe.colors;
}

}  // namespace pattern

std::vector<std::string> texturePatterns() {
  std::vector<std::string> names;
  for (const auto& entry : pattern::kMakers) names.emplace_back(entry.name);
  return names;
}

ProceduralTexture makeTexture(const TextureRecipe& recipe) {
  if (recipe.width < 2 || recipe.height < 2 || recipe.width > 8192 || recipe.height > 8192 ||
      !(recipe.size.x > 0) || !(recipe.size.y > 0))
    throw Error("texture " + recipe.pattern + ": size out of range");
  for (const auto& entry : pattern::kMakers)
    if (recipe.pattern == entry.name) return entry.make(recipe);
  throw Error("unknown texture pattern: " + recipe.pattern);
}

Rgb meanReflectance(const Image8& picture) {
  std::array<float, 256> linear;
  for (int i = 0; i < 256; ++i)
    linear[static_cast<std::size_t>(i)] = srgbToLinear(static_cast<float>(i) / 255.0f);
  Vec3 sum;
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
    sum += Vec3{linear[picture.rgb[i]], linear[picture.rgb[i + 1]], linear[picture.rgb[i + 2]]};
  const std::size_t pixels = picture.rgb.size() / 3;
  return pixels ? toFloat(sum / static_cast<double>(pixels)) : Rgb{};
}

Bytes encodePpm(const Image8& picture) {
  const std::string header =
      "P6\n" + std::to_string(picture.width) + " " + std::to_string(picture.height) + "\n255\n";
  Bytes bytes(header.size() + picture.rgb.size());
  std::memcpy(bytes.data(), header.data(), header.size());
  if (!picture.rgb.empty()) std::memcpy(bytes.data() + header.size(), picture.rgb.data(), picture.rgb.size());
  return bytes;
}

}  // namespace idap
