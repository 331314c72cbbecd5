#include "catalog/parametric/seating.h"

#include <algorithm>

namespace idap::parametric {

void dishedSeat(Builder& b, const Polygon& outline, double top, double thickness, double dish) {
  const Box2 box = bounds(outline);
  const Vec2 middle = (box.min + box.max) * 0.5;
  const auto ring = [&](double scale, double z) {
    Path path;
    for (const Vec2 p : outline)
      path.push_back({middle.x + (p.x - middle.x) * scale, middle.y + (p.y - middle.y) * scale, z});
    return path;
  };
  const double r = std::min(0.008, 0.3 * thickness),
               half = std::max(0.05, 0.5 * std::min(box.max.x - box.min.x, box.max.y - box.min.y));
  const double in = 1 - r / half;
  b.loft({ring(in - 0.06, top - thickness), ring(in, top - thickness + 0.4 * r),
          ring(1, top - thickness + 2 * r), ring(1, top - r), ring((1 + in) / 2, top - 0.3 * r),
          ring(in, top), ring(0.93 * in, top), ring(0.82 * in, top - 0.35 * dish),
          ring(0.65 * in, top - 0.8 * dish), ring(0.4 * in, top - dish), ring(0.05, top - dish)},
         true, 0.9);
}

void leaningCushion(Builder& b, Vec3 min, Vec3 max, double angle, const Soft& soft, bool piped) {
  const Vec3 foot{0, (min.y + max.y) / 2, min.z};
  b.within(Transform::translation(foot) * Transform::rotationX(-angle) * Transform::translation(-foot), [&] {
    b.cushion(min, max, soft);
    if (piped) {
      const double r = std::min(soft.radius, 0.05);
      b.piping({min.x + 0.004, min.y, min.z + 0.004}, {max.x - 0.004, max.y, max.z - 0.004}, r, 1, 0.12);
      b.piping({min.x + 0.004, min.y, min.z + 0.004}, {max.x - 0.004, max.y, max.z - 0.004}, r, 1, 0.88);
    }
  });
}

}  // namespace idap::parametric
