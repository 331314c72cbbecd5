#include "formats/gltf/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/film/picture_file.h"

namespace idap {

namespace {

float unit(float v) { return std::isfinite(v) ? std::clamp(v, 0.0f, 1.0f) : 0.0f; }

// glTF reads roughness from green and metalness from blue, where a surface has roughness in red.
render::Texture roughnessPicture(const render::Texture& from) {
  render::Texture to = from;
  for (std::size_t i = 0; i + 3 < to.rgba.size(); i += 4) {
    to.rgba[i + 1] = to.rgba[i];
    to.rgba[i + 2] = 255;
    to.rgba[i + 3] = 255;
  }
  to.srgb = to.hasAlpha = false;
  return to;
}

}  // namespace

bool hasMaps(const render::Surface& s) { return s.baseColorMap || s.normalMap || s.roughnessMap; }

std::size_t GltfMaterials::indexOf(const render::Surface& surface, bool withUvs) {
  const bool maps = withUvs && hasMaps(surface);
  const auto [it, isNew] = known_.try_emplace({&surface, maps}, materials_.size());
  if (isNew) materials_.push_back(describe(surface, maps));
  return it->second;
}

GltfMaterials::Json GltfMaterials::describe(const render::Surface& s, bool maps) {
  Json pbr{
      {"baseColorFactor", {unit(s.baseColor.x), unit(s.baseColor.y), unit(s.baseColor.z), unit(s.opacity)}},
      {"metallicFactor", unit(s.metalness)},
      {"roughnessFactor", unit(s.roughness)}};
  if (maps && s.baseColorMap) pbr["baseColorTexture"] = texture(s.baseColorMap);
  if (maps && s.roughnessMap) pbr["metallicRoughnessTexture"] = texture(s.roughnessMap, Use::Roughness);
  Json m;
  // Other programs find materials by name and number those of one name as they please.
  m["name"] = fmt::format("{}{}{}", s.name, s.name.empty() ? "material " : " ", materials_.size() + 1);
  m["pbrMetallicRoughness"] = std::move(pbr);
  if (maps && s.normalMap) m["normalTexture"] = texture(s.normalMap);
  m["doubleSided"] = true;
  if (s.opacity < 1 || (maps && s.baseColorMap && s.baseColorMap->hasAlpha)) m["alphaMode"] = "BLEND";

  Json extensions = Json::object();
  const float strongest = maxComponent(s.emission);
  if (strongest > 0 && std::isfinite(strongest)) {
    m["emissiveFactor"] = {s.emission.x / strongest, s.emission.y / strongest, s.emission.z / strongest};
    extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", strongest}};
  }
  extensions["KHR_materials_ior"] = {{"ior", std::isfinite(s.ior) ? std::max(s.ior, 1.0f) : 1.5f}};
  if (s.transmission > 0) {
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", unit(s.transmission)}};
    if (!s.thin) extensions["KHR_materials_volume"] = {{"thicknessFactor", 0.01f}};
  }
  if (s.translucency > 0) {
    extensions["KHR_materials_diffuse_transmission"] = {
        {"diffuseTransmissionFactor", unit(s.translucency)},
        {"diffuseTransmissionColorFactor", {unit(s.baseColor.x), unit(s.baseColor.y), unit(s.baseColor.z)}}};
  }
  for (const auto& [name, value] : extensions.items()) extensions_.insert(name);
  m["extensions"] = std::move(extensions);
  return m;
}

GltfMaterials::Json GltfMaterials::texture(const render::TexturePtr& picture, Use use) {
  const auto [it, isNew] = knownTextures_.try_emplace({picture.get(), use}, textures_.size());
  if (isNew) {
    const Bytes png =
        use == Use::Roughness ? render::encodePng(roughnessPicture(*picture)) : render::encodePng(*picture);
    if (samplers_.empty()) {
      constexpr int kLinear = 9729, kLinearMipmapLinear = 9987, kRepeat = 10497;
      samplers_.push_back({{"magFilter", kLinear},
                           {"minFilter", kLinearMipmapLinear},
                           {"wrapS", kRepeat},
                           {"wrapT", kRepeat}});
    }
    images_.push_back({{"bufferView", buffer_.addView(png)}, {"mimeType", "image/png"}});
    textures_.push_back({{"sampler", 0}, {"source", images_.size() - 1}});
  }
  return {{"index", it->second}};
}

}  // namespace idap
