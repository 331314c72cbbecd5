#include "catalog/parametric/outline_parameter.h"

#include <algorithm>
#include <cmath>

namespace idap::parametric {

std::map<std::string, double> outlineParameters(const std::vector<Vec2>& points) {
  std::map<std::string, double> parameters;
  for (std::size_t i = 0; i < std::min(points.size(), kMaxOutlinePoints); ++i) {
    const std::string number = std::to_string(i + 1);
    parameters["x" + number] = points[i].x;
    parameters["y" + number] = points[i].y;
  }
  return parameters;
}

std::vector<Vec2> outlineFrom(const std::map<std::string, double>& parameters) {
  std::vector<Vec2> points;
  while (points.size() < kMaxOutlinePoints) {
    const std::string number = std::to_string(points.size() + 1);
    const auto x = parameters.find("x" + number), y = parameters.find("y" + number);
    if (x == parameters.end() || y == parameters.end()) break;
    if (!std::isfinite(x->second) || !std::isfinite(y->second)) break;
    points.push_back({std::clamp(x->second, 0.0, 1.0), std::clamp(y->second, 0.0, 1.0)});
  }
  if (points.size() < 2) points.clear();
  return points;
}

}  // namespace idap::parametric
