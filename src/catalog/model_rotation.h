// The nine numbers by which Sweet Home 3D's files turn a model upright.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "geometry/vec.h"

namespace idap {

// text: the rows of a matrix in the model's space (x right, y up, z front). The images of the axes of our
// object space (x right, y back, z up), as in ModelRef::rotation. Nothing when it is not nine plausible
// numbers.
std::optional<std::array<Vec3, 3>> modelRotationOf(std::string_view text);

}  // namespace idap
