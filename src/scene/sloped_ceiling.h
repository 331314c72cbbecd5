// A ceiling under sloped walls: the roof that is spanned over the heights of a room's corners. Metres.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/polygon.h"

namespace idap {

struct Mesh3 {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise seen from above
};

// Points of breaks within 0.3 m of an edge become corners too (where a ridge ends in a gable). Among the
// triangulations of the outline the one is taken that lies highest: ridges, hips and plain slopes come out as
// they are built; valleys do not.
Mesh3 slopedCeiling(const Polygon& outline, const std::vector<Vec2>& breaks,
                    const std::function<double(Vec2)>& heightAt);

}  // namespace idap
