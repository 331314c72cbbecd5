// What the renderer is given: meshes, surfaces, instances, lights, sky and portals, as plain values. It knows
// nothing of homes. Metres, Z up, float, relative to a centre chosen by the maker so that coordinates stay
// small.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/transform.h"
#include "light/rgb.h"
#include "render/light_group.h"

namespace idap::render {

// A decoded picture, 8 bits a channel, RGBA, first row on top. Repeats in both directions.
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
  bool srgb = true;       // colour channels are sRGB-encoded (false for normal maps and the like)
  bool hasAlpha = false;  // some texel is not opaque
};
using TexturePtr = std::shared_ptr<const Texture>;

// The surface of 1993 (docs/classic.md): each term has its own weight.
struct ClassicSurface {
  float ambient = 0.2f;
  float diffuse = 0.7f;
  float brilliance = 1.0f;
  float specular = 0.0f;
  float roughness = 20.0f;  // the Phong exponent
  float reflection = 0.0f;
  float transmission = 0.0f;
  float ior = 1.0f;
};

// One physically based surface for everything: a dielectric or metallic microfacet layer over a diffuse base,
// with optional transmission. Two-sided.
struct Surface {
  std::string name;
  Rgb baseColor{0.8f, 0.8f, 0.8f};
  float metalness = 0.0f;
  float roughness = 0.5f;     // perceptual; GGX alpha = roughness^2; 0 is a perfect mirror
  float ior = 1.5f;           // of the dielectric layer; 1: no specular layer at all (pure Lambert)
  float transmission = 0.0f;  // share of the base that lets light through clearly, tinted by baseColor
  bool thin = true;  // transmission through a sheet (straight on) rather than into a solid (refracted)
  float translucency =
      0.0f;  // share of the diffuse base that leaves on the other side (lampshades, curtains, leaves)
  float opacity = 1.0f;     // 0: not there at all
  Rgb emission{};           // cd/m2, Lambertian, both sides
  TexturePtr baseColorMap;  // multiplies baseColor; its alpha multiplies opacity
  TexturePtr normalMap;     // tangent space, +Y up
  TexturePtr roughnessMap;  // red channel multiplies roughness
  Vec2f uvScale{1, 1};
  Vec2f uvOffset{};
  float uvRotation = 0.0f;  // radians
  ClassicSurface classic;
};

struct Instance {
  std::uint32_t mesh = 0;               // into Scene::meshes
  Transformf transform;                 // object -> world; may scale unevenly and mirror
  std::vector<std::uint32_t> surfaces;  // slot -> Scene::surfaces
  std::uint32_t objectId = 0;           // for the object-id layer; 0: none
  std::uint16_t lightGroup = 0;         // group of its emissive surfaces
  bool visibleToCamera = true;          // false: casts shadows and bounces light, but primary rays pass
};

// A lamp that is a point, or a sphere if radius > 0 (then rays can hit it).
struct Lamp {
  Vec3f position;
  float radius = 0.0f;      // m
  Rgb intensity{};          // cd, along the axis for a spot, in every direction otherwise
  Vec3f axis{0, 0, -1};     // unit
  float beamAngle = 0.0f;   // full angle in radians at half intensity; 0: shines all around
  bool lambertian = false;  // a point whose intensity falls with the cosine to the axis
  std::uint16_t lightGroup = 0;
};

struct Sun {
  Vec3f direction{0, 0, 1};        // unit, towards the sun
  Rgb illuminance{};               // lux on a surface that faces it; 0: no sun
  float angularRadius = 0.00465f;  // radians
};

// Radiance from infinitely far away as an equirectangular picture: row 0 is the zenith, the last row the
// nadir; column c looks along azimuth 2 pi (c + 0.5) / width measured from +X towards +Y. cd/m2.
struct Sky {
  int width = 0;
  int height = 0;
  std::vector<Rgb> radiance;  // empty: black
};

// A rectangle in a window or other gap through which the sky lights a room: corner + s*edgeU + t*edgeV.
struct Portal {
  Vec3f corner, edgeU, edgeV;
};

struct Scene {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<Surface> surfaces;
  std::vector<Instance> instances;
  std::vector<Lamp> lamps;
  Sun sun;
  Sky sky;
  std::vector<Portal> portals;
  std::vector<LightGroup> lightGroups{{"daylight"}};  // by index; 0 is the sky
  std::uint16_t sunGroup = 0;                         // of lightGroups; 0: the sun is counted to the sky
  Rgb classicBackground{0.6f, 0.75f, 0.95f};  // what the classic integrator shows where nothing is hit
};

enum class Projection { Perspective, Orthographic, Fisheye, Equirectangular };

struct Camera {
  Vec3f eye;
  Vec3f forward{0, 1, 0};  // unit
  Vec3f up{0, 0, 1};       // unit, square to forward
  Projection projection = Projection::Perspective;
  float horizontalFov = 1.1f;       // radians, across the picture's width
  float orthographicWidth = 10.0f;  // m, across the picture's width
  // Perspective only. The picture's middle looks this far to the right and up of forward, as tangents: with
  // forward level, what a shift lens does to keep vertical lines vertical.
  Vec2f shift{};
  // Perspective and orthographic: a lens of this radius (m) is sharp at focusDistance (m, along forward).
  float lensRadius = 0.0f;
  float focusDistance = 2.0f;
};

// The same view with its vertical lines vertical: the camera is levelled and its lens shifted by what it was
// tilted. As it was where the lens is not a perspective one or is tilted by more than 50 degrees.
Camera upright(const Camera& camera);

// The radius (m) of a photographer's lens with this f-number that sees the same field of view on film 36 mm
// wide.
float lensRadius(float horizontalFov, float fNumber);

}  // namespace idap::render
