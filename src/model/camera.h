// A point of view, inside or outside, with its lens and its time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "geometry/vec.h"

namespace idap {

enum class Lens { Pinhole, Orthographic, Fisheye, Spherical };

struct Camera {
  std::string name;
  Vec3 eye{0, 0, 1.6};       // m, in the world (not relative to a level)
  double yaw = 0;            // radians, counter-clockwise from +y: the view runs along (-sin yaw, cos yaw)
  double pitch = 0;          // radians, positive looks down
  double fieldOfView = 1.1;  // radians, horizontal
  Lens lens = Lens::Pinhole;
  std::optional<std::int64_t> time;  // milliseconds since 1970-01-01T00:00Z; none: the home's
  friend bool operator==(const Camera&, const Camera&) = default;
};

inline Vec3 viewDirection(const Camera& c) {
  return {-std::sin(c.yaw) * std::cos(c.pitch), std::cos(c.yaw) * std::cos(c.pitch), -std::sin(c.pitch)};
}

}  // namespace idap
