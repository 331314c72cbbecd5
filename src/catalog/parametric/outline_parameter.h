// The outline of a drawn solid among a piece's parameters, which are numbers: "x1", "y1", "x2", … in
// fractions of the piece's box (0..1), so that the outline is stretched with the piece. For a turned solid x
// is the distance from the axis in fractions of the radius, y the place along the axis.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/vec.h"

namespace idap::parametric {

inline constexpr std::size_t kMaxOutlinePoints = 256;

// Points beyond kMaxOutlinePoints are left out.
std::map<std::string, double> outlineParameters(const std::vector<Vec2>& points);

// Points up to the first that is missing or no number, each kept within the box; empty when there are fewer
// than two.
std::vector<Vec2> outlineFrom(const std::map<std::string, double>& parameters);

}  // namespace idap::parametric
