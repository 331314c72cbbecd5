// Rays of many paths, one a lane, and what they hit.
#pragma once

#include <limits>

#include "render/accel/interaction.h"
#include "render/accel/ray.h"
#include "render/material/bsdf.h"

namespace idap::render {

struct LaneRays {
  LaneVec origin;
  LaneVec direction;  // unit
  Floats tMin = 0.0f;
  Floats tMax = std::numeric_limits<float>::infinity();
};

struct LaneHits {
  LaneMask found{false};
  LaneMask lamp{false};  // of those, the spheres of lamps
  Floats t = 0.0f, u = 0.0f, v = 0.0f;
  LaneVec ng{};  // the triangle's normal, of any length; in the mesh's space where the scene has two levels
  // Of the lanes that found something, as in Hit; index: of the triangle or the lamp.
  std::uint32_t instance[kLanes], index[kLanes];

  Hit hit(int k) const {
    Hit h{.t = lane(t, k), .u = lane(u, k), .v = lane(v, k), .instance = instance[k]};
    (h.instance == kNone ? h.lamp : h.triangle) = index[k];
    return h;
  }
};

// Surface points, one a lane, as far as shading goes on side by side.
struct LanePoints {
  LaneVec position{};
  Floats offset = 0.0f;
  ShadingPoint<Floats> shading{};
  Floats opacity = 1.0f;
  LaneMask smooth{false}, emits{false}, mayPass{false};
  const SurfaceData* surface[kLanes];
  std::uint32_t objectId[kLanes];
  std::uint16_t lightGroup[kLanes];

  // Safe starts for rays towards d.
  LaneVec originTowards(const LaneVec& d) const {
    return position + shading.ng * select(dot(d, shading.ng) >= 0.0f, offset, -offset);
  }
  // See terminator().
  Floats terminatorFor(const LaneVec& wi) const {
    if (!any(smooth)) return 1.0f;
    return select(smooth, terminator(shading.ng, shading.ns, wi), Floats(1.0f));
  }
};

}  // namespace idap::render
