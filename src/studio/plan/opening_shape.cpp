#include "studio/plan/opening_shape.h"

#include <algorithm>
#include <cmath>

#include "model/wall_path.h"
#include "studio/plan/view_map.h"

namespace idap {

namespace {

constexpr double kTwoLeaves = 1.3;  // m: wider doors have two

}  // namespace

OpeningShape openingShape(const Home& home, const Opening& opening) {
  OpeningShape shape;
  const Vec2 centre{opening.position.x, opening.position.y};
  const Vec2 right = rotated(Vec2{1, 0}, opening.angle), back = perpendicular(right);
  const double flip = opening.mirrored ? -1 : 1;
  const double w = opening.size.x / 2, d = opening.size.y;
  shape.along = right;

  // y of the part in the wall, from the middle of the box, to the back.
  double far = d / 2 - opening.wallDistance * d;
  double near = far - std::clamp(opening.wallThickness, 0.0, 1.0) * d;
  const auto box = [&](double y0, double y1) {
    return std::array<Vec2, 4>{centre - right * w + back * y0, centre + right * w + back * y0,
                               centre + right * w + back * y1, centre - right * w + back * y1};
  };
  shape.frame = box(near, far);
  if (const Wall* wall = opening.wall ? home.walls.find(opening.wall) : nullptr) {
    // All of the wall's thickness, seen square to the opening.
    const WallPath path(*wall);
    const double s = path.nearest(centre);
    const Vec2 normal = perpendicular(path.direction(s));
    if (const double across = dot(normal, back); std::abs(across) > 0.5) {
      const double middle = dot(path.point(s) - centre, normal) / across;
      const double half = wall->thickness / 2 / std::abs(across);
      near = std::min(near, middle - half);
      far = std::max(far, middle + half);
    }
  }
  shape.hole = box(near, far);

  std::vector<Sash> sashes = opening.sashes;
  // What the catalog gives no leaves slides or folds.
  if (sashes.empty() && opening.kind == OpeningKind::Door && opening.model.catalogId.empty()) {
    if (opening.size.x > kTwoLeaves) {
      sashes = {Sash{{0, 1}, 0.5, 0, -kPi / 2}, Sash{{1, 1}, 0.5, kPi, 1.5 * kPi}};
    } else {
      sashes = {Sash{{0, 1}, 1, 0, -kPi / 2}};
    }
  }
  for (const Sash& sash : sashes) {
    OpeningShape::Leaf leaf;
    leaf.axis =
        centre + right * (flip * (sash.axis.x - 0.5) * opening.size.x) + back * ((0.5 - sash.axis.y) * d);
    leaf.width = sash.width * opening.size.x;
    leaf.from = opening.angle + (opening.mirrored ? kPi - sash.startAngle : sash.startAngle);
    leaf.to = opening.angle + (opening.mirrored ? kPi - sash.endAngle : sash.endAngle);
    shape.leaves.push_back(leaf);
  }
  return shape;
}

Box2 openingBox(const Home& home, const Opening& opening) {
  const OpeningShape shape = openingShape(home, opening);
  Box2 box;
  for (const Vec2 p : shape.hole) box.add(p);
  for (const Vec2 p : shape.frame) box.add(p);
  for (const OpeningShape::Leaf& leaf : shape.leaves) add(box, grown({leaf.axis, leaf.axis}, leaf.width));
  return box;
}

}  // namespace idap
