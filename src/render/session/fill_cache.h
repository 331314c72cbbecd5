// Fills a cache of light for one point of view, or for several of the same scene.
#pragma once

#include <memory>
#include <span>

#include "base/progress.h"
#include "render/cache/light_cache.h"
#include "render/session/render_job.h"

namespace idap::render {

// Traces that many paths, in passes of which each uses what those before have found. Equal settings give
// equal caches on any number of threads. Null where nothing was found or the settings ask for the classic
// integrator. Throws Cancelled.
std::shared_ptr<const LightCache> fillCache(const CompiledScene& scene, const Camera& camera,
                                            const RenderSettings& settings, int paths,
                                            const Progress& progress = {});
// The same for a walk: paths begin at all the cameras in turn.
std::shared_ptr<const LightCache> fillCache(const CompiledScene& scene, std::span<const Camera> cameras,
                                            const RenderSettings& settings, int paths,
                                            const Progress& progress = {});

// One for RenderSettings::guide, from as many paths as a picture of that size is worth.
std::shared_ptr<const LightCache> fillGuide(const CompiledScene& scene, const Camera& camera,
                                            const RenderSettings& settings, const Progress& progress = {});

}  // namespace idap::render
