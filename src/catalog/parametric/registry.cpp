#include "catalog/parametric/registry.h"

#include <algorithm>
#include <cmath>

namespace idap::parametric {

int Parameters::count(const std::string& name, int fallback) const {
  return static_cast<int>(std::lround(number(name, fallback)));
}

int fitting(double length, double each, int most) {
  return std::clamp(static_cast<int>(std::lround(length / each)), 1, most);
}

const Generators& generators() {
  static const Generators all = [] {
    Generators g;
    addChairs(g);
    addTables(g);
    addSofas(g);
    addBeds(g);
    addLights(g);
    addPlants(g);
    addCabinets(g);
    addDoors(g);
    addWindows(g);
    addBookshelves(g);
    addKitchen(g);
    addBathroom(g);
    addVanities(g);
    addAppliances(g);
    addStairs(g);
    addDecor(g);
    addSolids(g);
    return g;
  }();
  return all;
}

}  // namespace idap::parametric
