// Where elements without a body of their own are on a plane: cameras, dimensions, labels; and walls seen from
// the side. What is hit and what is drawn should be the same. World metres.
#pragma once

#include <optional>

#include "editor/plane.h"
#include "model/home.h"

namespace idap {

inline constexpr double kCameraCone = 0.9;  // m, how far the drawn cone of a camera reaches

// The end of the cone's axis; shorter where the camera looks out of the plane. The eye itself where it looks
// along the line of sight.
Vec2 cameraAim(Plane plane, const Camera& camera);
// The eye and the two ends of the field of view; from the side, of a picture of 4 to 3.
Polygon cameraCone(Plane plane, const Camera& camera);

struct DimensionLine {
  Vec2 start, end;  // what is measured
  Vec2 from, to;    // the line as drawn, offset
};
// Nothing where it is not seen: on the plan a vertical one, from the side one that lies on the floor.
std::optional<DimensionLine> dimensionLine(Plane plane, const Dimension& dimension, double elevation);

// About the area that the text covers, around its middle: fonts are not known here.
Polygon labelBox(const Label& label);

// The wall's outline from above, its silhouette from the side.
Polygon outline(Plane plane, const Home& home, WallId id, const Wall& wall);

// Where a level is cut when it is seen from the side, as nearness: the middle of its walls. Walls nearer than
// that are only outlined.
double sectionNearness(const Home& home, LevelId level, Plane plane);

}  // namespace idap
