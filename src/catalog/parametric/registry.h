// The generators of built-in furniture by name: each fills a Builder's box as its parameters say. A new piece
// is a JSON entry in share/catalog that names a generator; a new generator is a function and a line in its
// category's add function.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "catalog/parametric/kit.h"

namespace idap::parametric {

// What a piece's JSON says of its shape, with the values a user changed.
class Parameters {
 public:
  std::map<std::string, double> numbers;
  std::map<std::string, std::string> texts;
  std::vector<Vec2> outline;  // of solids, in fractions of their box

  double number(const std::string& name, double fallback) const {
    const auto it = numbers.find(name);
    return it == numbers.end() ? fallback : it->second;
  }
  // Rounded to a whole number.
  int count(const std::string& name, int fallback) const;
  bool flag(const std::string& name, bool fallback = false) const {
    return number(name, fallback ? 1 : 0) != 0;
  }
  std::string text(const std::string& name, const std::string& fallback = {}) const {
    const auto it = texts.find(name);
    return it == texts.end() ? fallback : it->second;
  }
};

// How many equal parts of about that size fit: at least one.
int fitting(double length, double each, int most = 64);

using Generator = void (*)(Builder&, const Parameters&);
using Generators = std::map<std::string, Generator>;

// All of them; built once.
const Generators& generators();

// One a category file: adds its generators.
void addChairs(Generators& to);
void addTables(Generators& to);
void addSofas(Generators& to);
void addBeds(Generators& to);
void addLights(Generators& to);
void addPlants(Generators& to);
void addCabinets(Generators& to);

void addDoors(Generators& to);
void addWindows(Generators& to);
void addBookshelves(Generators& to);
void addKitchen(Generators& to);
void addBathroom(Generators& to);
void addVanities(Generators& to);
void addAppliances(Generators& to);
void addStairs(Generators& to);
void addDecor(Generators& to);
void addSolids(Generators& to);
}  // namespace idap::parametric
