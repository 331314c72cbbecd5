// A Surface made ready for shading: plain numbers, texture lookups without ownership.
#pragma once

#include <array>
#include <cstdint>

#include "render/scene.h"

namespace idap::render {

// Below this GGX alpha a surface counts as perfectly smooth: its lobe is a delta function.
inline constexpr float kSmoothAlpha = 1.6e-3f;

struct SurfaceData {
  Rgb baseColor;
  float metalness = 0.0f;
  float roughness = 0.0f;
  float ior = 1.5f;
  float f0 = 0.04f;  // Schlick's reflectance at normal incidence, of one interface
  float f90 = 1.0f;  // ... at grazing incidence; 0 with ior 1
  float transmission = 0.0f;
  float translucency = 0.0f;
  float opacity = 1.0f;
  bool thin = true;
  bool emits = false;
  bool opaqueToShadows = true;  // no ray can go straight through it
  bool clearSheet = false;      // lets light by straight or mirrors it, and does nothing else with it
  bool hasMaps = false;
  bool mayPass = false;  // opacity (or its map) lets some rays by
  Rgb emission;
  const Texture* baseColorMap = nullptr;
  const Texture* normalMap = nullptr;
  const Texture* roughnessMap = nullptr;
  Vec2f uvX, uvY, uvOffset;  // uv -> map coordinates: uvX * u + uvY * v + uvOffset

  Vec2f mapUv(Vec2f uv) const { return uvX * uv.x + uvY * uv.y + uvOffset; }
};

SurfaceData compileSurface(const Surface& surface);

// What the maps give at one point of a surface.
struct SurfaceValues {
  Rgb baseColor;
  float roughness = 0.0f;
  float opacity = 1.0f;
};
SurfaceValues valuesAt(const SurfaceData& surface, Vec2f uv);

// Colour (linear) and alpha of a texture at map coordinates (v up), bilinear, repeating.
struct Texel {
  Rgb color;
  float alpha = 1.0f;
};
Texel lookUp(const Texture& texture, Vec2f uv);

// The share of light of each colour that goes straight through the surface, cosine being that between the ray
// and the surface's normal: gaps left by opacity plus clear transmission through a thin sheet.
Rgb straightTransmittance(const SurfaceData& surface, const SurfaceValues& values, float cosine);

}  // namespace idap::render
