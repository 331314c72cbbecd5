#include "catalog/model_rotation.h"

#include <cmath>

#include "catalog/text_scan.h"

namespace idap {

std::optional<std::array<Vec3, 3>> modelRotationOf(std::string_view text) {
  constexpr double kLargest = 1000;  // a rotation's numbers are within 1; some files scale a little
  std::array<double, 9> m;
  TextScan scan(text);
  for (double& value : m)
    if (!scan.number(value) || !(std::abs(value) <= kLargest)) return std::nullopt;
  // The image of one of the file's axes is a column of its matrix; in our axes (x, y, z) is (x, -z, y).
  const auto image = [&](std::size_t column) { return Vec3{m[column], -m[column + 6], m[column + 3]}; };
  return std::array<Vec3, 3>{image(0), -image(2), image(1)};
}

}  // namespace idap
