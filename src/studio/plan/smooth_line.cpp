#include "studio/plan/smooth_line.h"

namespace idap {

std::vector<Vec2> smoothLine(const std::vector<Vec2>& points, bool closed, int chords) {
  const auto n = std::ptrdiff_t(points.size());
  if (n < 3) return points;
  const auto at = [&](std::ptrdiff_t i) {
    if (closed) return points[std::size_t((i % n + n) % n)];
    return points[std::size_t(i < 0 ? 0 : i >= n ? n - 1 : i)];
  };
  std::vector<Vec2> curve{points.front()};
  const std::ptrdiff_t spans = closed ? n : n - 1;
  for (std::ptrdiff_t i = 0; i < spans; ++i) {
    const Vec2 a = at(i), b = at(i + 1), before = (b - at(i - 1)) * 0.5, after = (at(i + 2) - a) * 0.5;
    for (int k = 1; k <= chords; ++k) {
      const double t = double(k) / chords, t2 = t * t, t3 = t2 * t;
      curve.push_back(a * (2 * t3 - 3 * t2 + 1) + before * (t3 - 2 * t2 + t) + b * (3 * t2 - 2 * t3) +
                      after * (t3 - t2));
    }
  }
  if (closed) curve.pop_back();
  return curve;
}

}  // namespace idap
