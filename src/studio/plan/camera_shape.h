// How a point of view looks on a plane: a camera and the cone that it sees.
#pragma once

#include "editor/plane.h"
#include "model/camera.h"
#include "studio/plan/canvas.h"

namespace idap {

inline constexpr double kCameraReach = 0.9;  // m, of the cone

Box2 cameraBox(Plane plane, const Camera& camera);
void drawCamera(Canvas& canvas, Plane plane, const Camera& camera, bool strong);

}  // namespace idap
