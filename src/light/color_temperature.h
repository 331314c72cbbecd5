// The colour of lamps and daylight by their temperature.
#pragma once

#include "light/rgb.h"

namespace idap {

// Linear RGB of luminance 1: a black body up to 4000 K, CIE daylight from 5000 K on, and between them a blend
// as colour rendering is judged by (ANSI/IES TM-30) @cite tm30 @cite cie15. kelvin is held to 1000 .. 25000.
Rgb rgbFromTemperature(double kelvin);

}  // namespace idap
