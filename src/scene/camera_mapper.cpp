#include <algorithm>
#include <array>

#include "scene/scene_builder.h"
#include "scene/wall_solid.h"

namespace idap {

render::Camera toRenderCamera(const Camera& camera, const BuiltScene& built, double aspect) {
  render::Camera c;
  c.eye = toFloat(camera.eye - built.centre);
  c.forward = toFloat(viewDirection(camera));
  const double sy = std::sin(camera.yaw), cy = std::cos(camera.yaw);
  const double sp = std::sin(camera.pitch), cp = std::cos(camera.pitch);
  c.up = toFloat(Vec3{-sy * sp, cy * sp, cp});
  c.horizontalFov = static_cast<float>(camera.fieldOfView);
  switch (camera.lens) {
    case Lens::Pinhole:
      c.projection = render::Projection::Perspective;
      c.horizontalFov = std::clamp(c.horizontalFov, 0.01f, 3.1f);
      break;
    case Lens::Orthographic: {
      // As wide as the perspective view is at the height of the floor, or at a room's depth for level views.
      c.projection = render::Projection::Orthographic;
      const double distance = sp > 0.2 ? std::max(camera.eye.z, 0.5) / sp : 10;
      c.orthographicWidth =
          static_cast<float>(2 * std::tan(std::clamp(camera.fieldOfView, 0.01, 3.0) / 2) * distance);
      break;
    }
    case Lens::Fisheye:
      c.projection = render::Projection::Fisheye;
      break;
    case Lens::Spherical:
      c.projection = render::Projection::Equirectangular;
      break;
  }
  (void)aspect;
  return c;
}

Camera topCamera(const Home& home, double aspect) {
  Box3 box;
  const std::vector<Storey> storeys = shownStoreys(home, false);
  for (const auto& [id, wall] : home.walls) {
    const std::size_t storey = storeyOf(storeys, wall->level);
    if (storey == storeys.size()) continue;
    for (const Vec2& p : wallCentreLine(*wall)) {
      box.add(Vec3{p.x, p.y, storeys[storey].elevation});
      box.add(Vec3{p.x, p.y, storeys[storey].elevation + std::max(wall->heightAtStart, wall->heightAtEnd)});
    }
  }
  for (const auto& [id, room] : home.rooms) {
    const std::size_t storey = storeyOf(storeys, room->level);
    if (storey == storeys.size() || !room->floorVisible) continue;
    for (const Vec2& p : room->points) box.add(Vec3{p.x, p.y, storeys[storey].elevation});
  }
  if (box.empty()) {
    for (const auto& [id, piece] : home.furniture) {
      if (!isShownOn(home, storeys, *piece)) continue;
      const double z = elevationOf(home, piece->level) + piece->position.z;
      for (const Vec2& p : footprint(*piece))
        box.add(Vec3{p.x, p.y, z}), box.add(Vec3{p.x, p.y, z + piece->size.z});
    }
  }
  if (box.empty() || !isFinite(box.min) || !isFinite(box.max)) {
    box.add(Vec3{-3, -3, 0});
    box.add(Vec3{3, 3, 2.5});
  }
  Camera camera;
  camera.name = "top";
  camera.yaw = 0;
  camera.pitch = 65 * kPi / 180;
  camera.fieldOfView = 0.8;
  const Vec3 forward = viewDirection(camera), right{1, 0, 0}, up = cross(right, forward);
  const double tanX = std::tan(camera.fieldOfView / 2), tanY = tanX / std::max(aspect, 0.05);
  // Back along the view until all corners are in the picture.
  const Vec3 middle = box.centre();
  double distance = 0.5;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p = Vec3{corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                        corner & 4 ? box.max.z : box.min.z} -
                   middle;
    const double depth = dot(p, forward);
    distance =
        std::max({distance, std::abs(dot(p, right)) / tanX - depth, std::abs(dot(p, up)) / tanY - depth});
  }
  camera.eye = middle - forward * (distance * 1.04);
  return camera;
}

}  // namespace idap
