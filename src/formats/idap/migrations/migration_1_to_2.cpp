// Version 1 knew walls of one height, and lamps by the power of an incandescent bulb.
#include <nlohmann/json.hpp>

#include "formats/idap/migrations/migrations.h"

namespace idap::idap_format {

namespace {

using nlohmann::json;

// A 60 W incandescent bulb gives 806 lm (the ENERGY STAR table of equivalents).
constexpr double kLumensPerWatt = 806.0 / 60;

template <class F>
void forEachObject(json& home, const char* list, F&& f) {
  const auto found = home.find(list);
  if (found == home.end() || !found->is_array()) return;
  for (json& element : *found)
    if (element.is_object()) f(element);
}

}  // namespace

void migrate1To2(json& home) {
  forEachObject(home, "walls", [](json& wall) {
    const auto height = wall.find("height");
    if (height == wall.end()) return;
    const json value = *height;
    wall.erase(height);
    wall["heightAtStart"] = value;
    wall["heightAtEnd"] = value;
  });
  forEachObject(home, "furniture", [](json& piece) {
    const auto lamp = piece.find("lamp");
    if (lamp == piece.end() || !lamp->is_object()) return;
    const auto watts = lamp->find("watts");
    if (watts == lamp->end()) return;
    const json value = *watts;
    lamp->erase(watts);
    (*lamp)["lumens"] = value.is_number() ? json(value.get<double>() * kLumensPerWatt) : value;
  });
}

}  // namespace idap::idap_format
