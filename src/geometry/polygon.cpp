#include "geometry/polygon.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace idap {

namespace {

constexpr double kSliver = 1e-9;  // m2; smaller parts are rounding, not geometry

void ignoreMessage(const char*, void*) {}

// One GEOS context and what is made in it. A context is a small object: one a call keeps every call
// independent of threads.
class Geos {
 public:
  Geos() : context_(GEOS_init_r()) {
    GEOSContext_setNoticeMessageHandler_r(context_, ignoreMessage, nullptr);
    GEOSContext_setErrorMessageHandler_r(context_, ignoreMessage, nullptr);
  }
  ~Geos() { GEOS_finish_r(context_); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;

  struct Destroy {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context, g); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;
  Geometry own(GEOSGeometry* g) const { return {g, Destroy{context_}}; }
  GEOSContextHandle_t handle() const { return context_; }

  GEOSGeometry* ring(const Polygon& polygon) const {
    std::vector<double> xy;
    xy.reserve(2 * polygon.size() + 2);
    for (const Vec2& p : polygon) xy.push_back(p.x), xy.push_back(p.y);
    xy.push_back(polygon.front().x), xy.push_back(polygon.front().y);
    GEOSCoordSequence* sequence =
        GEOSCoordSeq_copyFromBuffer_r(context_, xy.data(), static_cast<unsigned>(polygon.size() + 1), 0, 0);
    return sequence ? GEOSGeom_createLinearRing_r(context_, sequence) : nullptr;
  }

  Geometry polygon(const Polygon& outer, const std::vector<Polygon>& holes) const {
    if (outer.size() < 3 || !finite(outer)) return own(nullptr);
    GEOSGeometry* shell = ring(outer);
    if (!shell) return own(nullptr);
    std::vector<GEOSGeometry*> rings;
    for (const Polygon& hole : holes) {
      if (hole.size() < 3 || !finite(hole)) continue;
      if (GEOSGeometry* r = ring(hole)) rings.push_back(r);
    }
    return valid(
        own(GEOSGeom_createPolygon_r(context_, shell, rings.data(), static_cast<unsigned>(rings.size()))));
  }

  // All regions as one valid geometry; never null.
  Geometry geometry(const Regions& regions) const {
    std::vector<Geometry> parts;
    for (const Region& r : regions) {
      if (Geometry g = polygon(r.outer, r.holes)) parts.push_back(std::move(g));
    }
    return united(std::move(parts));
  }

  Geometry united(std::vector<Geometry> parts) const {
    if (parts.size() == 1) return std::move(parts.front());
    std::vector<GEOSGeometry*> raw;
    raw.reserve(parts.size());
    for (Geometry& g : parts) raw.push_back(g.release());
    Geometry collection = own(GEOSGeom_createCollection_r(context_, GEOS_GEOMETRYCOLLECTION, raw.data(),
                                                          static_cast<unsigned>(raw.size())));
    if (raw.empty()) return collection;
    Geometry result = own(GEOSUnaryUnion_r(context_, collection.get()));
    if (!result) result = own(GEOSUnaryUnionPrec_r(context_, collection.get(), kGrid));
    return result ? std::move(result) : own(GEOSGeom_createEmptyCollection_r(context_, GEOS_POLYGON));
  }

  Geometry valid(Geometry g) const {
    if (!g || GEOSisValid_r(context_, g.get()) == 1) return g;
    GEOSMakeValidParams* params = GEOSMakeValidParams_create_r(context_);
    GEOSMakeValidParams_setMethod_r(context_, params, GEOS_MAKE_VALID_STRUCTURE);
    GEOSMakeValidParams_setKeepCollapsed_r(context_, params, 0);
    Geometry mended = own(GEOSMakeValidWithParams_r(context_, g.get(), params));
    GEOSMakeValidParams_destroy_r(context_, params);
    return mended;
  }

  Regions regions(const GEOSGeometry* g) const {
    Regions result;
    collect(g, result);
    return result;
  }

  static constexpr double kGrid = 1e-7;  // m; what a failed operation is tried again on

 private:
  static bool finite(const Polygon& polygon) {
    return std::all_of(polygon.begin(), polygon.end(), [](Vec2 p) { return isFinite(p); });
  }

  Polygon points(const GEOSGeometry* linear, bool counterClockwise) const {
    const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(context_, linear);
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(context_, sequence, &size);
    if (size < 4) return {};
    std::vector<double> xy(2 * std::size_t{size});
    GEOSCoordSeq_copyToBuffer_r(context_, sequence, xy.data(), 0, 0);
    Polygon result(size - 1);
    for (std::size_t i = 0; i + 1 < size; ++i) result[i] = {xy[2 * i], xy[2 * i + 1]};
    if ((signedArea(result) > 0) != counterClockwise) std::reverse(result.begin(), result.end());
    return result;
  }

  void collect(const GEOSGeometry* g, Regions& out) const {
    if (!g) return;
    const int type = GEOSGeomTypeId_r(context_, g);
    if (type == GEOS_POLYGON) {
      if (GEOSisEmpty_r(context_, g) != 0) return;
      Region region{points(GEOSGetExteriorRing_r(context_, g), true), {}};
      if (signedArea(region.outer) < kSliver) return;
      const int holes = GEOSGetNumInteriorRings_r(context_, g);
      for (int i = 0; i < holes; ++i) {
        Polygon hole = points(GEOSGetInteriorRingN_r(context_, g, i), false);
        if (signedArea(hole) <= -kSliver) region.holes.push_back(std::move(hole));
      }
      out.push_back(std::move(region));
    } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
      const int parts = GEOSGetNumGeometries_r(context_, g);
      for (int i = 0; i < parts; ++i) collect(GEOSGetGeometryN_r(context_, g, i), out);
    }
  }

