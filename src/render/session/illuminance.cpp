#include "render/session/illuminance.h"

#include <algorithm>
#include <bit>

#include "render/integrator/path.h"

namespace idap::render {

Rgb illuminance(const CompiledScene& scene, Vec3f point, Vec3f normal, const IlluminanceSettings& settings) {
  const PathTracer tracer(scene);
  const int samples = std::max(settings.samples, 1);
  const int log2Samples = std::min(16, static_cast<int>(std::bit_width(static_cast<unsigned>(samples - 1))));
  Vec3 sum{};
  for (int i = 0; i < samples; ++i) {
    Sampler sampler(0, 0, static_cast<std::uint32_t>(i), log2Samples, settings.seed);
    const Rgb e = tracer.illuminance(point, normal, sampler);
    if (std::isfinite(e.x + e.y + e.z)) sum += toDouble(e);
  }
  return toFloat(sum / static_cast<double>(samples));
}

}  // namespace idap::render
