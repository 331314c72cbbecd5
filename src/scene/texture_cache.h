// Decoded pictures, each once: the pointer of the encoded bytes identifies a picture. Without bytes but with
// an opacity the picture is white.
#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/bytes.h"
#include "render/scene.h"

namespace idap {

class TextureCache {
 public:
  struct Request {
    SharedBytes bytes;
    std::string name;  // for warnings
    bool srgb = true;
    SharedBytes opacity;  // a picture whose lightness goes into the alpha of this one
  };

  // Decodes all that are new, in parallel.
  void prepare(const std::vector<Request>& requests);
  // Null, with a warning the first time, when the picture cannot be read.
  render::TexturePtr get(const Request& request);

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Key = std::tuple<const Bytes*, bool, const Bytes*>;
  struct Entry {
    SharedBytes bytes, opacity;  // held, so that no other picture takes their place in memory
    render::TexturePtr texture;
  };
  static Key keyOf(const Request& r) { return {r.bytes.get(), r.srgb, r.opacity.get()}; }
  std::map<Key, Entry> textures_;
  std::vector<std::string> warnings_;
};

}  // namespace idap
