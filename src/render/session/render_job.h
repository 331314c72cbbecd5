// Renders a picture: fills a film from a compiled scene. One call, many threads.
#pragma once

#include <cstdint>
#include <memory>

#include "base/progress.h"
#include "render/accel/compiled_scene.h"
#include "render/film/film.h"
#include "render/film/pixel_region.h"
#include "render/integrator/camera_ray.h"

namespace idap::render {

class LightCache;

// Of the random numbers and of how paths use them. Pictures begun with another one cannot be gone on with.
inline constexpr int kSamplingVersion = 4;

enum class IntegratorKind { Path, Classic };

struct RenderSettings {
  int width = 640;
  int height = 480;
  int spp = 0;                    // samples a pixel should have; 0: until the time is up
  double timeLimitSeconds = 0.0;  // 0: none. Without any limit the render goes on until cancelled
  // > 0: a pixel is done when its standard error is under this share of its brightness (what is darker than a
  // tenth of the picture's mean counts as a tenth); the others go on, up to spp where that is given.
  float noise = 0.0f;
  int threads = 0;  // 0: all
  std::uint64_t seed = 0;
  IntegratorKind integrator = IntegratorKind::Path;
  float clampIndirect = 0.0f;  // see PathOptions
  // See fillCache(): quicker and nearly right. Not used where light groups are kept apart. Null: none.
  std::shared_ptr<const LightCache> cache{};
  std::shared_ptr<const LightCache> guide{};  // see PathOptions and fillGuide(). Null: none
  bool looks = true;                          // see PathOptions
  PixelFilter filter = PixelFilter::BlackmanHarris;
  bool perLightGroupLayers = false;
  bool transparentBackground = false;  // the sky lights the scene but is not seen behind it
  PixelRegion region{};                // the pixels that get samples; empty: all
};

struct RenderStats {
  double seconds = 0.0;
  std::uint64_t paths = 0;  // begun at the camera
  std::uint64_t rays = 0;   // nearest-hit and shadow rays; not counted by the classic integrator
  int spp = 0;              // the least that any pixel has
};

// Adds samples to the film, which must have the settings' size (RenderError otherwise), until every pixel has
// spp of them, the time is up, or progress is cancelled; never throws Cancelled. The film is valid at any
// end: each pixel has its own weight. A film that already has samples is carried on as if it had never
// stopped. Equal seeds give equal films on any number of threads as long as spp or noise is what ends the
// render.
RenderStats render(const CompiledScene& scene, const Camera& camera, const RenderSettings& settings,
                   Film& film, const Progress& progress = {});

}  // namespace idap::render
