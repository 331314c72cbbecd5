// Focusing as a camera does: on what is in the middle of the picture.
#pragma once

#include "render/accel/compiled_scene.h"

namespace idap::render {

// How far along forward the first surface in the picture's middle is, m; 10 where there is only sky.
float depthInMiddle(const CompiledScene& scene, const Camera& camera);

// The camera with a lens of this f-number, sharp at focusDistance (m, along forward) or, where that is 0, in
// the middle of the picture.
Camera withAperture(const CompiledScene& scene, Camera camera, float fNumber, float focusDistance = 0);

}  // namespace idap::render