  GEOSContextHandle_t context_;
};

using Overlay = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*);
using OverlayOnGrid = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*,
                                        double);

Regions overlay(const Regions& a, const Regions& b, Overlay exact, OverlayOnGrid onGrid) {
  const Geos geos;
  const Geos::Geometry ga = geos.geometry(a), gb = geos.geometry(b);
  if (!ga || !gb) return {};
  Geos::Geometry result = geos.own(exact(geos.handle(), ga.get(), gb.get()));
  if (!result) result = geos.own(onGrid(geos.handle(), ga.get(), gb.get(), Geos::kGrid));
  return geos.regions(result.get());
}

bool before(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
struct Before {
  bool operator()(Vec2 a, Vec2 b) const { return before(a, b); }
};

// Collects triangles and gives equal points one index.
class Collector {
 public:
  explicit Collector(Triangulation& out) : out_(out) {}
  void add(Vec2 a, Vec2 b, Vec2 c) {
    if (cross(b - a, c - a) < 0) std::swap(b, c);
    out_.triangles.push_back({index(a), index(b), index(c)});
  }

 private:
  std::uint32_t index(Vec2 p) {
    const auto [at, added] = indices_.try_emplace(p, static_cast<std::uint32_t>(out_.points.size()));
    if (added) out_.points.push_back(p);
    return at->second;
  }
  Triangulation& out_;
  std::map<Vec2, std::uint32_t, Before> indices_;
};

// One region by GEOS. False, and nothing added, where the triangles do not cover it.
bool addTriangles(const Geos& geos, const Region& region, Collector& collector) {
  const Geos::Geometry polygon = geos.polygon(region.outer, region.holes);
  if (!polygon) return false;
  const Geos::Geometry triangles =
      geos.own(GEOSConstrainedDelaunayTriangulation_r(geos.handle(), polygon.get()));
  if (!triangles) return false;
  std::vector<std::array<Vec2, 3>> corners;
  double covered = 0;
  const int count = GEOSGetNumGeometries_r(geos.handle(), triangles.get());
  for (int i = 0; i < count; ++i) {
    const GEOSGeometry* triangle = GEOSGetGeometryN_r(geos.handle(), triangles.get(), i);
    if (GEOSGeomTypeId_r(geos.handle(), triangle) != GEOS_POLYGON) continue;
    const GEOSCoordSequence* sequence =
        GEOSGeom_getCoordSeq_r(geos.handle(), GEOSGetExteriorRing_r(geos.handle(), triangle));
    double xy[8];
    unsigned size = 0;
    GEOSCoordSeq_getSize_r(geos.handle(), sequence, &size);
    if (size != 4) continue;
    GEOSCoordSeq_copyToBuffer_r(geos.handle(), sequence, xy, 0, 0);
    const std::array<Vec2, 3> t{Vec2{xy[0], xy[1]}, Vec2{xy[2], xy[3]}, Vec2{xy[4], xy[5]}};
    const double doubled = std::abs(cross(t[1] - t[0], t[2] - t[0]));
    if (doubled == 0) continue;
    covered += doubled / 2;
    corners.push_back(t);
  }
  const double wanted = area({region});
  if (std::abs(covered - wanted) > 1e-6 * wanted + kSliver) return false;
  for (const auto& t : corners) collector.add(t[0], t[1], t[2]);
  return true;
}

// Cuts the region in two by a line through the middle of its first hole (or of itself), until GEOS can do
// the parts: its joining of holes fails where many of them touch.
void addTriangles(const Geos& geos, const Region& region, Collector& collector, int depth) {
  if (addTriangles(geos, region, collector) || depth == 0) return;
  const Box2 box = bounds(region.outer);
  const Box2 middle = region.holes.empty() ? box : bounds(region.holes.front());
  const bool acrossX = depth % 2 == 0;
  Box2 low = box, high = box;
  if (acrossX) {
    low.max.x = high.min.x = (middle.min.x + middle.max.x) / 2;
  } else {
    low.max.y = high.min.y = (middle.min.y + middle.max.y) / 2;
  }
  for (const Box2& half : {low, high}) {
    const Polygon window{half.min, {half.max.x, half.min.y}, half.max, {half.min.x, half.max.y}};
    for (const Region& part : intersect({region}, {{window, {}}})) {
      addTriangles(geos, part, collector, depth - 1);
    }
  }
}

}  // namespace

