// Affine maps of space: a 3x3 linear part (by columns) and a translation. World space is Z up, right-handed.
#pragma once

#include "geometry/vec.h"

namespace idap {

template <class T>
struct TransformT {
  Vec3T<T> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  // images of the axes
  Vec3T<T> origin{};

  constexpr Vec3T<T> vector(Vec3T<T> v) const { return x * v.x + y * v.y + z * v.z; }
  constexpr Vec3T<T> point(Vec3T<T> p) const { return vector(p) + origin; }
  constexpr T determinant() const { return dot(x, cross(y, z)); }

  // (a * b).point(p) == a.point(b.point(p))
  friend constexpr TransformT operator*(const TransformT& a, const TransformT& b) {
    return {a.vector(b.x), a.vector(b.y), a.vector(b.z), a.point(b.origin)};
  }
  friend constexpr bool operator==(const TransformT&, const TransformT&) = default;

  // The linear part's cofactor matrix: carries normals (not normalized) under any invertible map.
  constexpr TransformT cofactor() const { return {cross(y, z), cross(z, x), cross(x, y), {}}; }

  constexpr TransformT inverse() const {
    const Vec3T<T> a = cross(y, z), b = cross(z, x), c = cross(x, y);
    const T s = T(1) / dot(x, a);
    TransformT r{{a.x * s, b.x * s, c.x * s}, {a.y * s, b.y * s, c.y * s}, {a.z * s, b.z * s, c.z * s}, {}};
    r.origin = -r.vector(origin);
    return r;
  }

  static constexpr TransformT translation(Vec3T<T> t) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, t}; }
  static constexpr TransformT scaling(Vec3T<T> s) { return {{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}, {}}; }
  static TransformT rotationX(T a) {
    const T c = std::cos(a), s = std::sin(a);
    return {{1, 0, 0}, {0, c, s}, {0, -s, c}, {}};
  }
  static TransformT rotationY(T a) {
    const T c = std::cos(a), s = std::sin(a);
    return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}, {}};
  }
  static TransformT rotationZ(T a) {
    const T c = std::cos(a), s = std::sin(a);
    return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}, {}};
  }
};

using Transform = TransformT<double>;
using Transformf = TransformT<float>;

inline Transformf toFloat(const Transform& t) {
  return {toFloat(t.x), toFloat(t.y), toFloat(t.z), toFloat(t.origin)};
}

}  // namespace idap
