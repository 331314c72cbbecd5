// How the user likes to work: kept between sessions by the studio, read by tools.
#pragma once

#include <string>

#include "base/units.h"

namespace idap {

struct EditorSettings {
  LengthUnit unit = LengthUnit::Centimetre;
  std::string language = "en";  // of names taken from the catalog
  bool snapping = true;         // to ends, lines, angles, walls, pieces
  bool gridSnapping = false;    // to the grid as well
  bool gridShown = true;
  bool rulersShown = true;
  bool baseLocked = false;      // walls, rooms, openings, dimensions and labels cannot be selected
  bool levelBelowShown = true;  // faintly, under the current one
  double wallThickness = 0.1;   // m, of new walls
  double wallHeight = 0;        // m, of new walls; 0: the home's
  std::string wallPattern;      // of new walls
  bool roomAreas = true;        // rooms that walls close get their room by themselves
  friend bool operator==(const EditorSettings&, const EditorSettings&) = default;
};

}  // namespace idap
