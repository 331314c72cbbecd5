#include "render/session/pilot.h"

#include <algorithm>

#include "render/film/exposure.h"

namespace idap::render {

namespace {

constexpr int kWidth = 64;
constexpr int kSamples = 8;
constexpr float kClampOverWhite = 12;

}  // namespace

float pilotExposure(const CompiledScene& scene, const Camera& camera, const RenderSettings& settings) {
  RenderSettings pilot = settings;
  pilot.width = kWidth;
  pilot.height = std::clamp(kWidth * settings.height / settings.width, 8, 4 * kWidth);
  pilot.spp = kSamples;
  pilot.timeLimitSeconds = 0;
  pilot.perLightGroupLayers = false;
  Film film(pilot.width, pilot.height);
  render(scene, camera, pilot, film);
  return autoExposure(film);
}

float clampFor(float ev100) { return kClampOverWhite / exposureMultiplier(ev100); }

}  // namespace idap::render
