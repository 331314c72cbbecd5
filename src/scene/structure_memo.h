// What the builders of walls and rooms have made before, by all that it was made from: when one wall moves,
// only what lies near it is worked out again.
#pragma once

#include <memory>
#include <string>
#include <type_traits>

#include "base/memo.h"
#include "geometry/mesh.h"
#include "geometry/polygon.h"

namespace idap {

struct StructureMemo {
  Memo<Regions> regions;
  Memo<std::shared_ptr<const Mesh>> meshes;
  void nextRound() {
    regions.nextRound();
    meshes.nextRound();
  }
};

// The bytes of everything that a result depends on, one after another; what: which function it is.
class MemoKey {
 public:
  explicit MemoKey(char what) : bytes_(1, what) {}

  template <class T>
  requires std::is_arithmetic_v<T> MemoKey& add(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  MemoKey& add(Vec2 p) { return add(p.x).add(p.y); }
  MemoKey& add(const std::vector<Vec2>& points) {
    add(points.size());
    for (const Vec2 p : points) add(p);
    return *this;
  }
  MemoKey& add(const std::vector<Polygon>& polygons) {
    add(polygons.size());
    for (const Polygon& p : polygons) add(p);
    return *this;
  }
  MemoKey& add(const Regions& regions) {
    add(regions.size());
    for (const Region& r : regions) add(r.outer).add(r.holes);
    return *this;
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace idap
