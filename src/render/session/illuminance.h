// Lux at a point: what a light meter laid there would read.
#pragma once

#include <cstdint>

#include "render/accel/compiled_scene.h"

namespace idap::render {

struct IlluminanceSettings {
  int samples = 1024;
  std::uint64_t seed = 0;
};

// The illuminance (lux, by colour) of a small plane at the point, facing along normal (unit), by path tracing
// from there, with all inter-reflections. The mean is unbiased; the plane itself is not in the scene.
Rgb illuminance(const CompiledScene& scene, Vec3f point, Vec3f normal,
                const IlluminanceSettings& settings = {});

}  // namespace idap::render
