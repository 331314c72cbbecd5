// Polygons of the plan: area, containment, and over GEOS the set operations and triangulation. Metres.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/box.h"
#include "geometry/vec.h"

namespace idap {

using Polygon = std::vector<Vec2>;  // a ring; the last point is not repeated

// A polygon with holes; outer counter-clockwise, holes clockwise.
struct Region {
  Polygon outer;
  std::vector<Polygon> holes;
  friend bool operator==(const Region&, const Region&) = default;
};
using Regions = std::vector<Region>;

double signedArea(const Polygon& polygon);  // m2, positive counter-clockwise
double area(const Regions& regions);
bool contains(const Polygon& polygon, Vec2 point);  // even-odd; points on the border may go either way
Box2 bounds(const Polygon& polygon);
Box2 bounds(const Regions& regions);
double perimeter(const Polygon& polygon);

// Set operations. Inputs may be self-intersecting or in any orientation: they are repaired first. Results
// drop slivers under 1e-9 m2. Never throw for finite input: what GEOS cannot do comes back empty.
Regions repair(const Polygon& polygon);
Regions unite(const Regions& a, const Regions& b);
Regions unite(const std::vector<Polygon>& polygons);
Regions subtract(const Regions& a, const Regions& b);
Regions intersect(const Regions& a, const Regions& b);
Regions buffer(const Regions& a, double distance);  // mitred corners; negative shrinks

// Triangles, counter-clockwise, that cover the regions exactly (constrained Delaunay). Indices into points.
struct Triangulation {
  std::vector<Vec2> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
Triangulation triangulate(const Regions& regions);

}  // namespace idap
