// Small vectors. Double for the model (metres), float for the renderer.
#pragma once

#include <cmath>
#include <concepts>
#include <numbers>

namespace idap {

inline constexpr double kPi = std::numbers::pi;

template <class T>  // a floating-point number, or several side by side
struct Vec2T {
  T x{}, y{};

  friend constexpr Vec2T operator+(Vec2T a, Vec2T b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2T operator-(Vec2T a, Vec2T b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2T operator-(Vec2T a) { return {-a.x, -a.y}; }
  friend constexpr Vec2T operator*(Vec2T a, T s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2T operator*(T s, Vec2T a) { return a * s; }
  friend constexpr Vec2T operator/(Vec2T a, T s) { return {a.x / s, a.y / s}; }
  constexpr Vec2T& operator+=(Vec2T b) { return *this = *this + b; }
  constexpr Vec2T& operator-=(Vec2T b) { return *this = *this - b; }
  friend constexpr bool operator==(const Vec2T& a, const Vec2T& b) requires std::floating_point<T> {
    return a.x == b.x && a.y == b.y;
  }
};

template <class T>  // a floating-point number, or several side by side
struct Vec3T {
  T x{}, y{}, z{};

  constexpr T& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  constexpr T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  friend constexpr Vec3T operator+(Vec3T a, Vec3T b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3T operator-(Vec3T a, Vec3T b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3T operator-(Vec3T a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3T operator*(Vec3T a, Vec3T b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend constexpr Vec3T operator*(Vec3T a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3T operator*(T s, Vec3T a) { return a * s; }
  friend constexpr Vec3T operator/(Vec3T a, T s) { return a * (T(1) / s); }
  friend constexpr Vec3T operator/(Vec3T a, Vec3T b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
  constexpr Vec3T& operator+=(Vec3T b) { return *this = *this + b; }
  constexpr Vec3T& operator-=(Vec3T b) { return *this = *this - b; }
  constexpr Vec3T& operator*=(Vec3T b) { return *this = *this * b; }
  constexpr Vec3T& operator*=(T s) { return *this = *this * s; }
  friend constexpr bool operator==(const Vec3T& a, const Vec3T& b) requires std::floating_point<T> {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }
};

using Vec2 = Vec2T<double>;
using Vec2f = Vec2T<float>;
using Vec3 = Vec3T<double>;
using Vec3f = Vec3T<float>;

template <class T>
constexpr T dot(Vec2T<T> a, Vec2T<T> b) {
  return a.x * b.x + a.y * b.y;
}
// The z component of the 3-D cross product: positive when b lies counter-clockwise of a.
template <class T>
constexpr T cross(Vec2T<T> a, Vec2T<T> b) {
  return a.x * b.y - a.y * b.x;
}
template <class T>
T length(Vec2T<T> a) {
  return std::hypot(a.x, a.y);
}
template <class T>
Vec2T<T> normalized(Vec2T<T> a) {
  return a / length(a);
}
// a turned by +90 degrees (counter-clockwise).
template <class T>
constexpr Vec2T<T> perpendicular(Vec2T<T> a) {
  return {-a.y, a.x};
}
template <class T>
Vec2T<T> rotated(Vec2T<T> a, T angle) {
  const T c = std::cos(angle), s = std::sin(angle);
  return {a.x * c - a.y * s, a.x * s + a.y * c};
}

template <class T>
constexpr T dot(Vec3T<T> a, Vec3T<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
constexpr Vec3T<T> cross(Vec3T<T> a, Vec3T<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
T length(Vec3T<T> a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
template <class T>
Vec3T<T> normalized(Vec3T<T> a) {
  return a * (T(1) / length(a));
}

inline Vec3f toFloat(Vec3 v) { return {float(v.x), float(v.y), float(v.z)}; }
inline Vec2f toFloat(Vec2 v) { return {float(v.x), float(v.y)}; }
inline Vec3 toDouble(Vec3f v) { return {v.x, v.y, v.z}; }
inline bool isFinite(Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); }
inline bool isFinite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace idap
