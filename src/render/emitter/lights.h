// All that shines in a compiled scene.
#pragma once

#include "render/emitter/daylight.h"
#include "render/emitter/local_lights.h"
#include "render/emitter/sun_patches.h"

namespace idap::render {

class Lights {
 public:
  explicit Lights(const CompiledScene& scene) : local_(scene), daylight_(scene), sunPatches_(scene) {}

  const LocalLights& local() const { return local_; }
  const Daylight& daylight() const { return daylight_; }
  const SunPatches& sunPatches() const { return sunPatches_; }
  // Whether there is something worth looking at: windows on a sunny day, the insides of lamps after dark.
  bool looks() const { return daylight_.looksOut() || sunPatches_.hasLamps(); }

 private:
  LocalLights local_;
  Daylight daylight_;
  SunPatches sunPatches_;
};

}  // namespace idap::render
