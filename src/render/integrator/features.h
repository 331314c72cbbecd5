// What the eye sees at every pixel, without any light: reflectance, normal, distance and object of the first
// surface. Costs one ray a pixel; guides the enlarging of small pictures and tells what lies under the
// pointer.
#pragma once

#include <cstdint>
#include <vector>

#include "render/accel/compiled_scene.h"

namespace idap::render {

struct Features {
  int width = 0, height = 0;    // rows from the top
  std::vector<Rgb> albedo;      // of the first surface that is no clear glass and no mirror; 0: the sky; what
                                // shines is white, as in a film
  std::vector<Vec3f> normal;    // of that surface, towards the eye, unit; 0: the sky
  std::vector<float> depth;     // m along the ray to that surface; 0: the sky
  std::vector<float> distance;  // m to the first surface of any kind; 0: the sky
  std::vector<std::uint32_t> objectId;  // of the first surface of any kind
  std::vector<std::uint8_t> slot;       // its material slot, at most 255

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

// threads: 0: all.
Features features(const CompiledScene& scene, const Camera& camera, int width, int height, int threads = 0);

}  // namespace idap::render
