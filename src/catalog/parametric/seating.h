// What chairs and sofas have in common. Internal to the generators.
#pragma once

#include "catalog/parametric/kit.h"

namespace idap::parametric {

// A solid seat over an outline, its top hollowed by dish in the middle.
void dishedSeat(Builder& b, const Polygon& outline, double top, double thickness, double dish);

// An upholstered part that leans: made upright in the box, turned about the x axis at its foot by angle
// (positive: its top goes back).
void leaningCushion(Builder& b, Vec3 min, Vec3 max, double angle, const Soft& soft, bool piped);

}  // namespace idap::parametric
