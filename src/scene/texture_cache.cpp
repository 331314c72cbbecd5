#include "scene/texture_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstdint>

#include "base/error.h"
#include "render/film/texture_file.h"

namespace idap {

namespace {

// The picture with the lightness of the mask in its alpha, on the finer of both grids.
render::TexturePtr masked(const render::TexturePtr& picture, const render::Texture& mask) {
  auto result = std::make_shared<render::Texture>();
  result->srgb = picture ? picture->srgb : true;
  result->hasAlpha = true;
  result->width = std::max(picture ? picture->width : 1, mask.width);
  result->height = std::max(picture ? picture->height : 1, mask.height);
  const auto texel = [&](const render::Texture& t, int x, int y) {
    const auto column = static_cast<std::size_t>(std::int64_t{x} * t.width / result->width);
    const auto row = static_cast<std::size_t>(std::int64_t{y} * t.height / result->height);
    return &t.rgba[4 * (row * static_cast<std::size_t>(t.width) + column)];
  };
  result->rgba.reserve(std::size_t{4} * static_cast<std::size_t>(result->width) *
                       static_cast<std::size_t>(result->height));
  constexpr std::uint8_t kWhite[4] = {255, 255, 255, 255};
  for (int y = 0; y < result->height; ++y) {
    for (int x = 0; x < result->width; ++x) {
      const std::uint8_t* color = picture ? texel(*picture, x, y) : kWhite;
      const std::uint8_t* m = texel(mask, x, y);
      // A mask with an alpha of its own says it there, another one by its lightness.
      const int opacity = mask.hasAlpha ? m[3] : (m[0] + m[1] + m[2]) / 3;
      result->rgba.insert(result->rgba.end(), color, color + 3);
      result->rgba.push_back(static_cast<std::uint8_t>(color[3] * opacity / 255));
    }
  }
  return result;
}

}  // namespace

void TextureCache::prepare(const std::vector<Request>& requests) {
  std::vector<Request> missing;
  for (const Request& r : requests) {
    if (!r.bytes && !r.opacity) continue;
    if (textures_.try_emplace(keyOf(r), Entry{r.bytes, r.opacity, nullptr}).second) missing.push_back(r);
  }
  std::vector<render::TexturePtr> decoded(missing.size());
  std::vector<std::string> errors(missing.size());
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    try {
      const Request& r = missing[i];
      if (r.bytes) decoded[i] = render::decodeTexture(*r.bytes, r.srgb);
      if (r.opacity) decoded[i] = masked(decoded[i], *render::decodeTexture(*r.opacity, false));
    } catch (const Error& e) {
      errors[i] = "texture \"" + missing[i].name + "\" is left out: " + e.what();
    }
  });
  for (std::size_t i = 0; i < missing.size(); ++i) {
    textures_[keyOf(missing[i])].texture = decoded[i];
    if (!errors[i].empty()) warnings_.push_back(errors[i]);
  }
}

render::TexturePtr TextureCache::get(const Request& request) {
  if (!request.bytes && !request.opacity) return nullptr;
  const Key key = keyOf(request);
  if (!textures_.contains(key)) prepare({request});
  return textures_[key].texture;
}

}  // namespace idap
