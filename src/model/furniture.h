// A piece of furniture, perhaps a lamp, perhaps a staircase; and groups of pieces.
#pragma once

#include <optional>
#include <string>

#include "model/lamp.h"
#include "model/piece.h"

namespace idap {

struct Furniture : Piece {
  std::optional<Lamp> lamp;
  std::string staircaseCutOut;  // SVG path in the unit square of the footprint (y from the back to the
                                // front): the hole it needs in the floor above; empty: none
  std::optional<double> dropOnTopHeight;  // m above the base where things put on it stand; none: its top
  friend bool operator==(const Furniture&, const Furniture&) = default;
};

struct Group {
  GroupId parent;  // none: a group of its own
  std::string name;
  bool visible = true;
  friend bool operator==(const Group&, const Group&) = default;
};

}  // namespace idap
