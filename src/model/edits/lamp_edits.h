// Lamps changed by what was found in a picture: dimmed, recoloured, switched.
#pragma once

#include <optional>
#include <vector>

#include "model/home.h"

namespace idap {

struct LampChange {
  FurnitureId lamp;
  double strength = 1;           // of what it gives now; 0: switched off
  std::optional<double> kelvin;  // a new colour temperature; none: as it is
};

// What is no lamp (any more) is passed over. Brighter than a lamp's own power makes it a stronger lamp.
Home withLampsChanged(const Home& home, const std::vector<LampChange>& changes);

}  // namespace idap
