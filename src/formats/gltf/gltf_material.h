// Surfaces as materials of glTF 2.0, with their pictures.
#pragma once

#include <map>
#include <set>
#include <string>

#include "formats/gltf/glb_buffer.h"
#include "render/scene.h"

namespace idap {

bool hasMaps(const render::Surface& surface);

class GltfMaterials {
 public:
  using Json = nlohmann::ordered_json;
  explicit GltfMaterials(GlbBuffer& buffer) : buffer_(buffer) {}

  // withUvs: the mesh has texture coordinates; without them a surface's maps are left out. The surface must
  // outlive this.
  std::size_t indexOf(const render::Surface& surface, bool withUvs);

  const Json& materials() const { return materials_; }
  const Json& textures() const { return textures_; }
  const Json& images() const { return images_; }
  const Json& samplers() const { return samplers_; }
  const std::set<std::string>& extensions() const { return extensions_; }

 private:
  enum class Use { Plain, Roughness };
  Json describe(const render::Surface& surface, bool maps);
  Json texture(const render::TexturePtr& picture, Use use = Use::Plain);

  GlbBuffer& buffer_;
  std::map<std::pair<const render::Surface*, bool>, std::size_t> known_;
  std::map<std::pair<const render::Texture*, Use>, std::size_t> knownTextures_;
  Json materials_ = Json::array(), textures_ = Json::array(), images_ = Json::array(),
       samplers_ = Json::array();
  std::set<std::string> extensions_;
};

}  // namespace idap
