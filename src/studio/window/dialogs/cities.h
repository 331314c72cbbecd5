// Towns to choose the place of a home from.
#pragma once

#include <vector>

namespace idap {

struct City {
  const char* name;            // marked for translation in the context "cities"
  double latitude, longitude;  // degrees, north and east positive
  const char* timeZone;        // IANA
};
const std::vector<City>& cities();  // by name

}  // namespace idap
