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
  std::vector<Sampler> samplers;
  std::vector<Rgb> lux;
  for (int i = 0; i < samples;) {
    samplers.clear();
    for (; i < samples && samplers.size() < PathTracer::kBatch; ++i)
      samplers.emplace_back(0, 0, static_cast<std::uint32_t>(i), log2Samples, settings.seed);
    lux.resize(samplers.size());
    tracer.illuminance(point, normal, samplers, lux);
    for (const Rgb e : lux)
      if (std::isfinite(e.x + e.y + e.z)) sum += toDouble(e);
  }
  return toFloat(sum / static_cast<double>(samples));
}

}  // namespace idap::render
