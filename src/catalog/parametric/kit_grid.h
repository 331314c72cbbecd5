// Grids of points as mesh parts: what the kit's curved parts are made of. Internal to the kit.
#pragma once

#include <array>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/polygon.h"

namespace idap::parametric {

// Rows of columns points each, joined into quads; the front is where (along a row) x (from row to row)
// points. Texture coordinates in metres, u from row to row where rowsAreGrain is false, else along a row.
void appendGrid(Mesh& part, const std::vector<Vec3>& points, int columns, int rows, bool rowsAreGrain);

// Drops triangles without area: they have no normal and light nothing.
void dropEmptyTriangles(Mesh& part);

// A box with round edges as six grids that meet exactly: half steps of arc from an edge's middle to its face
// (two of them make a quarter turn), cells along the flat part of each axis.
Mesh roundedBoxGrid(Vec3 min, Vec3 max, double radius, int half, std::array<int, 3> cells, int grain);

// A ring moved inwards (to its left) by that much, point for point.
Polygon insetRing(const Polygon& ring, double by);

}  // namespace idap::parametric
