// The three planes a home is drawn on, and how the world is projected onto them. Metres.
#pragma once

#include <array>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/vec.h"
#include "model/piece.h"

namespace idap {

// XY is the plan, from above. XZ looks along +y (from the front), YZ along -x (from the right hand side), so
// that in each the first axis runs right and the second up.
enum class Plane { XY, XZ, YZ };
inline constexpr std::array<Plane, 3> kPlanes{Plane::XY, Plane::XZ, Plane::YZ};

constexpr Vec2 project(Plane plane, Vec3 p) {
  switch (plane) {
    case Plane::XZ:
      return {p.x, p.z};
    case Plane::YZ:
      return {p.y, p.z};
    default:
      return {p.x, p.y};
  }
}

// Larger is nearer to the eye.
constexpr double nearness(Plane plane, Vec3 p) {
  return plane == Plane::XY ? p.z : plane == Plane::XZ ? -p.y : p.x;
}

// The vector of the world that a vector of the plane stands for; nothing along the line of sight.
constexpr Vec3 inWorld(Plane plane, Vec2 v) {
  switch (plane) {
    case Plane::XZ:
      return {v.x, 0, v.y};
    case Plane::YZ:
      return {0, v.x, v.y};
    default:
      return {v.x, v.y, 0};
  }
}

// The outline around points, counter-clockwise, without points that lie on its sides.
Polygon convexHull(std::vector<Vec2> points);

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b);
// To the border of a ring (closed) or to a line through points.
double distanceToPath(const std::vector<Vec2>& points, bool closed, Vec2 p);

// The outline of a piece's box on a plane, counter-clockwise, convex; with all three rotations. elevation is
// that of the piece's level.
Polygon outline(Plane plane, const Piece& piece, double elevation);

}  // namespace idap
