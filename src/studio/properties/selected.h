// What the property panel is about: the selection, and what its elements have in common.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "editor/editor.h"

namespace idap {

// A value that several elements share, or do not.
template <class V>
struct Common {
  bool any = false, mixed = false;
  V value{};

  void add(const V& v) {
    if (!any) {
      any = true;
      value = v;
    } else if (!same(v, value)) {
      mixed = true;
    }
  }
  static bool same(const V& a, const V& b) {
    if constexpr (std::is_floating_point_v<V>)
      return std::abs(a - b) <= 1e-9;
    else
      return a == b;
  }
};

enum class ElementKind {
  None,
  Piece,  // furniture, doors and windows
  Group,
  Wall,
  Room,
  Camera,
  Dimension,
  Label,
  Polyline,
  Mixed
};

struct Selected {
  explicit Selected(const Editor& editor);

  Home home;             // a snapshot
  LevelId level;         // drawn on
  double elevation = 0;  // of that level
  EditorSettings settings;
  Elements elements;  // as selected
  Elements all;       // with what is in its groups
  ElementKind kind = ElementKind::None;
  std::size_t count = 0;

  // get: const Piece& -> a value; of pieces in groups too.
  template <class F>
  auto ofPieces(F get) const {
    Common<std::decay_t<decltype(get(std::declval<const Piece&>()))>> common;
    for (const FurnitureId id : all.furniture)
      if (const Furniture* piece = home.furniture.find(id)) common.add(get(*piece));
    for (const OpeningId id : all.openings)
      if (const Opening* opening = home.openings.find(id)) common.add(get(*opening));
    return common;
  }
  template <class F>
  auto ofFurniture(F get) const {
    return of(home.furniture, all.furniture, get);
  }
  template <class F>
  auto ofOpenings(F get) const {
    return of(home.openings, all.openings, get);
  }
  template <class F>
  auto ofWalls(F get) const {
    return of(home.walls, all.walls, get);
  }
  template <class F>
  auto ofRooms(F get) const {
    return of(home.rooms, all.rooms, get);
  }
  template <class F>
  auto ofCameras(F get) const {
    return of(home.cameras, all.cameras, get);
  }
  template <class F>
  auto ofDimensions(F get) const {
    return of(home.dimensions, all.dimensions, get);
  }
  template <class F>
  auto ofLabels(F get) const {
    return of(home.labels, all.labels, get);
  }
  template <class F>
  auto ofPolylines(F get) const {
    return of(home.polylines, all.polylines, get);
  }
  // Only lamps among the furniture.
  template <class F>
  auto ofLamps(F get) const {
    Common<std::decay_t<decltype(get(std::declval<const Lamp&>()))>> common;
    for (const FurnitureId id : all.furniture)
      if (const Furniture* piece = home.furniture.find(id); piece && piece->lamp)
        common.add(get(*piece->lamp));
    return common;
  }

  std::vector<const Piece*> pieces() const;

 private:
  template <class IdType, class T, class F>
  static auto of(const Table<IdType, T>& table, const std::vector<IdType>& ids, F get) {
    Common<std::decay_t<decltype(get(std::declval<const T&>()))>> common;
    for (const IdType id : ids)
      if (const T* element = table.find(id)) common.add(get(*element));
    return common;
  }
};

// Changes the elements of these ids that exist.
template <class IdType, class T, class F>
Home changeEach(const Home& home, Table<IdType, T> Home::*table, const std::vector<IdType>& ids, F change) {
  Home next = home;
  for (const IdType id : ids)
    if (const T* found = (home.*table).find(id)) {
      T copy = *found;
      change(copy);
      if (!(copy == *found)) (next.*table).set(id, std::move(copy));
    }
  return next;
}

inline double degrees(double radians) { return radians * 180 / kPi; }
inline double radians(double degrees) { return degrees * kPi / 180; }
double positiveDegrees(double radians);  // degrees, 0..360
double signedDegrees(double radians);    // degrees, -180..180

}  // namespace idap
