#include "model/wall_path.h"

#include <algorithm>

namespace idap {

namespace {
constexpr double kStraight = 1e-6;  // radians of sweep that make no visible difference
}

WallPath::WallPath(const Wall& wall) : start_(wall.start), end_(wall.end), arc_(wall.arcExtent) {
  const Vec2 chord = end_ - start_;
  const double straight = idap::length(chord);
  along_ = straight > 0 ? chord / straight : Vec2{1, 0};
  if (std::abs(arc_) < kStraight) arc_ = 0;
  if (arc_ == 0) {
    length_ = straight;
    return;
  }
  // The chord spans the sweep: c = 2 r sin(a/2), and its middle is r cos(a/2) from the centre.
  radius_ = straight / (2 * std::abs(std::sin(arc_ / 2)));
  centre_ = (start_ + end_) / 2 + perpendicular(along_) * (straight / 2 / std::tan(arc_ / 2));
  length_ = radius_ * std::abs(arc_);
}

Vec2 WallPath::point(double distance) const {
  if (arc_ == 0) return start_ + along_ * distance;
  return centre_ + rotated(start_ - centre_, arc_ * distance / length_);
}

Vec2 WallPath::direction(double distance) const {
  if (arc_ == 0) return along_;
  const Vec2 outward = normalized(point(distance) - centre_);
  return arc_ > 0 ? perpendicular(outward) : -perpendicular(outward);
}

double WallPath::nearest(Vec2 p) const {
  if (arc_ == 0) return std::clamp(dot(p - start_, along_), 0.0, length_);
  const Vec2 from = start_ - centre_, to = p - centre_;
  double turn = std::atan2(cross(from, to), dot(from, to));
  if (arc_ < 0) turn = -turn;
  if (turn < 0) turn += 2 * kPi;
  const double sweep = std::abs(arc_);
  if (turn <= sweep) return turn * radius_;
  return idap::length(p - start_) <= idap::length(p - end_) ? 0 : length_;
}

std::vector<Vec2> WallPath::face(double offset, double tolerance) const {
  int segments = 1;
  if (arc_ != 0) {
    const double r = std::max(radius_ + std::abs(offset), tolerance);
    const double step = 2 * std::acos(std::max(0.0, 1 - tolerance / r));
    segments = static_cast<int>(std::clamp(std::ceil(std::abs(arc_) / step), 2.0, 512.0));
  }
  // The inner face of a tight arc does not pass its centre.
  const double inner = arc_ > 0 ? std::min(offset, radius_) : arc_ < 0 ? std::max(offset, -radius_) : offset;
  std::vector<Vec2> points;
  for (int i = 0; i <= segments; ++i) {
    const double distance = length_ * i / segments;
    points.push_back(point(distance) + perpendicular(direction(distance)) * inner);
  }
  return points;
}

}  // namespace idap
