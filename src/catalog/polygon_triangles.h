// Cutting one polygon in space into triangles: fans where it is convex, ears where it is not.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace idap {

// Appends triangles (indices into outline, wound as the outline is). normal is the polygon's, of any length.
// A polygon of n corners gives n - 2 triangles, even where it is not plane or cuts itself.
void triangulatePolygon(std::span<const Vec3f> outline, Vec3f normal,
                        std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace idap
