// The fifteen standard skies of ISO 15469 (CIE S 011) and the older overcast sky: luminance of a direction
// relative to the zenith's. @cite iso15469
#pragma once

#include "geometry/vec.h"

namespace idap {

// 1 to 15 as the standard numbers them: 1 overcast, steep; 5 even; 12 clear; 16 the traditional overcast sky
// of Moon and Spencer, (1 + 2 sin elevation) / 3.
struct CieSky {
  int type = 16;
};

// direction, sun: unit, z up. 0 below the horizon. Throws Error for an unknown type.
double relativeLuminance(CieSky sky, Vec3 direction, Vec3 sun);

// Lux on the ground for a zenith of 1 cd/m2: 7 pi / 9 for the traditional overcast sky. Numerical.
double horizontalIlluminance(CieSky sky, Vec3 sun);

}  // namespace idap
