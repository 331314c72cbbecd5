// The light of one lamp by direction.
#pragma once

#include "render/scene.h"

namespace idap::render {

// The exponent n of a spot whose intensity falls as cos^n of the angle to its axis, half of it being left at
// the edge of the beam; 0 for a lamp that shines all around.
float spotExponent(const Lamp& lamp);

// cd, in a direction away from the lamp (unit).
Rgb lampIntensity(const Lamp& lamp, Vec3f direction);

// The share of its intensity along the axis that goes in a direction away from the lamp (unit).
float lampFallOff(const Lamp& lamp, Vec3f direction);

// lm, everything the lamp sends out.
Rgb lampFlux(const Lamp& lamp);

}  // namespace idap::render
