// From the light of Sweet Home 3D's lamps, a power of 0..1 and a colour for each bulb, to lumens and hue.
#pragma once

#include <optional>
#include <vector>

#include "model/lamp.h"

namespace idap {

struct Sh3dLightSource {
  Vec3 position;                   // fractions of the piece's size, as in LightSource
  Color color;                     // carries both hue and level: dark grey is a weak white bulb
  std::optional<double> diameter;  // m
};

// Sweet Home 3D's photographs give each bulb a flux in proportion to power^2 and, linearly, to its colour's
// channels. Lumens are that times 6000: a white bulb gives 6000 lm at power 1, 1500 lm at the usual power of
// 0.5; the common lamp colour 998764 then gives 800 lm, an ordinary household bulb. The level of a colour is
// its Rec. 709 luminance without decoding. The hue is the colour brought to full brightness.
Lamp lampOf(double power, const std::vector<Sh3dLightSource>& sources);

}  // namespace idap
