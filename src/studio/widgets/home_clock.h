// The clocks at the home's place.
#pragma once

#include <string>

#include "light/civil_time.h"
#include "model/home.h"

namespace idap {

inline std::string zoneOf(const Home& home) {
  return isTimeZone(home.site.timeZone) ? home.site.timeZone : std::string("UTC");
}

}  // namespace idap
