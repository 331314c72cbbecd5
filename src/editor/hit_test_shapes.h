// Where elements without a body of their own are on a plane: cameras, dimensions, labels; and walls seen from
// the side. What is hit and what is drawn should be the same. World metres.
#pragma once

#include <optional>

#include "editor/plane.h"
#include "model/home.h"

namespace idap {

inline constexpr double kCameraBody = 0.5;   // m, its diameter on the plan
inline constexpr double kCameraReach = 1.5;  // m from the eye to its aim, where the cone ends

Vec2 cameraAim(Plane plane, const Camera& camera);  // kCameraReach ahead
// The eye and the two ends of the field of view, at the aim's distance. In XZ and YZ the lens counts as if it
// were as high as wide.
Polygon cameraCone(Plane plane, const Camera& camera);

struct DimensionLine {
  Vec2 start, end;  // what is measured
  Vec2 from, to;    // the line as drawn, offset
};
// Nothing where it is not seen: on the plan a vertical one, from the side one that lies on the floor.
std::optional<DimensionLine> dimensionLine(Plane plane, const Dimension& dimension, double elevation);

// About the area that the text covers: fonts are not known here.
Polygon labelBox(const Label& label);

// The wall's outline from above, its silhouette from the side.
Polygon outline(Plane plane, const Home& home, WallId id, const Wall& wall);

}  // namespace idap
