// A quick look at a scene before the real work: how bright its picture will be.
#pragma once

#include "render/accel/compiled_scene.h"
#include "render/film/film.h"
#include "render/session/render_job.h"

namespace idap::render {

// The auto exposure (EV100) of a picture about 64 pixels wide, made with a few samples.
float pilotExposure(const CompiledScene& scene, const Camera& camera, const RenderSettings& settings);

// RenderSettings::clampIndirect for pictures: what is this many times brighter than the pilot's white point
// is a speck rather than light. Loses little light and most of the specks.
float clampFor(float ev100);

}  // namespace idap::render
