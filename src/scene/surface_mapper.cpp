#include "scene/surface_mapper.h"

#include <algorithm>

namespace idap {

namespace {

constexpr float kWhite = 0.82f;  // reflectance of the whitest paint

float reflectance(float encoded) {
  const float linear = srgbToLinear(std::clamp(encoded, 0.0f, 1.0f));
  return linear * (1 - (1 - kWhite) * linear);  // whites come down, dark colours stay
}

Rgb linear(const Color& c) {
  return {srgbToLinear(std::clamp(c.r, 0.0f, 1.0f)), srgbToLinear(std::clamp(c.g, 0.0f, 1.0f)),
          srgbToLinear(std::clamp(c.b, 0.0f, 1.0f))};
}

// Weights of the surface of 1993 that look like the material.
render::ClassicSurface classicOf(const Material& m) {
  render::ClassicSurface c;
  const float polish = 1 - static_cast<float>(std::clamp(m.roughness, 0.0, 1.0));
  const auto metal = static_cast<float>(m.metalness), clear = static_cast<float>(m.transmission);
  c.transmission = clear * 0.9f;
  c.reflection = std::max(metal * polish * 0.9f, polish > 0.9f ? 0.08f : 0.0f);
  c.diffuse = 0.7f * (1 - clear) * (1 - c.reflection);
  c.ambient = 0.2f * (1 - clear) * (1 - c.reflection);
  c.specular = 0.5f * polish * polish;
  c.roughness = 4 + 200 * polish * polish * polish;
  c.ior = m.thin ? 1.0f : static_cast<float>(m.ior);
  return c;
}

}  // namespace

TextureCache::Request colorPicture(const Material& m) {
  TextureCache::Request request;
  if (m.texture) request.bytes = m.texture->bytes, request.name = m.texture->name;
  if (m.opacityMap) request.opacity = m.opacityMap->bytes, request.name += " " + m.opacityMap->name;
  return request;
}

render::Surface toSurface(const Material& m, TextureCache& textures) {
  render::Surface s;
  s.name = m.name;
  s.metalness = static_cast<float>(m.metalness);
  s.roughness = static_cast<float>(m.roughness);
  s.ior = static_cast<float>(m.ior);
  s.transmission = static_cast<float>(m.transmission);
  s.thin = m.thin;
  s.translucency = static_cast<float>(m.translucency);
  s.opacity = static_cast<float>(m.opacity);
  s.emission = toFloat(m.emission);
  // Metals and glass keep their tint; paint, wood and cloth are held below white.
  const bool diffuse = m.metalness < 0.5 && m.transmission < 0.5;
  s.baseColor =
      diffuse ? Rgb{reflectance(m.color.r), reflectance(m.color.g), reflectance(m.color.b)} : linear(m.color);
  s.baseColorMap = textures.get(colorPicture(m));
  if (m.texture) {
    if (m.texture->size.x > 0 && m.texture->size.y > 0) {
      s.uvScale = {static_cast<float>(1 / m.texture->size.x), static_cast<float>(1 / m.texture->size.y)};
      s.uvOffset = {static_cast<float>(m.texture->offset.x / m.texture->size.x),
                    static_cast<float>(m.texture->offset.y / m.texture->size.y)};
      s.uvRotation = static_cast<float>(m.texture->angle);
    }
  }
  if (m.normalMap) s.normalMap = textures.get({m.normalMap->bytes, m.normalMap->name, false, nullptr});
  s.classic = classicOf(m);
  return s;
}

Material SurfaceMapper::paint() {
  Material m;
  m.name = "paint";
  m.color = {1, 1, 1};
  m.roughness = 0.85;
  return m;
}

Material SurfaceMapper::flooring() {
  Material m;
  m.name = "floor";
  m.color = {0.72f, 0.70f, 0.67f};
  m.roughness = 0.5;
  return m;
}

std::optional<MaterialTexture> SurfaceMapper::texture(const TextureRef& ref) const {
  constexpr std::string_view kCatalog = "catalog:";
  MaterialTexture texture;
  if (ref.asset.starts_with(kCatalog)) {
    const Material* found = findMaterial(ref.asset.substr(kCatalog.size()));
    if (!found || !found->texture) return std::nullopt;
    texture = *found->texture;
  } else {
    const auto found = home_.assets->find(ref.asset);
    if (found == home_.assets->end() || !found->second) return std::nullopt;
    texture.bytes = found->second;
    texture.name = ref.asset;
  }
  texture.size = ref.size;
  texture.offset = ref.offset;
  texture.angle = ref.angle;
  return texture;
}

Material SurfaceMapper::finished(const Material& base, const Finish& finish,
                                 const std::optional<Box2>& area) const {
  Material m = base;
  if (!finish.material.empty()) {
    if (const Material* found = findMaterial(finish.material)) {
      m = *found;
      m.name = finish.material;
    }
  }
  if (finish.color) {
    const Color& c = *finish.color;
    if (finish.material.empty()) m.texture.reset(), m.normalMap.reset(), m.opacityMap.reset();
    // A pane takes on the colour to the degree that it is there at all.
    const auto share = static_cast<float>(1 - std::clamp(m.transmission, 0.0, 1.0));
    const bool pane = m.transmission > 0 && finish.material.empty() && !finish.transmission;
    m.color = pane ? Color{1 + (c.r - 1) * share, 1 + (c.g - 1) * share, 1 + (c.b - 1) * share} : c;
  }
  if (finish.texture) {
    if (auto picture = texture(*finish.texture)) {
      if (finish.texture->fitToArea && area && !area->empty()) {
        picture->size = area->max - area->min;
        picture->offset = -area->min;
        picture->angle = 0;
      }
      m.texture = std::move(picture);
      m.normalMap.reset();
      m.opacityMap.reset();
      if (!finish.color) m.color = {1, 1, 1};
    }
  }
  if (finish.roughness) m.roughness = *finish.roughness;
  if (finish.metalness) m.metalness = *finish.metalness;
  if (finish.transmission) m.transmission = *finish.transmission;
  return m;
}

}  // namespace idap
