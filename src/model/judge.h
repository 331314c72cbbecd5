// One rule book for checking and for mending: a rule looks at a value and, where the value may be changed,
// mends it. Given const elements a Judge only finds what is wrong; given others it puts it right.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/utf8.h"
#include "model/home.h"

namespace idap {

inline constexpr double kMaxCoordinate = 10'000;  // m
inline constexpr double kMinSize = 1e-6;          // m
inline constexpr std::size_t kMaxElements = 1'000'000;
inline constexpr std::size_t kMaxPoints = 100'000;  // of one room or line
inline constexpr std::size_t kMaxParts = 10'000;    // sashes, light sources, properties of one element
inline constexpr int kMaxPictureSide = 65'536;      // pixels
inline constexpr int kMaxPictureSamples = 100'000'000;
inline constexpr std::size_t kMaxTextBytes = 1 << 20;  // of one text

template <class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

class Judge {
 public:
  explicit Judge(const Home& home) : home_(home) {}

  const Home& home() const { return home_; }
  const std::vector<const char*>& findings() const { return findings_; }
  bool clean() const { return findings_.empty(); }
  bool dropped() const { return dropped_; }

  void found(const char* what) { findings_.push_back(what); }
  // The element cannot be mended.
  void drop(const char* what) {
    found(what);
    dropped_ = true;
  }

  // Finite and not further than limit from zero, or else the fallback.
  template <class V>
  void finite(V& value, double limit, double fallback, const char* what) {
    if (std::isfinite(value) && std::abs(value) <= limit) return;
    found(what);
    assign(value, fallback);
  }
  // In low..high: brought to the nearer end, or to the fallback when it is no number.
  template <class V>
  void within(V& value, double low, double high, double fallback, const char* what) {
    if (value >= low && value <= high) return;
    found(what);
    assign(value, std::isfinite(value) ? std::clamp<double>(value, low, high) : fallback);
  }
  template <class V>
  void angle(V& value, const char* what) {
    finite(value, 1e6, 0, what);
  }
  template <class V>
  void length(V& value, const char* what) {
    within(value, kMinSize, kMaxCoordinate, 1, what);
  }
  template <class V>
  void place(V& value, const char* what) {
    if (isPlace(value)) return;
    found(what);
    assign(value, {});
  }
  static bool isPlace(Vec2 p) {
    return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate;  // false for NaN
  }
  static bool isPlace(Vec3 p) { return isPlace(Vec2{p.x, p.y}) && std::abs(p.z) <= kMaxCoordinate; }

  template <class V>
  void text(V& value) {
    if (value.size() > kMaxTextBytes) {
      found("text longer than a million letters: cut");
      if constexpr (!std::is_const_v<V>) value = std::string(utf8Prefix(value, kMaxTextBytes));
    }
    if (isUtf8(value)) return;
    found("letters that cannot be read: replaced");
    // Replacing grows the text, so it is cut once more.
    if constexpr (!std::is_const_v<V>) value = std::string(utf8Prefix(toValidUtf8(value), kMaxTextBytes));
  }
  template <class V>
  void texts(V& values) {
    atMost(values, kMaxParts, "too many properties: the rest dropped");
    const bool good = std::all_of(values.begin(), values.end(), [](const auto& entry) {
      return isText(entry.first) && isText(entry.second);
    });
    if (good) return;
    found("letters that cannot be read: replaced");
    if constexpr (!std::is_const_v<V>) {
      V mended;
      for (const auto& [key, value] : values) mended.emplace(mendedText(key), mendedText(value));
      values = std::move(mended);
    }
  }
  template <class V>
  void atMost(V& values, std::size_t count, const char* what) {
    if (values.size() <= count) return;
    found(what);
    if constexpr (!std::is_const_v<V>)
      values.erase(std::next(values.begin(), static_cast<std::ptrdiff_t>(count)), values.end());
  }
  // An id that must name an element of the table, or none.
  template <class V, class IdType, class T>
  void link(V& id, const Table<IdType, T>& table, const char* what) {
    if (!id || table.contains(id)) return;
    found(what);
    assign(id, {});
  }
  // An optional number that is absent rather than wrong.
  template <class V>
  void optional(V& value, double low, double high, const char* what) {
    if (!value || (*value >= low && *value <= high)) return;
    found(what);
    assign(value, {});
  }
  // The name of a file that came with the home, or empty.
  template <class V>
  void asset(V& name, const char* what) {
    if (name.empty() || home_.assets->contains(name)) return;
    found(what);
    assign(name, {});
  }

  static bool isText(const std::string& text) { return text.size() <= kMaxTextBytes && isUtf8(text); }
  static std::string mendedText(const std::string& text) {
    return std::string(utf8Prefix(toValidUtf8(text), kMaxTextBytes));
  }

 private:
  template <class V>
  static void assign(V& value, const std::type_identity_t<std::remove_const_t<V>>& mended) {
    if constexpr (!std::is_const_v<V>) value = mended;
  }
  template <class V>
  requires std::floating_point<std::remove_const_t<V>>
  static void assign(V& value, double mended) {
    if constexpr (!std::is_const_v<V>) value = static_cast<V>(mended);
  }

  const Home& home_;
  std::vector<const char*> findings_;
  bool dropped_ = false;
};

}  // namespace idap
