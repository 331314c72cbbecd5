#include "editor/view/camera_motion.h"

#include <algorithm>
#include <cmath>

#include "model/wall_path.h"

namespace idap {

namespace {

constexpr double kSteepest = 89.5 * kPi / 180;
constexpr double kBody = 0.2;       // m, half a walker's width
constexpr double kStepOver = 0.25;  // m: lower walls and sills do not stop anybody
constexpr double kNearest = 0.05;   // m that an approach leaves

Vec3 rightOf(const Camera& c) { return {std::cos(c.yaw), std::sin(c.yaw), 0}; }
Vec3 upOf(const Camera& c) { return cross(rightOf(c), viewDirection(c)); }

// True where the walker goes through a door or a bare opening of the wall.
bool inDoorway(const Home& home, WallId wall, Vec2 at) {
  for (const auto& [id, opening] : home.openings) {
    if (opening->wall != wall || opening->kind == OpeningKind::Window || opening->position.z > kStepOver)
      continue;
    const Vec2 off = rotated(at - Vec2{opening->position.x, opening->position.y}, -opening->angle);
    if (std::abs(off.x) < opening->size.x / 2 - 0.5 * kBody) return true;
  }
  return false;
}

}  // namespace

ViewRay rayThrough(const Camera& camera, double aspect, Vec2 point) {
  const double half = std::tan(std::clamp(camera.fieldOfView, 0.01, 3.1) / 2);
  const Vec3 d = viewDirection(camera) + rightOf(camera) * ((2 * point.x - 1) * half) +
                 upOf(camera) * ((1 - 2 * point.y) * half / std::max(aspect, 1e-3));
  return {camera.eye, normalized(d)};
}

std::optional<Vec3> meet(const ViewRay& ray, Vec3 on, Vec3 normal) {
  const double along = dot(ray.direction, normal);
  if (std::abs(along) < 1e-6) return std::nullopt;
  const double t = dot(on - ray.origin, normal) / along;
  if (!(t > 1e-6) || t > 1e4) return std::nullopt;
  return ray.at(t);
}

Camera turned(Camera camera, double left, double down) {
  camera.yaw = std::remainder(camera.yaw + left, 2 * kPi);
  camera.pitch = std::clamp(camera.pitch + down, -kSteepest, kSteepest);
  return camera;
}

Camera walked(Camera camera, double right, double ahead, double up) {
  camera.eye +=
      rightOf(camera) * right + Vec3{-std::sin(camera.yaw), std::cos(camera.yaw), 0} * ahead + Vec3{0, 0, up};
  return camera;
}

Camera orbited(const Camera& camera, Vec3 about, double left, double down) {
  const Camera next = turned(camera, left, down);
  // The point keeps its place in the eye's own axes.
  const Vec3 off = about - camera.eye;
  const Vec3 own{dot(off, rightOf(camera)), dot(off, upOf(camera)), dot(off, viewDirection(camera))};
  Camera result = next;
  result.eye = about - (rightOf(next) * own.x + upOf(next) * own.y + viewDirection(next) * own.z);
  return result;
}

Camera approached(Camera camera, Vec3 point, double factor) {
  const Vec3 off = camera.eye - point;
  if (length(off) * factor > kNearest) camera.eye = point + off * factor;
  return camera;
}

Camera shifted(Camera camera, double right, double up) {
  camera.eye += rightOf(camera) * right + upOf(camera) * up;
  return camera;
}

Vec3 keptOutOfWalls(const Home& home, Vec3 from, Vec3 to) {
  Vec2 at{to.x, to.y};
  const Vec2 before{from.x, from.y};
  for (int pass = 0; pass < 3; ++pass) {
    for (const auto& [id, wall] : home.walls) {
      const double floor = elevationOf(home, wall->level);
      const double top = floor + std::max(wall->heightAtStart, wall->heightAtEnd);
      if (to.z < floor || to.z > top + 0.1 || top - floor < kStepOver) continue;
      const WallPath path(*wall);
      const double s = path.nearest(at);
      const Vec2 line = path.point(s), normal = perpendicular(path.direction(s));
      const double least = wall->thickness / 2 + kBody;
      if (length(at - line) >= least || inDoorway(home, id, at)) continue;
      const Vec2 near = path.point(path.nearest(before));
      const double side = dot(before - near, normal) >= 0 ? 1 : -1;
      const double away = dot(at - line, normal) * side;
      at += normal * (side * (least - away));
    }
  }
  // A jump through a thin wall is none.
  for (const auto& [id, wall] : home.walls) {
    const double floor = elevationOf(home, wall->level);
    if (to.z < floor || to.z > floor + std::max(wall->heightAtStart, wall->heightAtEnd)) continue;
    const Vec2 d = wall->end - wall->start, e = at - before;
    const double c = cross(e, d);
    if (wall->arcExtent != 0 || std::abs(c) < 1e-12) continue;
    const double t = cross(wall->start - before, d) / c, u = cross(wall->start - before, e) / c;
    if (t > 0 && t < 1 && u >= 0 && u <= 1 && !inDoorway(home, id, before + e * t)) return from;
  }
  return {at.x, at.y, to.z};
}

}  // namespace idap