double signedArea(const Polygon& polygon) {
  if (polygon.size() < 3) return 0;
  // Relative to the first point, so that far from the origin nothing cancels.
  const Vec2 base = polygon[0];
  double sum = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += cross(polygon[i] - base, polygon[i + 1] - base);
  }
  return sum / 2;
}

double area(const Regions& regions) {
  double sum = 0;
  for (const Region& r : regions) {
    sum += std::abs(signedArea(r.outer));
    for (const Polygon& hole : r.holes) sum -= std::abs(signedArea(hole));
  }
  return sum;
}

bool contains(const Polygon& polygon, Vec2 point) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 a = polygon[i], b = polygon[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

Box2 bounds(const Polygon& polygon) {
  Box2 box;
  for (const Vec2& p : polygon) box.add(p);
  return box;
}

Box2 bounds(const Regions& regions) {
  Box2 box;
  for (const Region& r : regions)
    for (const Vec2& p : r.outer) box.add(p);
  return box;
}

double perimeter(const Polygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    sum += length(polygon[i] - polygon[j]);
  }
  return sum;
}

Regions repair(const Polygon& polygon) {
  const Geos geos;
  return geos.regions(geos.polygon(polygon, {}).get());
}

Regions unite(const Regions& a, const Regions& b) { return overlay(a, b, GEOSUnion_r, GEOSUnionPrec_r); }

Regions unite(const std::vector<Polygon>& polygons) {
  const Geos geos;
  std::vector<Geos::Geometry> parts;
  for (const Polygon& polygon : polygons) {
    if (Geos::Geometry g = geos.polygon(polygon, {})) parts.push_back(std::move(g));
  }
  return geos.regions(geos.united(std::move(parts)).get());
}

Regions subtract(const Regions& a, const Regions& b) {
  return overlay(a, b, GEOSDifference_r, GEOSDifferencePrec_r);
}

Regions intersect(const Regions& a, const Regions& b) {
  return overlay(a, b, GEOSIntersection_r, GEOSIntersectionPrec_r);
}

Regions buffer(const Regions& a, double distance) {
  const Geos geos;
  const Geos::Geometry g = geos.geometry(a);
  if (!g || !std::isfinite(distance)) return {};
  constexpr int kQuadrantSegments = 8;  // unused by mitred joins but asked for
  constexpr double kMitreLimit = 5;
  return geos.regions(geos.own(GEOSBufferWithStyle_r(geos.handle(), g.get(), distance, kQuadrantSegments,
                                                     GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, kMitreLimit))
                          .get());
}

Triangulation triangulate(const Regions& regions) {
  Triangulation result;
  Collector collector(result);
  const Geos geos;
  for (const Region& region : regions) {
    if (region.holes.empty() && region.outer.size() == 3) {
      collector.add(region.outer[0], region.outer[1], region.outer[2]);
    } else if (area({region}) >= kSliver) {
      addTriangles(geos, region, collector, 12);
    }
  }
  return result;
}

}  // namespace idap
