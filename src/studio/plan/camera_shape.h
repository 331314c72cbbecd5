// How a point of view looks on a plane: a camera and the cone that it sees.
#pragma once

#include "editor/plane.h"
#include "model/camera.h"
#include "studio/plan/canvas.h"

namespace idap {

Box2 cameraBox(Plane plane, const Camera& camera);
void drawCamera(Canvas& canvas, Plane plane, const Camera& camera, bool strong);

}  // namespace idap
