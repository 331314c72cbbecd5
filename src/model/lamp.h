// The light of a lamp: how much, of what colour, from where in the fixture, in what beam.
#pragma once

#include <optional>
#include <vector>

#include "geometry/vec.h"
#include "model/finish.h"

namespace idap {

struct LightSource {
  Vec3 position{
      0.5, 0.5,
      0.5};  // fractions of the piece's size: x from its left, y from its front to its back, z from its base
  double diameter = 0;         // m; 0: a bulb of ordinary size
  std::optional<Color> color;  // of this source; none: the lamp's
  double share = 1;            // weight of this source in the lamp's lumens
  friend bool operator==(const LightSource&, const LightSource&) = default;
};

struct Lamp {
  double lumens = 806;             // of all its sources together, when switched on at full
  double colorTemperature = 2700;  // K, used when color is absent
  std::optional<Color> color;
  double beamAngle = 0;  // radians, full angle at half intensity, pointing down; 0: all around
  bool on = true;
  double dimmer = 1;                 // 0..1
  std::vector<LightSource> sources;  // none: the model's own, or the centre of the piece
  friend bool operator==(const Lamp&, const Lamp&) = default;
};

}  // namespace idap
