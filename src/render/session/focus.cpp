#include "render/session/focus.h"

#include <algorithm>

#include "render/integrator/camera_ray.h"

namespace idap::render {

namespace {
constexpr float kSkyDistance = 10, kNearest = 0.05f;  // m
}

float depthInMiddle(const CompiledScene& scene, const Camera& camera) {
  const std::optional<Ray> ray = CameraRays(camera, 2, 2).at({1, 1});
  Hit hit;
  if (!ray || !scene.intersect(*ray, hit, kSeenByCamera)) return kSkyDistance;
  return std::max(hit.t * dot(ray->direction, camera.forward), kNearest);
}

Camera withAperture(const CompiledScene& scene, Camera camera, float fNumber, float focusDistance) {
  camera.lensRadius = lensRadius(camera.horizontalFov, fNumber);
  camera.focusDistance = focusDistance > 0 ? focusDistance : depthInMiddle(scene, camera);
  return camera;
}

}  // namespace idap::render
