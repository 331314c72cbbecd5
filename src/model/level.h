// A storey. Elements on it give heights relative to its elevation (the top of its floor slab).
#pragma once

#include <string>

namespace idap {

struct Level {
  std::string name;
  double elevation = 0;          // m, top of the floor
  double floorThickness = 0.12;  // m, the slab below
  double height = 2.5;           // m, floor to ceiling
  int order = 0;                 // among levels of the same elevation, from below
  bool visible = true;
  bool viewable = true;
  friend bool operator==(const Level&, const Level&) = default;
};

}  // namespace idap
