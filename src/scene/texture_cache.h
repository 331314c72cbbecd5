// Decoded pictures, each once: the pointer of the encoded bytes identifies a picture.
#pragma once

#include <map>
#include <string>
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
  };

  // Decodes all that are new, in parallel.
  void prepare(const std::vector<Request>& requests);
  // Null, with a warning the first time, when the picture cannot be read.
  render::TexturePtr get(const Request& request);

  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Key = std::pair<const Bytes*, bool>;
  std::map<Key, std::pair<SharedBytes, render::TexturePtr>> textures_;
  std::vector<std::string> warnings_;
};

}  // namespace idap
