// From what a face is made of, in the model's and the catalog's terms, to the renderer's surface.
#pragma once

#include <optional>
#include <string>

#include "catalog/material.h"
#include "model/home.h"
#include "scene/texture_cache.h"

namespace idap {

// White paint reflects about 82 %: a white of 1 would never lose its light.
render::Surface toSurface(const Material& material, TextureCache& textures);
// The picture of its base colour, which carries its opacity too; without bytes and opacity: none.
TextureCache::Request colorPicture(const Material& material);

class SurfaceMapper {
 public:
  SurfaceMapper(const Home& home, TextureCache& textures) : home_(home), textures_(textures) {}

  // The base with what the finish changes. area: the face that a picture with fitToArea is laid over.
  Material finished(const Material& base, const Finish& finish, const std::optional<Box2>& area = {}) const;

  // The picture that a reference names: among the home's assets, or "catalog:ID" a material of the catalog.
  std::optional<MaterialTexture> texture(const TextureRef& ref) const;

  render::Surface surface(const Material& base, const Finish& finish, const std::optional<Box2>& area = {}) {
    return toSurface(finished(base, finish, area), textures_);
  }
  TextureCache& textures() { return textures_; }

  // What faces without a finish are made of.
  static Material paint();
  static Material flooring();

 private:
  const Home& home_;
  TextureCache& textures_;
};

}  // namespace idap
