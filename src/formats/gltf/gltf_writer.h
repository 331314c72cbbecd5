// Writes a scene as binary glTF 2.0 (.glb): meshes, PBR materials, cameras, punctual lights. Metres; glTF is
// Y up, so everything hangs below one node that turns it. Lights are in candela and lux, emission in cd/m2.
// Extensions: KHR_lights_punctual, KHR_materials_emissive_strength, _ior, _transmission, _volume,
// _diffuse_transmission. Source: Khronos Group, "glTF 2.0 Specification" (2021) and its extension registry.
#pragma once

#include <span>
#include <string>

#include "base/bytes.h"
#include "render/scene.h"

namespace idap {

struct GltfCamera {
  std::string name;
  render::Camera camera;  // lenses that glTF has not (fisheye, equirectangular) are left out
  double aspect = 1.5;    // width / height of its picture
};

// origin: the world position (m) of the scene's (0, 0, 0). What glTF has no words for is left out: the sky,
// lamps' radii (kept as "radius" among the light's extras), the surface of 1993; a spot's soft edge becomes a
// cone. Throws Error where the file would pass the 4 GiB that .glb allows.
Bytes writeGlb(const render::Scene& scene, std::span<const GltfCamera> cameras, Vec3 origin = {});

}  // namespace idap
