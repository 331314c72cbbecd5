#include "model/edits/lamp_edits.h"

#include <algorithm>
#include <cmath>

namespace idap {

Home withLampsChanged(const Home& home, const std::vector<LampChange>& changes) {
  Home next = home;
  for (const LampChange& change : changes) {
    const Furniture* old = next.furniture.find(change.lamp);
    if (!old || !old->lamp || !std::isfinite(change.strength)) continue;
    Furniture piece = *old;
    Lamp& lamp = *piece.lamp;
    if (change.strength <= 0) {
      lamp.on = false;
    } else {
      const double dimmer = lamp.dimmer * change.strength;
      lamp.on = true;
      lamp.dimmer = std::min(dimmer, 1.0);
      lamp.lumens *= std::max(dimmer, 1.0);
    }
    if (change.kelvin) {
      lamp.colorTemperature = std::clamp(*change.kelvin, 1000.0, 25'000.0);
      lamp.color.reset();
      for (LightSource& source : lamp.sources) source.color.reset();
    }
    if (!(piece == *old)) next.furniture.set(change.lamp, piece);
  }
  return next;
}

}  // namespace idap
