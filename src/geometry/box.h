// Axis-aligned boxes; empty until a point is added.
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/vec.h"

namespace idap {

template <std::floating_point T>
struct Box3T {
  Vec3T<T> min{std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity(),
               std::numeric_limits<T>::infinity()};
  Vec3T<T> max{-std::numeric_limits<T>::infinity(), -std::numeric_limits<T>::infinity(),
               -std::numeric_limits<T>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  void add(Vec3T<T> p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y), std::min(min.z, p.z)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y), std::max(max.z, p.z)};
  }
  void add(const Box3T& b) {
    if (b.empty()) return;
    add(b.min);
    add(b.max);
  }
  Vec3T<T> size() const { return max - min; }
  Vec3T<T> centre() const { return (min + max) * T(0.5); }
};

struct Box2 {
  Vec2 min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  bool empty() const { return !(min.x <= max.x && min.y <= max.y); }
  void add(Vec2 p) {
    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
  }
  friend bool operator==(const Box2&, const Box2&) = default;
  bool overlaps(const Box2& b) const {
    return min.x <= b.max.x && b.min.x <= max.x && min.y <= b.max.y && b.min.y <= max.y;
  }
};

using Box3 = Box3T<double>;
using Box3f = Box3T<float>;

}  // namespace idap
