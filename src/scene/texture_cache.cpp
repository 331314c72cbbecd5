#include "scene/texture_cache.h"

#include <tbb/parallel_for.h>

#include "base/error.h"
#include "render/film/texture_file.h"

namespace idap {

void TextureCache::prepare(const std::vector<Request>& requests) {
  std::vector<Request> missing;
  for (const Request& r : requests) {
    if (!r.bytes) continue;
    if (textures_.try_emplace(Key{r.bytes.get(), r.srgb}, r.bytes, nullptr).second) missing.push_back(r);
  }
  std::vector<render::TexturePtr> decoded(missing.size());
  std::vector<std::string> errors(missing.size());
  tbb::parallel_for(std::size_t{0}, missing.size(), [&](std::size_t i) {
    try {
      decoded[i] = render::decodeTexture(*missing[i].bytes, missing[i].srgb);
    } catch (const Error& e) {
      errors[i] = "texture \"" + missing[i].name + "\" is left out: " + e.what();
    }
  });
  for (std::size_t i = 0; i < missing.size(); ++i) {
    textures_[{missing[i].bytes.get(), missing[i].srgb}].second = decoded[i];
    if (!errors[i].empty()) warnings_.push_back(errors[i]);
  }
}

render::TexturePtr TextureCache::get(const Request& request) {
  if (!request.bytes) return nullptr;
  const Key key{request.bytes.get(), request.srgb};
  if (!textures_.contains(key)) prepare({request});
  return textures_[key].second;
}

}  // namespace idap
