// How somebody moves who looks at the home: turning the head, walking, circling around a point; and what they
// see under a point of the picture. World space, metres, radians.
#pragma once

#include "geometry/vec.h"
#include "model/camera.h"
#include "model/home.h"

namespace idap {

struct ViewRay {
  Vec3 origin, direction;  // unit
  Vec3 at(double t) const { return origin + direction * t; }
};

// Through a point of the picture (0..1 from its left, 0..1 from its top), width / height = aspect.
ViewRay rayThrough(const Camera& camera, double aspect, Vec2 point);

// Where the ray meets a plane through a point; none when it never does in front of the eye.
std::optional<Vec3> meet(const ViewRay& ray, Vec3 on, Vec3 normal);

Camera turned(Camera camera, double left, double down);
// right and ahead on level ground, up in the world.
Camera walked(Camera camera, double right, double ahead, double up);
// Around the point, which stays where it is in the picture.
Camera orbited(const Camera& camera, Vec3 about, double left, double down);
// To or from the point: 0.5 halves the distance.
Camera approached(Camera camera, Vec3 point, double factor);
// Sideways and upwards in the picture's own plane.
Camera shifted(Camera camera, double right, double up);

// Where a walker comes to who wants to go to `to`: walls stop them, doors and bare openings do not.
Vec3 keptOutOfWalls(const Home& home, Vec3 from, Vec3 to);

}  // namespace idap
