// Paths and outlines that parts are swept along and cut out of. Metres, radians.
#pragma once

#include <vector>

#include "geometry/polygon.h"
#include "geometry/transform.h"
#include "geometry/vec.h"

namespace idap::parametric {

using Path = std::vector<Vec3>;

// A smooth curve through the points (centripetal Catmull-Rom), samples points a span.
Path spline(const Path& points, int samples = 6, bool closed = false);
// The same points with round corners of that radius (less where a side is too short).
Path roundedPath(const Path& points, double radius, int segments = 6, bool closed = false);
Path translated(Path path, Vec3 by);

// Outlines, counter-clockwise.
Polygon rectangle(Vec2 min, Vec2 max);
Polygon roundedRectangle(Vec2 min, Vec2 max, double radius, int segments = 6);
Polygon ellipse(Vec2 centre, Vec2 radii, int points = 48);
// Rounder than a rectangle, squarer than an ellipse: exponent 2 ellipse, 4 and more nearly a rectangle.
Polygon superellipse(Vec2 centre, Vec2 radii, double exponent, int points = 64);
// Points of an arc from angle to angle (counter-clockwise where to > from), both ends included.
Polygon arc(Vec2 centre, double radius, double from, double to, int segments = 12);
// Corners rounded, each with radius or as much as fits. Open polylines keep their ends.
std::vector<Vec2> fillet(const std::vector<Vec2>& points, double radius, int segments = 4,
                         bool closed = true);
std::vector<Vec2> spline2(const std::vector<Vec2>& points, int samples = 6, bool closed = false);

// Plan outlines as paths at a height; outlines in x-z at a depth y.
Path atHeight(const Polygon& polygon, double z);
Path atDepth(const std::vector<Vec2>& xz, double y);

// The rotation that carries the z axis to direction (need not be unit), placed at origin; x stays as level
// as it can.
Transform facing(Vec3 origin, Vec3 direction);

double pathLength(const Path& path);
// A point at a fraction of the length.
Vec3 along(const Path& path, double fraction);

}  // namespace idap::parametric
